// SPDX-License-Identifier: Apache-2.0
#include "core/scene/bpt_file.h"

#include <fmt/format.h>

#include <array>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "core/geometry/bezier_check.h"
#include "core/scene/text_lines.h"

namespace burin::scene {
namespace {

using geometry::BezierPatch;
using geometry::BezierPatches;
using geometry::ControlNet;
using geometry::PatchDomain;

std::unexpected<Error> Bad(std::string message) { return Fail(ErrorKind::kInput, std::move(message)); }

/// The words of a file, whatever lines they stand on.
class Words {
 public:
  explicit Words(std::string_view text) : lines_(text) { Next(); }

  /// The word at hand; empty at the end.
  [[nodiscard]] std::string_view word() const { return word_; }
  [[nodiscard]] int line() const { return lines_.number(); }
  [[nodiscard]] int line_before() const { return line_before_; }  ///< of the word before
  void Next() {
    line_before_ = lines_.number();
    while (true) {
      word_ = TakeWord(line_);
      if (!word_.empty() && word_.front() != '#') return;
      const std::optional<std::string_view> line = lines_.Next();
      if (!line) {
        word_ = {};
        return;
      }
      line_ = *line;
    }
  }
  /// Steps over the word if it is this one.
  [[nodiscard]] bool Take(std::string_view expected) {
    const bool is_there = word_ == expected;
    if (is_there) Next();
    return is_there;
  }

 private:
  TextLines lines_;
  std::string_view line_, word_;
  int line_before_ = 0;
};

class PatchReader {
 public:
  PatchReader(Words& words, BezierPatches& patches)
      : words_(words), patches_(patches), number_(patches.patches.size() + 1) {}

  Result<void> Read();

 private:
  using Degrees = std::array<int, 2>;

  Result<int> ReadDegree(std::string_view direction, int least, int most);
  Result<Degrees> ReadDegrees(int least, int most);
  Result<void> ReadPositions();
  Result<void> ReadAttributes();
  template <class Value>
  Result<void> ReadNet(std::string_view what, ControlNet& net, std::vector<Value>& values);
  template <class Value>
  Result<void> ReadValues(std::string_view what, const Degrees& degrees, ControlNet& net, std::vector<Value>& values);
  template <class Value>
  Result<void> ReadValue(std::string_view what, std::uint32_t point, std::uint32_t count, Value& value);
  Result<void> MakeHomogeneous(std::uint32_t point, glm::vec4& value);
  [[nodiscard]] std::string PlaceAt(int line) const { return fmt::format("line {}: patch {}", line, number_); }
  [[nodiscard]] std::string Place() const { return PlaceAt(words_.line()); }

  Words& words_;
  BezierPatches& patches_;
  std::size_t number_;  ///< from 1
  BezierPatch patch_;
};

Result<int> PatchReader::ReadDegree(std::string_view direction, int least, int most) {
  const std::string_view word = words_.word();
  if (word.empty()) return Bad(fmt::format("ends before the degree{} of patch {}", direction, number_));
  const std::optional<int> degree = ParseWhole(word);
  if (!degree || *degree < least || *degree > most) {
    return Bad(fmt::format("{}: found {} as the degree{}, expected {} to {}{}", Place(), Found(word), direction, least,
                           most, patch_.is_rational ? " for a rational patch" : ""));
  }
  words_.Next();
  return *degree;
}

Result<PatchReader::Degrees> PatchReader::ReadDegrees(int least, int most) {
  const bool is_triangle = patch_.domain == PatchDomain::kTriangle;
  const Result<int> u = ReadDegree(is_triangle ? "" : " in u", least, most);
  if (!u) return std::unexpected(u.error());
  const Result<int> v = is_triangle ? u : ReadDegree(" in v", least, most);
  if (!v) return std::unexpected(v.error());
  return Degrees{*u, *v};
}

template <class Value>
Result<void> PatchReader::ReadValue(std::string_view what, std::uint32_t point, std::uint32_t count, Value& value) {
  for (int c = 0; c < Value::length(); ++c) {
    const std::string_view word = words_.word();
    if (word.empty()) return Bad(fmt::format("ends in patch {}, {}point {} of {}", number_, what, point, count));
    const std::optional<float> number = ParseFinite(word);
    if (!number) {
      return Bad(fmt::format("{}, {}point {}: found {}, expected a finite number", Place(), what, point, Found(word)));
    }
    value[c] = *number + 0.0f;  // no -0: shared boundaries are compared by bits
    words_.Next();
  }
  return {};
}

/// `value`: x, y, z and the weight.
Result<void> PatchReader::MakeHomogeneous(std::uint32_t point, glm::vec4& value) {
  const float weight = value.w;
  if (!(weight > 0.0f)) {
    return Bad(fmt::format("{}, point {}: the weight is {}, expected more than 0", PlaceAt(words_.line_before()), point,
                           weight));
  }
  value = glm::vec4(glm::vec3(value) * weight, weight);
  if (glm::any(glm::isinf(value))) {
    return Bad(fmt::format("{}, point {}: its product with the weight {} is too large", PlaceAt(words_.line_before()),
                           point, weight));
  }
  return {};
}

template <class Value>
Result<void> PatchReader::ReadValues(std::string_view what, const Degrees& degrees, ControlNet& net,
                                     std::vector<Value>& values) {
  net = {.first = static_cast<std::uint32_t>(values.size()),
         .u_order = static_cast<std::uint8_t>(degrees[0] + 1),
         .v_order = static_cast<std::uint8_t>(degrees[1] + 1)};
  const std::uint32_t count = ValueCount(patch_.domain, net);
  values.resize(values.size() + count, Value(1.0f));
  std::uint32_t point = 0;
  for (std::uint32_t i = 0; i < net.u_order; ++i) {
    const std::uint32_t in_column = patch_.domain == PatchDomain::kTriangle ? net.u_order - i : net.v_order;
    for (std::uint32_t j = 0; j < in_column; ++j) {
      Value& value = values[net.first + ValueIndex(patch_.domain, net, i, j)];
      if (Result<void> read = ReadValue(what, ++point, count, value); !read) return read;
      if constexpr (std::is_same_v<Value, glm::vec4>) {
        if (&values != &patches_.positions) continue;
        if (Result<void> weighted = MakeHomogeneous(point, value); !weighted) return weighted;
      }
    }
  }
  return {};
}

template <class Value>
Result<void> PatchReader::ReadNet(std::string_view what, ControlNet& net, std::vector<Value>& values) {
  if (net) return Bad(fmt::format("{}: has {} twice", Place(), what));
  words_.Next();
  const Result<Degrees> degrees = ReadDegrees(0, geometry::kMaxBezierOrder - 1);
  if (!degrees) return std::unexpected(degrees.error());
  return ReadValues(fmt::format("{} ", what), *degrees, net, values);
}

Result<void> PatchReader::ReadPositions() {
  const int most = (patch_.is_rational ? geometry::kMaxRationalOrder : geometry::kMaxBezierOrder) - 1;
  const Result<Degrees> degrees = ReadDegrees(1, most);
  if (!degrees) return std::unexpected(degrees.error());
  if (patch_.is_rational) return ReadValues("", *degrees, patch_.position, patches_.positions);
  std::vector<glm::vec3> points;
  ControlNet net;
  if (auto read = ReadValues("", *degrees, net, points); !read) return read;
  patch_.position = net;
  patch_.position.first = static_cast<std::uint32_t>(patches_.positions.size());
  for (const glm::vec3& point : points) patches_.positions.emplace_back(point, 1.0f);
  return {};
}

Result<void> PatchReader::ReadAttributes() {
  while (true) {
    const std::string_view word = words_.word();
    Result<void> read;
    if (word == "normals") {
      read = ReadNet(word, patch_.normal, patches_.normals);
    } else if (word == "texcoords") {
      read = ReadNet(word, patch_.texcoord[0], patches_.texcoords[0]);
    } else if (word == "texcoords2") {
      read = ReadNet(word, patch_.texcoord[1], patches_.texcoords[1]);
    } else if (word == "colors") {
      read = ReadNet(word, patch_.color, patches_.colors);
    } else {
      return {};
    }
    if (!read) return read;
  }
}

Result<void> PatchReader::Read() {
  if (words_.word().empty()) return Bad(fmt::format("ends before patch {}", number_));
  if (words_.Take("triangle")) patch_.domain = PatchDomain::kTriangle;
  if (words_.Take("rational")) patch_.is_rational = true;
  if (words_.Take("triangle")) patch_.domain = PatchDomain::kTriangle;
  if (Result<void> read = ReadPositions(); !read) return read;
  if (Result<void> read = ReadAttributes(); !read) return read;
  patch_.face = static_cast<std::uint32_t>(number_ - 1);
  patches_.patches.push_back(patch_);
  return {};
}

}  // namespace

Result<BezierPatches> ParseBpt(std::string_view text) {
  Words words(text);
  const std::optional<int> count = ParseWhole(words.word());
  if (!count || *count < 1) {
    return Bad(fmt::format("line {}: found {}, expected the number of patches", words.line(), Found(words.word())));
  }
  words.Next();
  BezierPatches patches;
  for (int number = 1; number <= *count; ++number) {
    if (Result<void> read = PatchReader(words, patches).Read(); !read) {
      if (read.error().message.starts_with("ends"))
        read.error().message += fmt::format("; expected {} patch{}", *count, *count == 1 ? "" : "es");
      return std::unexpected(read.error());
    }
  }
  if (!words.word().empty()) {
    return Bad(fmt::format("line {}: found {} after the last of {} patch{}, expected the end", words.line(),
                           Found(words.word()), *count, *count == 1 ? "" : "es"));
  }
  return patches;
}

}  // namespace burin::scene

// SPDX-License-Identifier: Apache-2.0
#include "core/scene/obj_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/scene/text_lines.h"

namespace burin::scene {
namespace {

class ObjParser {
 public:
  explicit ObjParser(std::string_view text) : lines_(text) {}

  Result<ObjFile> Parse() {
    while (const std::optional<std::string> line = NextLine()) {
      std::string_view rest = *line;
      rest = rest.substr(0, rest.find('#'));
      const std::string_view keyword = TakeWord(rest);
      if (keyword.empty()) continue;
      if (Result<void> done = Statement(keyword, rest); !done) return std::unexpected(done.error());
    }
    if (!file_.colors.empty()) file_.colors.resize(file_.positions.size(), glm::vec3(1.0f));
    return std::move(file_);
  }

 private:
  std::unexpected<Error> Bad(const std::string& message) const {
    return Fail(ErrorKind::kInput, fmt::format("line {}: {}", line_, message));
  }

  /// A line with those that a '\' at its end joins to it.
  std::optional<std::string> NextLine() {
    std::optional<std::string_view> line = lines_.Next();
    if (!line) return std::nullopt;
    line_ = lines_.number();
    std::string joined(*line);
    while (joined.ends_with('\\')) {
      joined.back() = ' ';
      line = lines_.Next();
      if (!line) break;
      joined += *line;
    }
    return joined;
  }

  Result<void> Statement(std::string_view keyword, std::string_view rest) {
    if (keyword == "v") return Vertex(rest);
    if (keyword == "vt") return Texcoord(rest);
    if (keyword == "vn") return Normal(rest);
    if (keyword == "f") return Polygon(ObjElement::kFace, rest);
    if (keyword == "l") return Polygon(ObjElement::kLine, rest);
    if (keyword == "p") return Polygon(ObjElement::kPoint, rest);
    if (keyword == "o") return Object(rest);
    if (keyword == "usemtl") return Material(rest);
    if (keyword == "mtllib") return Library(rest);
    if (keyword == "s") return Smoothing(rest);
    if (keyword == "t") return Tag(rest);
    static constexpr std::string_view kFreeForm[] = {"vp", "cstype", "curv", "curv2", "surf"};
    if (std::ranges::find(kFreeForm, keyword) != std::end(kFreeForm) && warned_.insert(std::string(keyword)).second) {
      file_.warnings.push_back(fmt::format("line {}: {}: free-form curves and surfaces are left out", line_, keyword));
    }
    return {};
  }

  Result<float> Number(std::string_view what, std::string_view word) const {
    const std::optional<float> value = ParseFinite(word);
    if (!value) return Bad(fmt::format("{}: found {}, expected a finite number", what, Found(word)));
    return *value + 0.0f;  // no -0: shared points are compared by bits
  }

  Result<std::vector<float>> Numbers(std::string_view what, std::string_view rest, std::size_t least) const {
    std::vector<float> numbers;
    for (std::string_view word = TakeWord(rest); !word.empty() || numbers.size() < least; word = TakeWord(rest)) {
      const Result<float> number = Number(what, word);
      if (!number) return std::unexpected(number.error());
      numbers.push_back(*number);
    }
    return numbers;
  }

  Result<void> Vertex(std::string_view rest) {
    const auto n = Numbers("v", rest, 3);
    if (!n) return std::unexpected(n.error());
    file_.positions.emplace_back((*n)[0], (*n)[1], (*n)[2]);
    if (n->size() == 4 && (*n)[3] != 1.0f) return Bad("v: rational weights have no meaning for polygons, expected 1");
    if (n->size() >= 6) {
      const std::size_t at = n->size() - 3;  // after x y z, or x y z w
      file_.colors.resize(file_.positions.size(), glm::vec3(1.0f));
      file_.colors.back() = {(*n)[at], (*n)[at + 1], (*n)[at + 2]};
    }
    return {};
  }

  Result<void> Texcoord(std::string_view rest) {
    const auto n = Numbers("vt", rest, 1);
    if (!n) return std::unexpected(n.error());
    file_.texcoords.emplace_back((*n)[0], n->size() > 1 ? (*n)[1] : 0.0f);
    return {};
  }

  Result<void> Normal(std::string_view rest) {
    const auto n = Numbers("vn", rest, 3);
    if (!n) return std::unexpected(n.error());
    file_.normals.emplace_back((*n)[0], (*n)[1], (*n)[2]);
    return {};
  }

  /// Counted from 1, or from the last one backwards.
  Result<std::uint32_t> Index(std::string_view what, std::string_view word, std::size_t count) const {
    const std::optional<int> index = ParseWhole(word);
    const auto there = static_cast<long>(count);
    if (!index || *index == 0) return Bad(fmt::format("{}: found {}, expected an index", what, Found(word)));
    const long from_zero = *index > 0 ? *index - 1L : there + *index;
    if (from_zero < 0 || from_zero >= there) {
      return Bad(
          fmt::format("{}: index {}, but {} {} so far", what, *index, count == 1 ? "there is" : "there are", count));
    }
    return static_cast<std::uint32_t>(from_zero);
  }

  Result<ObjCorner> Corner(std::string_view keyword, std::string_view word) const {
    ObjCorner corner;
    const std::size_t slash = word.find('/');
    auto index = Index(fmt::format("{}: vertex", keyword), word.substr(0, slash), file_.positions.size());
    if (!index) return std::unexpected(index.error());
    corner.position = *index;
    if (slash == std::string_view::npos) return corner;
    const std::string_view rest = word.substr(slash + 1);
    const std::size_t second = rest.find('/');
    if (const std::string_view texcoord = rest.substr(0, second); !texcoord.empty()) {
      index = Index(fmt::format("{}: texture coordinate", keyword), texcoord, file_.texcoords.size());
      if (!index) return std::unexpected(index.error());
      corner.texcoord = *index;
    }
    if (second != std::string_view::npos && second + 1 < rest.size()) {
      index = Index(fmt::format("{}: normal", keyword), rest.substr(second + 1), file_.normals.size());
      if (!index) return std::unexpected(index.error());
      corner.normal = *index;
    }
    return corner;
  }

  Result<void> Polygon(ObjElement element, std::string_view rest) {
    const std::string_view keyword = element == ObjElement::kFace ? "f" : element == ObjElement::kLine ? "l" : "p";
    if (file_.objects.empty()) file_.objects.emplace_back();
    ObjPolygon polygon{.element = element,
                       .first_corner = static_cast<std::uint32_t>(file_.corners.size()),
                       .corners = 0,
                       .object = static_cast<std::uint32_t>(file_.objects.size() - 1),
                       .material = material_,
                       .smoothing_group = smoothing_group_};
    for (std::string_view word = TakeWord(rest); !word.empty(); word = TakeWord(rest)) {
      const Result<ObjCorner> corner = Corner(keyword, word);
      if (!corner) return std::unexpected(corner.error());
      file_.corners.push_back(*corner);
      ++polygon.corners;
    }
    const std::uint32_t least = element == ObjElement::kFace ? 3 : element == ObjElement::kLine ? 2 : 1;
    if (polygon.corners < least) {
      return Bad(fmt::format("{}: found {} {}, expected at least {}", keyword, polygon.corners,
                             polygon.corners == 1 ? "corner" : "corners", least));
    }
    file_.polygons.push_back(polygon);
    return {};
  }

  static std::string Name(std::string_view rest) {
    std::string name;
    for (std::string_view word = TakeWord(rest); !word.empty(); word = TakeWord(rest)) {
      if (!name.empty()) name += ' ';
      name += word;
    }
    return name;
  }

  Result<void> Object(std::string_view rest) {
    file_.objects.push_back(Name(rest));
    return {};
  }

  Result<void> Material(std::string_view rest) {
    const std::string name = Name(rest);
    if (name.empty()) return Bad("usemtl: found nothing, expected a name");
    const auto found = std::ranges::find(file_.materials, name);
    material_ = static_cast<std::uint32_t>(found - file_.materials.begin());
    if (found == file_.materials.end()) file_.materials.push_back(name);
    return {};
  }

  Result<void> Library(std::string_view rest) {
    const std::string name = Name(rest);
    if (name.empty()) return Bad("mtllib: found nothing, expected a file name");
    file_.libraries.push_back(name);
    return {};
  }

  Result<void> Smoothing(std::string_view rest) {
    const std::string_view word = TakeWord(rest);
    const std::optional<int> group = word == "off" ? std::optional(0) : ParseWhole(word);
    if (!group || *group < 0) return Bad(fmt::format("s: found {}, expected a group's number or off", Found(word)));
    smoothing_group_ = static_cast<std::uint32_t>(*group);
    return {};
  }

  /// "t crease 2/1/0 v0 v1 sharpness", "t corner 1/1/0 v sharpness": vertices from 0. Other tags are left out.
  Result<void> Tag(std::string_view rest) {
    const std::string_view name = TakeWord(rest);
    if (name != "crease" && name != "corner") return {};
    const std::size_t vertices = name == "crease" ? 2 : 1;
    (void)TakeWord(rest);
    std::array<std::uint32_t, 2> positions{};
    for (std::size_t i = 0; i < vertices; ++i) {
      const std::string_view word = TakeWord(rest);
      const std::optional<int> index = ParseWhole(word);
      if (!index || *index < 0 || static_cast<std::size_t>(*index) >= file_.positions.size()) {
        return Bad(
            fmt::format("t {}: found {}, expected a vertex below {}", name, Found(word), file_.positions.size()));
      }
      positions[i] = static_cast<std::uint32_t>(*index);
    }
    const Result<float> sharpness = Number(fmt::format("t {}", name), TakeWord(rest));
    if (!sharpness) return std::unexpected(sharpness.error());
    if (vertices == 2) file_.creases.push_back({positions, *sharpness});
    if (vertices == 1) file_.sharp_vertices.push_back({positions[0], *sharpness});
    return {};
  }

  TextLines lines_;
  ObjFile file_;
  int line_ = 0;
  std::uint32_t material_ = kNoIndex;
  std::uint32_t smoothing_group_ = 0;
  std::set<std::string> warned_;
};

}  // namespace

Result<ObjFile> ParseObj(std::string_view text) { return ObjParser(text).Parse(); }

}  // namespace burin::scene

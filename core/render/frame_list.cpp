// SPDX-License-Identifier: Apache-2.0
#include "core/render/frame_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

namespace burin::render {
namespace {

/// Frame numbers stay printable in names and far from overflow.
constexpr long kMaxFrameNumber = 999'999'999;

class Reader {
 public:
  explicit Reader(std::string_view text) : rest_(text) {}

  [[nodiscard]] bool AtEnd() const { return rest_.empty(); }

  bool Take(std::string_view token) {
    if (!rest_.starts_with(token)) return false;
    rest_.remove_prefix(token.size());
    return true;
  }

  /// An optionally negative number; nothing is taken when there is none.
  std::optional<long> TakeNumber() {
    long value = 0;
    const char* const end = rest_.data() + rest_.size();
    const auto [after, status] = std::from_chars(rest_.data(), end, value);
    if (status != std::errc() || value > kMaxFrameNumber || value < -kMaxFrameNumber) return std::nullopt;
    rest_.remove_prefix(static_cast<std::size_t>(after - rest_.data()));
    return value;
  }

 private:
  std::string_view rest_;
};

std::string_view Trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

std::unexpected<Error> Malformed(std::string_view list, std::string_view item, std::string_view hint) {
  return Fail(ErrorKind::kUsage, list == item ? fmt::format("--frames {}: {}", list, hint)
                                              : fmt::format("--frames {}: in '{}': {}", list, item, hint));
}

struct Range {
  long first = 0;
  long last = 0;
  long step = 1;
};

Result<Range> ParseItem(std::string_view list, std::string_view item) {
  static constexpr std::string_view kForms = "expected a frame (7), a range (1-10) or a range with a step (1-10x2)";
  if (item.empty()) return Malformed(list, item, "an empty item; expected a frame or a range between the commas");
  Reader reader(item);
  const std::optional<long> first = reader.TakeNumber();
  if (!first) return Malformed(list, item, kForms);
  if (reader.AtEnd()) return Range{*first, *first, 1};
  if (reader.Take(":")) {
    const std::optional<long> last = reader.TakeNumber();
    if (last && reader.AtEnd()) {
      return Malformed(list, item,
                       fmt::format("'a:b' is not a range; write {}-{} for all of them, or {}-{}:N for every Nth",
                                   *first, *last, *first, *last));
    }
    return Malformed(list, item, kForms);
  }
  if (!reader.Take("..") && !reader.Take("-")) return Malformed(list, item, kForms);
  const std::optional<long> last = reader.TakeNumber();
  if (!last) return Malformed(list, item, kForms);
  Range range{*first, *last, 1};
  if (!reader.AtEnd()) {
    const bool has_step = reader.Take("x") || reader.Take(":");
    const std::optional<long> step = has_step ? reader.TakeNumber() : std::nullopt;
    if (!step || !reader.AtEnd()) return Malformed(list, item, kForms);
    if (*step < 1) return Malformed(list, item, fmt::format("the step is {}; expected 1 or more", *step));
    range.step = *step;
  }
  if (range.last < range.first) {
    return Malformed(list, item, fmt::format("the range ends before it begins; write {}-{}", range.last, range.first));
  }
  return range;
}

}  // namespace

Result<std::vector<long>> ParseFrameList(std::string_view text) {
  const std::string_view list = Trimmed(text);
  std::vector<long> frames;
  for (std::string_view rest = list;;) {
    const std::size_t comma = rest.find(',');
    const auto range = ParseItem(list, Trimmed(rest.substr(0, comma)));
    if (!range) return std::unexpected(range.error());
    const long count = (range->last - range->first) / range->step + 1;
    if (frames.size() + static_cast<std::size_t>(count) > kMaxFrames) {
      return Fail(ErrorKind::kUsage, fmt::format("--frames {}: more than {} frames", list, kMaxFrames));
    }
    for (long frame = range->first; frame <= range->last; frame += range->step) frames.push_back(frame);
    if (comma == std::string_view::npos) break;
    rest.remove_prefix(comma + 1);
  }
  std::ranges::sort(frames);
  const auto repeated = std::ranges::unique(frames);
  frames.erase(repeated.begin(), repeated.end());
  return frames;
}

std::string FormatFrameList(std::span<const long> frames) {
  std::string text;
  for (std::size_t i = 0; i < frames.size();) {
    std::size_t end = i + 1;
    const long step = end < frames.size() ? frames[end] - frames[i] : 1;
    while (end < frames.size() && frames[end] - frames[end - 1] == step) ++end;
    if (end - i == 2) end = i + 1;  // two frames are no shorter as a range
    if (!text.empty()) text += ',';
    text += fmt::format("{}", frames[i]);
    if (end - i > 1) text += fmt::format("-{}", frames[end - 1]);
    if (end - i > 1 && step != 1) text += fmt::format("x{}", step);
    i = end;
  }
  return text;
}

}  // namespace burin::render

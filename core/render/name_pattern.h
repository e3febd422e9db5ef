// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace burin::render {

/// A file name with at most one place for the frame number: `walk.####.png` (as many digits as there are #),
/// `walk.%04d.png` or `walk.{frame:04}.png`. The place is in the last component of the path.
class NamePattern {
 public:
  /// Errors: kUsage for two places, a place in a folder's name, or more than nine digits.
  [[nodiscard]] static Result<NamePattern> Parse(std::string_view path);

  [[nodiscard]] bool has_token() const { return has_token_; }
  [[nodiscard]] const std::string& text() const { return text_; }
  /// The name of one frame. Numbers with more digits than the place has are written in full.
  [[nodiscard]] std::string Format(long frame) const;
  /// The frame that `path` is the name of; empty when it is none of this pattern's.
  [[nodiscard]] std::optional<long> Match(std::string_view path) const;
  /// The frames on disk, ascending. Errors: kInput when the folder cannot be read.
  [[nodiscard]] Result<std::vector<long>> FindFrames() const;

 private:
  std::string text_;  ///< as written
  std::string before_;
  std::string after_;
  int digits_ = 0;
  bool has_token_ = false;
};

}  // namespace burin::render

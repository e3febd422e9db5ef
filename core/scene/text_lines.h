// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace burin::scene {

/// A text file's lines, numbered as editors number them. '\r' ends no line but is dropped from its end.
class TextLines {
 public:
  explicit TextLines(std::string_view text) : rest_(text) {}

  /// The next line, or nothing at the end. The view looks into the text.
  [[nodiscard]] std::optional<std::string_view> Next();
  [[nodiscard]] int number() const { return number_; }  ///< of the last line, from 1

 private:
  std::string_view rest_;
  int number_ = 0;
};

/// Takes the next word, between blanks, off the line; empty at its end.
[[nodiscard]] std::string_view TakeWord(std::string_view& line);

/// A finite number, whole word ("1.5", "+2", "-3e4"); nothing otherwise, also beyond a float's range.
[[nodiscard]] std::optional<float> ParseFinite(std::string_view word);
[[nodiscard]] std::optional<int> ParseWhole(std::string_view word);

/// A whole text file of at most 1 GiB. Messages lack the path.
[[nodiscard]] Result<std::string> ReadText(const std::string& path);

/// "'nan'", or "nothing" for an empty word: what a message says was found. Long words are cut, odd bytes shown as '?'.
[[nodiscard]] std::string Found(std::string_view word);

}  // namespace burin::scene

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace burin::fx {

/// Index of a file in its SourceSet. kNoFile marks a place that no file has (the host's predefined macros).
using FileId = std::uint32_t;
inline constexpr FileId kNoFile = ~FileId{0};

/// A place in a text: line and column from 1, columns counted in bytes after tabs as one. `macro` is one more than the
/// index in SourceSet::expansions of the macro expansion that the token came from, 0 for none; file, line and column
/// are then those of the outermost invocation, which is where a user looks.
struct Location {
  FileId file = kNoFile;
  std::uint32_t line = 0;
  std::uint32_t column = 0;
  std::uint32_t macro = 0;
};

/// From the first character of the first token to the end of the last (exclusive column) on `end_line`.
struct Range {
  Location begin;
  std::uint32_t end_line = 0;
  std::uint32_t end_column = 0;
};

/// Where a macro that was expanded is defined, for "in expansion of macro 'NAME'" notes.
struct MacroExpansion {
  std::string name;
  Location definition;   ///< of the spot in the macro's body that the token came from
  std::uint32_t parent = 0;   ///< the expansion this one stands in, as in Location::macro
};

/// `#line`: from the line after `line` on, messages show `presumed_line` and up, and `path` (empty: the file's own).
struct LineDirective {
  std::uint32_t line = 0;
  std::uint32_t presumed_line = 0;   ///< of the line after the directive
  std::string path;
};

struct SourceFile {
  std::string path;           ///< as messages show it
  std::string text;           ///< normalised: BOM stripped, CRLF to LF
  Location included_from;     ///< of the #include; file == kNoFile for the main file
  std::vector<LineDirective> line_directives;   ///< in order
};

/// Where `line` of a file stands for messages, #line heeded.
struct PresumedLine {
  std::string path;
  std::uint32_t line = 0;
};
[[nodiscard]] PresumedLine Presume(const SourceFile& file, std::uint32_t line);

/// Every text that one compilation read, in the order in which they were opened.
struct SourceSet {
  std::vector<SourceFile> files;
  std::vector<MacroExpansion> expansions;
};

}  // namespace burin::fx

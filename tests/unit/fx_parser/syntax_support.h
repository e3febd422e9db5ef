// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the tests of fx_parser/syntax share: parsing a text, and its messages and tree as plain text to compare with.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "fx_parser/source/file_system.h"
#include "fx_parser/syntax/parse.h"

namespace burin::fx::test {

struct Parsed {
  ast::Module module;
  SourceSet sources;
  Diagnostics diagnostics;

  /// "line:column severity: text [code]" a line each; in other files than the first with the path before it. Notes
  /// follow their message, indented.
  [[nodiscard]] std::string Messages() const;
  /// As the command line prints them.
  [[nodiscard]] std::string Formatted() const;
};

/// Parses the file "main.fx" of `files`.
[[nodiscard]] std::unique_ptr<Parsed> ParseFiles(std::vector<std::pair<std::string, std::string>> files,
                                                 const PreprocessOptions& options = {});
[[nodiscard]] std::unique_ptr<Parsed> ParseText(const std::string& text);

/// The preprocessed tokens, joined by one space; a line break stays where the source has one.
struct Preprocessed {
  std::string text;
  std::string messages;
};
[[nodiscard]] Preprocessed Preprocess(std::vector<std::pair<std::string, std::string>> files,
                                      const PreprocessOptions& options = {});
[[nodiscard]] Preprocessed Preprocess(const std::string& text);

/// Lisp-like: `a + b * c` is (+ a (* b c)).
[[nodiscard]] std::string Dump(const ast::Expression* expression);
[[nodiscard]] std::string Dump(const ast::Statement* statement);
[[nodiscard]] std::string Dump(const ast::Variable& variable);
[[nodiscard]] std::string Dump(const ast::Declaration& declaration);
/// Every declaration on a line of its own.
[[nodiscard]] std::string Dump(const ast::Module& module);

/// The dump of a whole text, or its messages if it has any.
[[nodiscard]] std::string DumpText(const std::string& text);
/// The dump of `text` as the initialiser of a float, or the messages.
[[nodiscard]] std::string DumpExpression(const std::string& text);
/// The dump of `text` as a function's body (what is between the braces), or the messages.
[[nodiscard]] std::string DumpBody(const std::string& text);

}  // namespace burin::fx::test

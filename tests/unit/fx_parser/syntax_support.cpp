// SPDX-License-Identifier: Apache-2.0
#include "tests/unit/fx_parser/syntax_support.h"

#include "fx_parser/syntax/preprocessor.h"

namespace burin::fx::test {

namespace {

constexpr const char* kMain = "main.fx";

InMemoryFileSystem FilesOf(std::vector<std::pair<std::string, std::string>> files) {
  InMemoryFileSystem system;
  for (auto& [path, text] : files) system.files.emplace(path, std::move(text));
  return system;
}

std::string Place(const Location& at, const SourceSet& sources) {
  if (at.file == kNoFile) return "- ";
  const std::string& path = sources.files[at.file].path;
  return (path == kMain ? "" : path + ":") + std::to_string(at.line) + ":" + std::to_string(at.column) + " ";
}

std::string MessagesOf(const Diagnostics& diagnostics, const SourceSet& sources) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    text += Place(diagnostic.range.begin, sources);
    text += diagnostic.severity == Severity::kError ? "error: " : "warning: ";
    text += diagnostic.text + " [" + diagnostic.code + "]\n";
    for (const Note& note : diagnostic.notes) text += "  " + Place(note.range.begin, sources) + note.text + "\n";
  }
  return text;
}

std::string FunctionDump(const ast::Module& module) {
  for (const auto& declaration : module.declarations) {
    if (const auto* function = std::get_if<std::unique_ptr<ast::Function>>(&declaration)) {
      return Dump((*function)->body.get());
    }
  }
  return "no function";
}

}  // namespace

std::string Parsed::Messages() const { return MessagesOf(diagnostics, sources); }

std::string Parsed::Formatted() const {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics.all()) text += FormatDiagnostic(diagnostic, sources);
  return text;
}

std::unique_ptr<Parsed> ParseFiles(std::vector<std::pair<std::string, std::string>> files,
                                   const PreprocessOptions& options) {
  const InMemoryFileSystem system = FilesOf(std::move(files));
  auto parsed = std::make_unique<Parsed>();
  parsed->module = Parse(kMain, system, options, parsed->sources, parsed->diagnostics);
  return parsed;
}

std::unique_ptr<Parsed> ParseText(const std::string& text) { return ParseFiles({{kMain, text}}); }

Preprocessed Preprocess(std::vector<std::pair<std::string, std::string>> files, const PreprocessOptions& options) {
  const InMemoryFileSystem system = FilesOf(std::move(files));
  SourceSet sources;
  Diagnostics diagnostics;
  Preprocessor preprocessor(system, options, sources, diagnostics);
  const TokenStream stream = preprocessor.Run(kMain);
  Preprocessed result;
  for (const Token& token : stream.tokens) {
    if (token.kind == TokenKind::kEnd) break;
    if (!result.text.empty()) result.text += token.starts_line ? '\n' : ' ';
    result.text += token.text;
  }
  result.messages = MessagesOf(diagnostics, sources);
  return result;
}

Preprocessed Preprocess(const std::string& text) { return Preprocess({{kMain, text}}); }

std::string DumpText(const std::string& text) {
  const auto parsed = ParseText(text);
  const std::string messages = parsed->Messages();
  return messages.empty() ? Dump(parsed->module) : messages;
}

std::string DumpExpression(const std::string& text) {
  const auto parsed = ParseText("float x = " + text + ";");
  const std::string messages = parsed->Messages();
  if (!messages.empty()) return messages;
  return Dump(std::get<std::unique_ptr<ast::Variable>>(parsed->module.declarations.at(0))->initializer.get());
}

std::string DumpBody(const std::string& text) {
  const auto parsed = ParseText("void f() {\n" + text + "\n}");
  const std::string messages = parsed->Messages();
  return messages.empty() ? FunctionDump(parsed->module) : messages;
}

}  // namespace burin::fx::test

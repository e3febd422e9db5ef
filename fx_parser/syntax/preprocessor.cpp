// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/syntax/preprocessor.h"

#include <utility>

#include "fx_parser/source/include_resolver.h"
#include "fx_parser/source/source_text.h"

namespace burin::fx {

Preprocessor::Preprocessor(const FileSystem& files, const PreprocessOptions& options, SourceSet& sources,
                           Diagnostics& diagnostics)
    : files_(files),
      options_(options),
      sources_(sources),
      diagnostics_(diagnostics),
      context_(sources, diagnostics, stream_) {}

TokenStream Preprocessor::Run(const std::string& path) {
  DefineBuiltins();
  Token end;
  if (OpenMain(path)) {
    MacroExpander expander(context_, *this);
    for (Token token = expander.Next(); token.kind != TokenKind::kEnd; token = expander.Next()) {
      if (stream_.tokens.size() == kMaxTokens) {
        context_.Stop(token, "the text has more than " + std::to_string(kMaxTokens) + " tokens");
        break;
      }
      stream_.tokens.push_back(token);
      end = token;
    }
    end.begin = inputs_.front().lexer->location();
    end.end_line = end.begin.line;
    end.end_column = end.begin.column;
  }
  if (context_.stopped()) incomplete_ = true;
  end.kind = TokenKind::kEnd;
  end.text = {};
  stream_.tokens.push_back(end);
  return std::move(stream_);
}

void Preprocessor::DefineBuiltins() {
  DefineFromOption("DIRECT3D_VERSION", "0x900");
  DefineFromOption("FXCOMPOSER_VERSION", "180");   // the host that most effects with scripts were written for
  DefineFromOption("BURIN", "1");
  for (const auto& [name, kind] : {std::pair("__FILE__", Macro::Builtin::kFile), {"__LINE__", Macro::Builtin::kLine}}) {
    auto macro = std::make_shared<Macro>();
    macro->name = name;
    macro->builtin = kind;
    context_.macros.Define(std::move(macro));
  }
  for (const auto& [name, value] : options_.definitions) DefineFromOption(name, value.empty() ? "1" : value);
}

bool Preprocessor::OpenMain(const std::string& path) {
  std::expected<std::string, std::string> text = files_.Read(path);
  if (text) text = NormalizeText(*text);
  if (!text) {
    diagnostics_.Error({}, "X1507", "cannot read effect file '" + path + "': " + text.error());
    incomplete_ = true;
    return false;
  }
  Open(path, *text, {});
  return true;
}

void Preprocessor::Open(const std::string& path, const std::string& bytes_as_text, const Location& included_from) {
  const auto file = static_cast<FileId>(sources_.files.size());
  sources_.files.push_back({path, bytes_as_text, included_from, {}});
  const std::string& text = stream_.texts.emplace_back(bytes_as_text);
  bytes_ += text.size();
  Input input;
  input.file = file;
  input.key = PathKey(path);
  input.lexer = std::make_unique<Lexer>(text, file, diagnostics_);
  input.conditionals = conditionals_.size();
  input.included_from = included_from;
  input.macro_version = context_.macros.version();
  inputs_.push_back(std::move(input));
}

// The main file stays open, so that the end of the stream has a place.
bool Preprocessor::CloseInput() {
  while (conditionals_.size() > inputs_.back().conditionals) {
    const Token& directive = conditionals_.back().directive;
    diagnostics_.Error(directive.range(), "B1008", "#" + std::string(directive.text) + " without #endif");
    conditionals_.pop_back();
  }
  if (inputs_.size() == 1) return false;
  inputs_.pop_back();
  return true;
}

Token Preprocessor::Next(bool inside_arguments) {
  while (!context_.stopped() && !incomplete_) {
    const Token& next = lexer().Peek();
    if (next.kind == TokenKind::kHash && next.starts_line) {
      RunDirective();
    } else if (next.kind == TokenKind::kEnd) {
      if (inside_arguments || !CloseInput()) return {};
    } else {
      const Token token = lexer().Next();
      if (live()) return token;
    }
  }
  return {};
}

TokenKind Preprocessor::PeekKind() {
  const Token& next = lexer().Peek();
  return next.kind == TokenKind::kHash && next.starts_line ? TokenKind::kHash : next.kind;
}

}  // namespace burin::fx

// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "fx_parser/syntax/parser.h"

namespace burin::fx {
namespace {

constexpr int kMaxNamespaces = 16;  // inside one another

}  // namespace

ast::Module Parser::ParseModule() {
  ast::Module module;
  while (!Is(TokenKind::kEnd) && !stopped()) ParseTopLevel(module);
  return module;
}

void Parser::ParseTopLevel(ast::Module& module) {
  const std::size_t first = position_;
  abandon_function_ = false;
  bool parsed = false;
  if (Accept(TokenKind::kSemicolon)) {
    return;
  } else if (Is(TokenKind::kRightBrace)) {
    Report(Peek().range(), "'}' without '{'");
    Advance();
    Accept(TokenKind::kSemicolon);
    return;
  } else if (AtTechnique()) {
    std::unique_ptr<ast::Technique> technique = ParseTechnique();
    parsed = technique != nullptr;
    if (technique) module.declarations.emplace_back(std::move(technique));
  } else if (IsWord("typedef")) {
    std::vector<std::unique_ptr<ast::Typedef>> typedefs;
    std::unique_ptr<ast::Struct> structure;
    parsed = ParseTypedef(typedefs, structure);
    if (structure) module.declarations.emplace_back(std::move(structure));
    for (auto& entry : typedefs) module.declarations.emplace_back(std::move(entry));
  } else if ((IsWord("cbuffer") || IsWord("tbuffer")) &&
             (Is(TokenKind::kIdentifier, 1) || Is(TokenKind::kLeftBrace, 1))) {
    parsed = ParseBuffer(module);
  } else if (IsWord("namespace") && Is(TokenKind::kIdentifier, 1)) {
    parsed = ParseNamespace(module);
  } else if (IsWord("interface") && Is(TokenKind::kIdentifier, 1) && Is(TokenKind::kLeftBrace, 2)) {
    std::unique_ptr<ast::Struct> structure = ParseStruct();
    parsed = structure != nullptr;
    if (structure) module.declarations.emplace_back(std::move(structure));
    Accept(TokenKind::kSemicolon);
  } else {
    parsed = ParseGlobal(module);
  }
  if (abandon_function_) return;
  if (!parsed) SkipDeclaration(first);
  if (position_ == first) Advance();  // whatever happens, go forward
}

bool Parser::ParseGlobal(ast::Module& module) {
  std::vector<std::string> attributes;  // of Direct3D 10 and later entry points
  if (Is(TokenKind::kLeftBracket) && !ParseAttributes(attributes)) return false;
  if (!Is(TokenKind::kIdentifier) && !Is(TokenKind::kScope)) {
    ReportUnexpected("a declaration");
    return false;
  }
  if (IsEffectWord("pass") && (Is(TokenKind::kLeftBrace, 1) || Is(TokenKind::kLeftBrace, 2))) {
    Report(Peek().range(), "a pass stands inside a technique");
    return false;
  }
  Specifiers specifiers;
  if (!ParseSpecifiers(specifiers)) return false;
  const bool is_function = Is(TokenKind::kIdentifier) && Is(TokenKind::kLeftParen, 1);
  const bool only_structure = specifiers.structure && (!Is(TokenKind::kIdentifier) || AtDeclarationKeyword());
  ast::Struct* const structure = specifiers.structure.get();
  if (structure) module.declarations.emplace_back(std::move(specifiers.structure));
  if (only_structure) return ExpectSemicolon("struct" + (structure->name.empty() ? "" : " '" + structure->name + "'"));
  if (is_function) {
    std::unique_ptr<ast::Function> function = ParseFunction(specifiers);
    const bool parsed = function != nullptr;
    if (function) module.declarations.emplace_back(std::move(function));
    return parsed;
  }
  VariableList variables;
  const bool parsed = ParseVariables(specifiers, true, variables);
  for (auto& variable : variables) module.declarations.emplace_back(std::move(variable));
  return parsed;
}

bool Parser::ParseTypedef(std::vector<std::unique_ptr<ast::Typedef>>& typedefs,
                          std::unique_ptr<ast::Struct>& structure) {
  Advance();
  Specifiers specifiers;
  if (!ParseSpecifiers(specifiers)) return false;
  structure = std::move(specifiers.structure);
  do {
    auto entry = std::make_unique<ast::Typedef>();
    if (!ExpectName("a name for the type", entry->name, entry->range)) return false;
    if (!function_brace_) entry->name.insert(0, space_);
    entry->type_name = specifiers.type;
    if (!ParseArraySizes(entry->array_sizes)) return false;
    names_.Declare(entry->name, true);
    typedefs.push_back(std::move(entry));
  } while (Accept(TokenKind::kComma));
  return ExpectSemicolon("typedef '" + typedefs.back()->name + "'");
}

// Direct3D 10's constant buffers: their members are globals.
bool Parser::ParseBuffer(ast::Module& module) {
  Advance();
  if (Is(TokenKind::kIdentifier)) Advance();
  std::string semantic;
  Range range;
  std::vector<std::string> registers;
  if (!ParseSemantics(semantic, range, &registers)) return false;
  const Range opening = Peek().range();
  if (!Expect(TokenKind::kLeftBrace, "'{' to begin the buffer")) return false;
  while (!Is(TokenKind::kRightBrace) && !Is(TokenKind::kEnd) && !stopped()) {
    const std::size_t first = position_;
    if (AtTechnique() || (IsWord("struct") && Peek().begin.column == 1)) break;  // the '}' is missing
    if (!ParseGlobal(module)) SkipStatement(first);
    if (position_ == first) Advance();
  }
  if (!ExpectClosing(TokenKind::kRightBrace, "'}' to end the buffer", opening)) return false;
  Accept(TokenKind::kSemicolon);
  return true;
}

// ReShade FX's; names are declared and looked up whole, so that nothing after the parser knows of namespaces.
bool Parser::ParseNamespace(ast::Module& module) {
  Advance();
  const std::string outer = space_;
  space_ += std::string(Advance().text) + "::";
  const Range opening = Peek().range();
  bool parsed = Expect(TokenKind::kLeftBrace, "'{' to begin the namespace");
  if (parsed && statement_depth_ >= kMaxNamespaces) parsed = ReportTooDeep();
  if (parsed) {
    const Nesting nesting(statement_depth_);
    while (!Is(TokenKind::kRightBrace) && !Is(TokenKind::kEnd) && !stopped()) ParseTopLevel(module);
    parsed = ExpectClosing(TokenKind::kRightBrace, "'}' to end the namespace", opening);
    Accept(TokenKind::kSemicolon);
  }
  space_ = outer;
  return parsed;
}

}  // namespace burin::fx

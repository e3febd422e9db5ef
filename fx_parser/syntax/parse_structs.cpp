// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/syntax/parse.h"
#include "fx_parser/syntax/parser.h"

namespace burin::fx {

std::unique_ptr<ast::Struct> Parser::ParseStruct() {
  if (statement_depth_ >= kMaxNesting) return ReportTooDeep(), nullptr;
  const Nesting nesting(statement_depth_);
  auto structure = std::make_unique<ast::Struct>();
  structure->is_interface = IsWord("interface");
  structure->range = Advance().range();
  if (Is(TokenKind::kIdentifier)) {
    structure->range = Peek().range();
    structure->name = (function_brace_ ? "" : space_) + std::string(Advance().text);
  }
  names_.Declare(structure->name, true);  // before its body, so that faults in there make no others
  if (Accept(TokenKind::kColon)) {        // Cg: the interface that it is one of
    std::string base;
    Range range;
    if (!ParseQualifiedName("the name of an interface", base, range)) return nullptr;
  }
  const Range opening = Peek().range();
  if (!Expect(TokenKind::kLeftBrace, "'{' to begin the struct")) return nullptr;
  while (!Is(TokenKind::kRightBrace) && !Is(TokenKind::kEnd) && !stopped()) {
    const std::size_t first = position_;
    if (AtTechnique() || AtOuterFunction()) break;  // the '}' is missing
    if (!ParseMember(*structure)) SkipStatement(first);
    if (position_ == first) Advance();
  }
  const std::string what = "'}' to end struct" + (structure->name.empty() ? "" : " '" + structure->name + "'");
  ExpectClosing(TokenKind::kRightBrace, what, opening);
  return structure;
}

// `float4 main(` in column 1: no member, but the next thing at file scope.
bool Parser::AtOuterFunction() const {
  return Peek().starts_line && Peek().begin.column == 1 && Is(TokenKind::kIdentifier) &&
         Is(TokenKind::kIdentifier, 1) && Is(TokenKind::kLeftParen, 2);
}

bool Parser::ParseMember(ast::Struct& structure) {
  if (Accept(TokenKind::kSemicolon)) return true;
  Specifiers specifiers;
  if (!ParseSpecifiers(specifiers)) return false;
  if (specifiers.structure) {
    Report(specifiers.structure->range, "a struct cannot be defined inside a struct");
    return false;
  }
  if (Is(TokenKind::kIdentifier) && Is(TokenKind::kLeftParen, 1)) return ParseMethod(structure, specifiers);
  std::string name;
  do {
    auto member = std::make_unique<ast::Variable>();
    member->qualifiers = specifiers.qualifiers;
    member->type_name = specifiers.type;
    if (!ExpectName("a member's name", member->name, member->range)) return false;
    name = member->name;
    if (!ParseArraySizes(member->array_sizes)) return false;
    if (!ParseSemantics(member->semantic, member->semantic_range, &member->registers)) return false;
    if (Is(TokenKind::kLess) && !ParseAnnotations(member->annotations)) return false;
    structure.members.push_back(std::move(member));
  } while (Accept(TokenKind::kComma));
  return ExpectSemicolon("member '" + name + "'");
}

// Cg's functions of structs and interfaces. Their bodies are another matter: nothing here runs them.
bool Parser::ParseMethod(ast::Struct& structure, Specifiers& specifiers) {
  auto method = std::make_unique<ast::Function>();
  method->return_type_name = std::move(specifiers.type);
  method->range = Peek().range();
  method->name = Advance().text;
  names_.Push();
  const bool has_head = ParseParameters(*method) && ParseSemantics(method->semantic, method->semantic_range, nullptr);
  names_.Pop();
  if (!has_head) return false;
  const std::string name = method->name;
  structure.methods.push_back(std::move(method));
  if (!Is(TokenKind::kLeftBrace)) return ExpectSemicolon("function '" + name + "'");
  const Range opening = Peek().range();
  position_ = FindClosing(position_);
  return ExpectClosing(TokenKind::kRightBrace, "'}' to end function '" + name + "'", opening);
}

}  // namespace burin::fx

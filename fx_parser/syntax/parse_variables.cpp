// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "fx_parser/syntax/parser.h"

namespace burin::fx {

bool Parser::ParseVariables(const Specifiers& specifiers, bool is_global, VariableList& variables) {
  do {
    std::unique_ptr<ast::Variable> variable = ParseVariable(specifiers, is_global);
    if (!variable) return false;
    variables.push_back(std::move(variable));
  } while (Accept(TokenKind::kComma));
  const ast::Variable& last = *variables.back();
  if (Is(TokenKind::kAssign)) {
    ReportUnexpected("',' or ';' after '" + last.name + "'");
    return false;
  }
  return ExpectSemicolon("declaration of '" + last.name + "'");
}

std::unique_ptr<ast::Variable> Parser::ParseVariable(const Specifiers& specifiers, bool is_global) {
  auto variable = std::make_unique<ast::Variable>();
  if (!ExpectName("a name after type '" + specifiers.type.name + "'", variable->name, variable->range)) return nullptr;
  if (is_global) variable->name.insert(0, space_);
  variable->qualifiers = specifiers.qualifiers;
  variable->type_name = specifiers.type;
  variable->is_global = is_global;
  if (!ParseArraySizes(variable->array_sizes)) return nullptr;
  names_.Declare(variable->name, false);
  if (!ParseDeclaratorTail(*variable)) return nullptr;
  return variable;
}

// : SEMANTIC : register(...) < annotations > = initialiser, or { states } for samplers and textures.
bool Parser::ParseDeclaratorTail(ast::Variable& variable) {
  if (!ParseSemantics(variable.semantic, variable.semantic_range, &variable.registers)) return false;
  if (Is(TokenKind::kLess) && !ParseAnnotations(variable.annotations)) return false;
  const TypeKind kind = variable.type_name.type.kind;
  const bool takes_states = kind == TypeKind::kSampler || kind == TypeKind::kTexture || kind == TypeKind::kStateBlock;
  if (Is(TokenKind::kLeftBrace) && takes_states) {
    variable.initializer = ParseStateBlock(kind == TypeKind::kSampler ? "sampler state" : "state");
    return variable.initializer != nullptr;
  }
  if (!Accept(TokenKind::kAssign)) return true;
  variable.initializer = ParseAssignment();
  if (!variable.initializer) return false;
  return ParseSemantics(variable.semantic, variable.semantic_range, &variable.registers);
}

bool Parser::ParseArraySizes(std::vector<ast::ExpressionPtr>& sizes) {
  while (Is(TokenKind::kLeftBracket)) {
    const Range opening = Advance().range();
    if (Accept(TokenKind::kRightBracket)) {
      sizes.push_back(nullptr);
      continue;
    }
    const Setting angle(stop_at_greater_, false);
    ast::ExpressionPtr size = ParseConditional();
    if (!size || !ExpectClosing(TokenKind::kRightBracket, "']' after the array size", opening)) return false;
    sizes.push_back(std::move(size));
  }
  return true;
}

bool Parser::ParseSemantics(std::string& semantic, Range& range, std::vector<std::string>* registers) {
  while (Accept(TokenKind::kColon)) {
    const bool is_register = (IsEffectWord("register") || IsEffectWord("packoffset")) && Is(TokenKind::kLeftParen, 1);
    if (!is_register) {
      if (!ExpectName("a semantic after ':'", semantic, range)) return false;
      continue;
    }
    Advance();
    const Range opening = Peek().range();
    const std::size_t close = FindClosing(position_);
    const std::string text = TextOf(position_ + 1, close);
    position_ = close;
    if (!ExpectClosing(TokenKind::kRightParen, "')'", opening)) return false;
    if (registers) registers->push_back(text);
  }
  return true;
}

bool Parser::ParseAnnotations(std::vector<ast::Annotation>& annotations) {
  const Range opening = Advance().range();
  while (!Is(TokenKind::kGreater) && !Is(TokenKind::kGreaterEqual)) {
    if (Accept(TokenKind::kSemicolon)) continue;
    const std::size_t first = position_;
    if (!ParseAnnotationList(annotations)) return SkipAnnotations(first);
    const bool last = Is(TokenKind::kGreater) || Is(TokenKind::kGreaterEqual);
    if (!last && !ExpectSemicolon("annotation '" + annotations.back().name + "'")) return SkipAnnotations(first);
  }
  return ExpectClosingAngle(opening);
}

// Behind the '>' that ends the annotations, if it can be told: the declaration then goes on as if they were right.
bool Parser::SkipAnnotations(std::size_t first) {
  for (std::size_t i = first; i + 1 < tokens_.size(); ++i) {
    const TokenKind kind = tokens_[i].kind;
    if (kind == TokenKind::kRightBrace || kind == TokenKind::kLeftBrace) return false;
    if (kind != TokenKind::kGreater) continue;
    const TokenKind next = tokens_[i + 1].kind;
    const bool ends = next == TokenKind::kSemicolon || next == TokenKind::kAssign || next == TokenKind::kLeftBrace ||
                      next == TokenKind::kComma;
    if (!ends) continue;
    position_ = i + 1;
    return true;
  }
  return false;
}

// `int width = 16, height = 16`: several of one type.
bool Parser::ParseAnnotationList(std::vector<ast::Annotation>& annotations) {
  ast::TypeName type;
  if (!ParseAnnotationType(type)) return false;
  do {
    ast::Annotation annotation;
    annotation.type = type;
    if (!ParseAnnotation(annotation)) return false;
    annotations.push_back(std::move(annotation));
  } while (Accept(TokenKind::kComma));
  return true;
}

bool Parser::ParseAnnotationType(ast::TypeName& type) {
  if (Is(TokenKind::kIdentifier) && Is(TokenKind::kAssign, 1)) {
    type.type.kind = TypeKind::kError;  // ReShade's annotations have no types
    return true;
  }
  if (!Is(TokenKind::kIdentifier)) {
    ReportUnexpected("an annotation or '>'");
    return false;
  }
  return ParseTypeName(type, ParseQualifiers());
}

bool Parser::ParseAnnotation(ast::Annotation& annotation) {
  const Setting angle(stop_at_greater_, true);
  if (!ExpectName("the annotation's name", annotation.name, annotation.name_range)) return false;
  if (!ParseArraySizes(annotation.array_sizes)) return false;
  if (!Accept(TokenKind::kAssign)) return true;
  annotation.value = ParseAssignment();
  return annotation.value != nullptr;
}

// `> = 0.5` may be written without the space.
bool Parser::ExpectClosingAngle(const Range& opening) {
  if (!Is(TokenKind::kGreaterEqual)) return ExpectClosing(TokenKind::kGreater, "'>'", opening);
  Token& token = tokens_[position_];
  token.kind = TokenKind::kAssign;
  token.text.remove_prefix(1);
  ++token.begin.column;
  return true;
}

}  // namespace burin::fx

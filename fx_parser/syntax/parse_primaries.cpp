// SPDX-License-Identifier: Apache-2.0
#include <optional>
#include <utility>

#include "fx_parser/syntax/builtin_types.h"
#include "fx_parser/syntax/literal.h"
#include "fx_parser/syntax/parser.h"

namespace burin::fx {

// Literals side by side join, parenthesised ones too: macros build annotation strings that way.
ast::ExpressionPtr Parser::ParsePrimary() {
  const std::size_t first = position_;
  ast::ExpressionPtr primary = ParsePrimaryKind();
  while (primary && std::holds_alternative<ast::StringLiteral>(primary->node)) {
    std::size_t ahead = 0;
    while (Is(TokenKind::kLeftParen, ahead)) ++ahead;
    if (!Is(TokenKind::kString, ahead)) break;
    const ast::ExpressionPtr next = ParsePrimaryKind();
    if (!next) return nullptr;
    const auto* more = std::get_if<ast::StringLiteral>(&next->node);
    if (!more) {
      Report(next->range, "expected only strings to be joined");
      return nullptr;
    }
    std::string joined = std::get<ast::StringLiteral>(primary->node).value + more->value;
    primary = Make(first, ast::StringLiteral{std::move(joined)});
  }
  return primary;
}

ast::ExpressionPtr Parser::ParsePrimaryKind() {
  switch (Peek().kind) {
    case TokenKind::kInteger:
    case TokenKind::kFloat:
      return ParseNumber();
    case TokenKind::kString:
      return ParseStringLiteral();
    case TokenKind::kLeftParen:
      return ParseParenthesised();
    case TokenKind::kLeftBrace:
      return ParseInitializerList();
    case TokenKind::kScope:
    case TokenKind::kIdentifier:
      return ParseIdentifier();
    default:
      ReportUnexpected("an expression");
      return nullptr;
  }
}

ast::ExpressionPtr Parser::ParseNumber() {
  const std::size_t first = position_;
  const Token& token = Advance();
  if (token.kind == TokenKind::kFloat) {
    const FloatValue value = ParseFloat(token.text);
    return Make(first, ast::FloatLiteral{value.value, value.is_half});
  }
  const std::optional<IntegerValue> value = ParseInteger(token.text);
  if (!value) {
    Report(token.range(), "the number " + Describe(token) + " needs more than 64 bits", "B1103");
    return nullptr;
  }
  return Make(first, ast::IntLiteral{value->value, value->is_unsigned});
}

ast::ExpressionPtr Parser::ParseStringLiteral() {
  const std::size_t first = position_;
  std::string text;
  while (Is(TokenKind::kString)) text += ParseString(Advance().text);
  return Make(first, ast::StringLiteral{std::move(text)});
}

ast::ExpressionPtr Parser::ParseParenthesised() {
  const Range opening = Advance().range();
  const Setting angle(stop_at_greater_, false);
  ast::ExpressionPtr inner = ParseExpression();
  if (!inner || !ExpectClosing(TokenKind::kRightParen, "')'", opening)) return nullptr;
  inner->range = Join(opening, Previous().range());
  return inner;
}

// A name, a call, or one of the words that begin something else where the right token follows.
ast::ExpressionPtr Parser::ParseIdentifier() {
  const std::size_t first = position_;
  const bool word_follows = Is(TokenKind::kIdentifier, 1);
  if (IsEffectWord("true") || IsEffectWord("false")) {
    const bool value = IsEffectWord("true");
    Advance();
    return Make(first, ast::BoolLiteral{value});
  }
  if ((IsEffectWord("compile") || IsEffectWord("compile_fragment")) && word_follows) return ParseCompile();
  if (IsEffectWord("CompileShader") && Is(TokenKind::kLeftParen, 1)) return ParseCompileShader();
  if (IsEffectWord("asm") && Is(TokenKind::kLeftBrace, 1)) return ParseAsm();
  const bool is_states = IsEffectWord("sampler_state") || IsEffectWord("stateblock_state");
  if (is_states && Is(TokenKind::kLeftBrace, 1)) {
    const bool is_sampler = IsEffectWord("sampler_state");
    Advance();
    return ParseStateBlock(is_sampler ? "sampler state" : "state");
  }
  if (StartsType(0) && !IsWord("struct")) {
    const bool takes_arguments = IsEffectWord("vector") || IsEffectWord("matrix");
    const bool constructs = Is(TokenKind::kLeftParen, 1) || (takes_arguments && Is(TokenKind::kLess, 1));
    if (constructs) return ParseConstruct();
  }
  ast::Name name;
  Range range;
  if (!ParseQualifiedName("a name", name.name, range)) return nullptr;
  if (!Is(TokenKind::kLeftParen)) return Make(first, std::move(name));
  ast::Call call;
  call.name = std::move(name.name);
  call.name_range = range;
  if (!ParseArguments(call.arguments)) return nullptr;
  return Make(first, std::move(call));
}

bool Parser::ParseQualifiedName(const std::string& what, std::string& name, Range& range) {
  const std::size_t first = position_;
  if (Accept(TokenKind::kScope)) name = "::";
  std::string part;
  if (!ExpectName(what, part, range)) return false;
  name += part;
  while (Is(TokenKind::kScope) && Is(TokenKind::kIdentifier, 1)) {
    Advance();
    name += "::" + std::string(Advance().text);
  }
  if (!space_.empty() || position_ > first + 1) name = names_.Resolve(name, space_);
  range = RangeFrom(first);
  return true;
}

ast::ExpressionPtr Parser::ParseConstruct() {
  const std::size_t first = position_;
  ast::Construct construct;
  if (!ParseTypeName(construct.type, 0)) return nullptr;
  if (!Is(TokenKind::kLeftParen)) {
    ReportUnexpected("'(' after type '" + construct.type.name + "'");
    return nullptr;
  }
  if (!ParseArguments(construct.arguments)) return nullptr;
  return Make(first, std::move(construct));
}

bool Parser::ParseArguments(std::vector<ast::ExpressionPtr>& arguments) {
  const Range opening = Advance().range();
  const Setting angle(stop_at_greater_, false);
  if (Accept(TokenKind::kRightParen)) return true;
  do {
    ast::ExpressionPtr argument = ParseAssignment();
    if (!argument) return false;
    arguments.push_back(std::move(argument));
  } while (Accept(TokenKind::kComma));
  return ExpectClosing(TokenKind::kRightParen, "',' or ')' after the argument", opening);
}

ast::ExpressionPtr Parser::ParseInitializerList() {
  const std::size_t first = position_;
  const Range opening = Advance().range();
  const Setting angle(stop_at_greater_, false);
  ast::InitializerList list;
  while (!Is(TokenKind::kRightBrace)) {
    ast::ExpressionPtr element = ParseAssignment();
    if (!element) return nullptr;
    list.elements.push_back(std::move(element));
    if (!Accept(TokenKind::kComma)) break;  // one behind the last element is fine
  }
  if (!ExpectClosing(TokenKind::kRightBrace, "',' or '}' in the initialiser", opening)) return nullptr;
  return Make(first, std::move(list));
}

// compile PROFILE Function(arguments)
ast::ExpressionPtr Parser::ParseCompile() {
  const std::size_t first = position_;
  Advance();
  ast::Compile compile;
  if (Is(TokenKind::kLeftParen, 1)) {
    Report(Peek().range(), "expected a shader profile such as ps_2_0 before '" + std::string(Peek().text) + "'");
    return nullptr;
  }
  if (!ExpectName("a shader profile after 'compile'", compile.profile, compile.profile_range)) return nullptr;
  Accept(TokenKind::kString);  // CgFX: options for its compiler
  if (!ParseEntryPoint(compile)) return nullptr;
  return Make(first, std::move(compile));
}

bool Parser::ParseEntryPoint(ast::Compile& compile) {
  const std::string what = "the name of a function to compile for '" + compile.profile + "'";
  if (!ParseQualifiedName(what, compile.function, compile.function_range)) return false;
  return !Is(TokenKind::kLeftParen) || ParseArguments(compile.arguments);  // CgFX may leave the parentheses out
}

// Direct3D 10's CompileShader(PROFILE, Function(arguments)).
ast::ExpressionPtr Parser::ParseCompileShader() {
  const std::size_t first = position_;
  Advance();
  const Range opening = Advance().range();
  ast::Compile compile;
  if (!ExpectName("a shader profile", compile.profile, compile.profile_range)) return nullptr;
  if (!Expect(TokenKind::kComma, "',' after the shader profile") || !ParseEntryPoint(compile)) return nullptr;
  if (!ExpectClosing(TokenKind::kRightParen, "')' after the function to compile", opening)) return nullptr;
  return Make(first, std::move(compile));
}

// Another language: only its braces count.
ast::ExpressionPtr Parser::ParseAsm() {
  const std::size_t first = position_;
  Advance();
  const Range opening = Peek().range();
  const std::size_t begin = position_ + 1;
  int depth = 0;
  do {
    if (Is(TokenKind::kLeftBrace)) ++depth;
    if (Is(TokenKind::kRightBrace)) --depth;
    if (depth == 0 || Is(TokenKind::kEnd)) break;
    Advance();
  } while (true);
  ast::AsmBlock block{TextOf(begin, position_)};
  if (!ExpectClosing(TokenKind::kRightBrace, "'}' to end the asm block", opening)) return nullptr;
  return Make(first, std::move(block));
}

}  // namespace burin::fx

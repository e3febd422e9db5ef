// SPDX-License-Identifier: Apache-2.0
// Expressions by precedence, HLSL's (C's) from the comma down to the unary operators.

#include <optional>
#include <utility>

#include "fx_parser/syntax/expression_height.h"
#include "fx_parser/syntax/parse.h"
#include "fx_parser/syntax/parser.h"

namespace burin::fx {

namespace {

using ast::BinaryOperator;
using ast::UnaryOperator;

struct BinaryToken {
  TokenKind kind;
  BinaryOperator op;
  int precedence;
};

constexpr BinaryToken kBinaryTokens[] = {
    {TokenKind::kOrOr, BinaryOperator::kOr, 1},
    {TokenKind::kAndAnd, BinaryOperator::kAnd, 2},
    {TokenKind::kPipe, BinaryOperator::kBitOr, 3},
    {TokenKind::kCaret, BinaryOperator::kBitXor, 4},
    {TokenKind::kAmpersand, BinaryOperator::kBitAnd, 5},
    {TokenKind::kEqual, BinaryOperator::kEqual, 6},
    {TokenKind::kNotEqual, BinaryOperator::kNotEqual, 6},
    {TokenKind::kLess, BinaryOperator::kLess, 7},
    {TokenKind::kGreater, BinaryOperator::kGreater, 7},
    {TokenKind::kLessEqual, BinaryOperator::kLessEqual, 7},
    {TokenKind::kGreaterEqual, BinaryOperator::kGreaterEqual, 7},
    {TokenKind::kShiftLeft, BinaryOperator::kShl, 8},
    {TokenKind::kShiftRight, BinaryOperator::kShr, 8},
    {TokenKind::kPlus, BinaryOperator::kAdd, 9},
    {TokenKind::kMinus, BinaryOperator::kSub, 9},
    {TokenKind::kStar, BinaryOperator::kMul, 10},
    {TokenKind::kSlash, BinaryOperator::kDiv, 10},
    {TokenKind::kPercent, BinaryOperator::kMod, 10},
};

const BinaryToken* FindBinary(TokenKind kind) {
  for (const BinaryToken& token : kBinaryTokens) {
    if (token.kind == kind) return &token;
  }
  return nullptr;
}

bool StartsWithGreater(TokenKind kind) {
  return kind == TokenKind::kGreater || kind == TokenKind::kGreaterEqual || kind == TokenKind::kShiftRight ||
         kind == TokenKind::kShiftRightAssign;
}

// True for an assignment; `op` then holds what is done besides.
bool IsAssignment(TokenKind kind, std::optional<BinaryOperator>& op) {
  switch (kind) {
    case TokenKind::kAssign: op = std::nullopt; return true;
    case TokenKind::kPlusAssign: op = BinaryOperator::kAdd; return true;
    case TokenKind::kMinusAssign: op = BinaryOperator::kSub; return true;
    case TokenKind::kStarAssign: op = BinaryOperator::kMul; return true;
    case TokenKind::kSlashAssign: op = BinaryOperator::kDiv; return true;
    case TokenKind::kPercentAssign: op = BinaryOperator::kMod; return true;
    case TokenKind::kShiftLeftAssign: op = BinaryOperator::kShl; return true;
    case TokenKind::kShiftRightAssign: op = BinaryOperator::kShr; return true;
    case TokenKind::kAndAssign: op = BinaryOperator::kBitAnd; return true;
    case TokenKind::kOrAssign: op = BinaryOperator::kBitOr; return true;
    case TokenKind::kXorAssign: op = BinaryOperator::kBitXor; return true;
    default: return false;
  }
}

std::optional<UnaryOperator> FindPrefix(TokenKind kind) {
  switch (kind) {
    case TokenKind::kPlus: return UnaryOperator::kPlus;
    case TokenKind::kMinus: return UnaryOperator::kNegate;
    case TokenKind::kExclamation: return UnaryOperator::kNot;
    case TokenKind::kTilde: return UnaryOperator::kBitNot;
    case TokenKind::kPlusPlus: return UnaryOperator::kPreIncrement;
    case TokenKind::kMinusMinus: return UnaryOperator::kPreDecrement;
    default: return std::nullopt;
  }
}

// ParseAssignment and ParseUnary each count once per parenthesis.
constexpr int kMaxExpressionDepth = 2 * kMaxNesting;

}  // namespace

ast::ExpressionPtr Parser::CheckHeight(ast::ExpressionPtr expression) {
  expression->height = HeightOf(*expression);
  if (expression->height <= kMaxExpressionHeight) return expression;
  Report(expression->range, "the expression has more than " + std::to_string(kMaxExpressionHeight) +
                                " operators inside one another", "B1201");
  return nullptr;
}

ast::ExpressionPtr Parser::ParseExpression() {
  const std::size_t first = position_;
  ast::ExpressionPtr left = ParseAssignment();
  while (left && Accept(TokenKind::kComma)) {
    ast::ExpressionPtr right = ParseAssignment();
    if (!right) return nullptr;
    left = Make(first, ast::Binary{BinaryOperator::kComma, std::move(left), std::move(right)});
  }
  return left;
}

ast::ExpressionPtr Parser::ParseAssignment() {
  if (expression_depth_ >= kMaxExpressionDepth) return ReportTooDeep(), nullptr;
  const Nesting nesting(expression_depth_);
  const std::size_t first = position_;
  ast::ExpressionPtr target = ParseConditional();
  std::optional<BinaryOperator> op;
  const bool is_end = stop_at_greater_ && StartsWithGreater(Peek().kind);
  if (!target || is_end || !IsAssignment(Peek().kind, op)) return target;
  Advance();
  ast::ExpressionPtr value = ParseAssignment();
  if (!value) return nullptr;
  return Make(first, ast::Assign{op, std::move(target), std::move(value)});
}

ast::ExpressionPtr Parser::ParseConditional() {
  const std::size_t first = position_;
  ast::ExpressionPtr condition = ParseBinary(1);
  if (!condition || !Accept(TokenKind::kQuestion)) return condition;
  ast::ExpressionPtr if_true = ParseAssignment();
  if (!if_true || !Expect(TokenKind::kColon, "':' of the conditional operator")) return nullptr;
  ast::ExpressionPtr if_false = ParseAssignment();
  if (!if_false) return nullptr;
  return Make(first, ast::Conditional{std::move(condition), std::move(if_true), std::move(if_false)});
}

ast::ExpressionPtr Parser::ParseBinary(int least_precedence) {
  const std::size_t first = position_;
  ast::ExpressionPtr left = ParseUnary();
  while (left) {
    if (stop_at_greater_ && StartsWithGreater(Peek().kind)) break;
    const BinaryToken* token = FindBinary(Peek().kind);
    if (!token || token->precedence < least_precedence) break;
    Advance();
    ast::ExpressionPtr right = ParseBinary(token->precedence + 1);
    if (!right) return nullptr;
    left = Make(first, ast::Binary{token->op, std::move(left), std::move(right)});
  }
  return left;
}

ast::ExpressionPtr Parser::ParseUnary() {
  if (expression_depth_ >= kMaxExpressionDepth) return ReportTooDeep(), nullptr;
  const Nesting nesting(expression_depth_);
  return ParseUnaryOperand();
}

ast::ExpressionPtr Parser::ParseUnaryOperand() {
  const std::size_t first = position_;
  if (const std::optional<UnaryOperator> op = FindPrefix(Peek().kind)) {
    Advance();
    ast::ExpressionPtr operand = ParseUnary();
    if (!operand) return nullptr;
    return Make(first, ast::Unary{*op, std::move(operand)});
  }
  if (Is(TokenKind::kLeftParen) && StartsCast()) return ParseCast();
  return ParsePostfix();
}

ast::ExpressionPtr Parser::ParseCast() {
  const std::size_t first = position_;
  const Range opening = Advance().range();
  ast::Cast cast;
  if (!ParseTypeName(cast.type, 0) || !ParseArraySizes(cast.array_sizes)) return nullptr;
  if (!ExpectClosing(TokenKind::kRightParen, "')' after the type of the cast", opening)) return nullptr;
  cast.operand = ParseUnary();
  if (!cast.operand) return nullptr;
  return Make(first, std::move(cast));
}

ast::ExpressionPtr Parser::ParsePostfix() {
  const std::size_t first = position_;
  ast::ExpressionPtr operand = ParsePrimary();
  while (operand) {
    const TokenKind kind = Peek().kind;
    const bool is_postfix = kind == TokenKind::kDot || kind == TokenKind::kLeftBracket ||
                            kind == TokenKind::kPlusPlus || kind == TokenKind::kMinusMinus;
    if (!is_postfix) break;
    operand = ParsePostfixOperator(std::move(operand), first);
  }
  return operand;
}

ast::ExpressionPtr Parser::ParsePostfixOperator(ast::ExpressionPtr operand, std::size_t first) {
  if (Is(TokenKind::kDot)) return ParseMember(std::move(operand), first);
  if (Accept(TokenKind::kPlusPlus)) return Make(first, ast::Unary{UnaryOperator::kPostIncrement, std::move(operand)});
  if (Accept(TokenKind::kMinusMinus)) return Make(first, ast::Unary{UnaryOperator::kPostDecrement, std::move(operand)});
  const Range opening = Advance().range();
  const Setting angle(stop_at_greater_, false);
  ast::ExpressionPtr index = ParseExpression();
  if (!index || !ExpectClosing(TokenKind::kRightBracket, "']' after the index", opening)) return nullptr;
  return Make(first, ast::Index{std::move(operand), std::move(index)});
}

ast::ExpressionPtr Parser::ParseMember(ast::ExpressionPtr operand, std::size_t first) {
  Advance();
  ast::Member member;
  if (!ExpectName("a member or swizzle after '.'", member.name, member.name_range)) return nullptr;
  if (!Is(TokenKind::kLeftParen)) {
    member.operand = std::move(operand);
    return Make(first, std::move(member));
  }
  ast::Call call;
  call.object = std::move(operand);
  call.name = std::move(member.name);
  call.name_range = member.name_range;
  if (!ParseArguments(call.arguments)) return nullptr;
  return Make(first, std::move(call));
}

}  // namespace burin::fx

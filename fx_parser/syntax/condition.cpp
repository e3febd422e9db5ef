// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/syntax/condition.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "fx_parser/syntax/literal.h"

namespace burin::fx {

namespace {

// Parentheses and unary operators inside one another.
constexpr int kMaxDepth = 100;

Token Boolean(const Token& where, bool value) {
  Token token = where;
  token.kind = TokenKind::kInteger;
  token.text = value ? "1" : "0";
  return token;
}

// `defined X` and `defined(X)` to 1 or 0; the rest untouched. What is malformed stays for the evaluator to report.
std::vector<Token> ReplaceDefined(const MacroContext& context, const std::vector<Token>& line) {
  std::vector<Token> result;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const auto is = [&](std::size_t at, TokenKind kind) { return at < line.size() && line[at].kind == kind; };
    if (!line[i].Is("defined")) {
      result.push_back(line[i]);
    } else if (is(i + 1, TokenKind::kIdentifier)) {
      result.push_back(Boolean(line[i], context.macros.Find(line[i + 1].text) != nullptr));
      i += 1;
    } else if (is(i + 1, TokenKind::kLeftParen) && is(i + 2, TokenKind::kIdentifier) &&
               is(i + 3, TokenKind::kRightParen)) {
      result.push_back(Boolean(line[i], context.macros.Find(line[i + 2].text) != nullptr));
      i += 3;
    } else {
      result.push_back(line[i]);
    }
  }
  return result;
}

// As MacroExpander::ExpandAll, but what follows a `defined` that a macro brings stays as it is.
std::vector<Token> ExpandAroundDefined(MacroContext& context, std::vector<Token> tokens) {
  TokenListSource source(std::move(tokens));
  MacroExpander expander(context, source);
  std::vector<Token> expanded;
  for (Token token = expander.Next(); token.kind != TokenKind::kEnd; token = expander.Next()) {
    expanded.push_back(token);
    if (!token.Is("defined")) continue;
    Token operand = expander.NextUnexpanded();
    if (operand.kind != TokenKind::kEnd) expanded.push_back(operand);
    if (operand.kind == TokenKind::kLeftParen) operand = expander.NextUnexpanded();
    if (expanded.back().kind == TokenKind::kLeftParen && operand.kind != TokenKind::kEnd) expanded.push_back(operand);
  }
  return expanded;
}

int Precedence(TokenKind kind) {
  switch (kind) {
    case TokenKind::kOrOr:
      return 1;
    case TokenKind::kAndAnd:
      return 2;
    case TokenKind::kPipe:
      return 3;
    case TokenKind::kCaret:
      return 4;
    case TokenKind::kAmpersand:
      return 5;
    case TokenKind::kEqual:
    case TokenKind::kNotEqual:
      return 6;
    case TokenKind::kLess:
    case TokenKind::kGreater:
    case TokenKind::kLessEqual:
    case TokenKind::kGreaterEqual:
      return 7;
    case TokenKind::kShiftLeft:
    case TokenKind::kShiftRight:
      return 8;
    case TokenKind::kPlus:
    case TokenKind::kMinus:
      return 9;
    case TokenKind::kStar:
    case TokenKind::kSlash:
    case TokenKind::kPercent:
      return 10;
    default:
      return 0;
  }
}

class Evaluator {
 public:
  Evaluator(const std::vector<Token>& tokens, const Token& directive, Diagnostics& diagnostics)
      : tokens_(tokens), directive_(directive), diagnostics_(diagnostics) {}

  bool Run() {
    const std::int64_t value = Ternary(true);
    if (!failed_ && position_ < tokens_.size()) Fail("unexpected " + Describe(tokens_[position_]) + " in a condition");
    return !failed_ && value != 0;
  }

 private:
  [[nodiscard]] TokenKind Kind() const {
    return position_ < tokens_.size() ? tokens_[position_].kind : TokenKind::kEnd;
  }

  std::int64_t Fail(const std::string& text) {
    const Range& range = position_ < tokens_.size() ? tokens_[position_].range() : directive_.range();
    if (!failed_) diagnostics_.Error(range, "B1007", text);
    failed_ = true;
    position_ = tokens_.size();
    return 0;
  }

  bool Accept(TokenKind kind) {
    if (Kind() != kind) return false;
    ++position_;
    return true;
  }

  // `live` is false in operands that && || ?: skip: there a division by zero is no fault.
  std::int64_t Ternary(bool live) {
    const std::int64_t condition = Binary(1, live);
    if (!Accept(TokenKind::kQuestion)) return condition;
    if (++depth_ > kMaxDepth) return Fail("the condition is nested too deeply");
    const std::int64_t if_true = Ternary(live && condition != 0);
    if (!failed_ && !Accept(TokenKind::kColon)) return Fail("expected ':' in a condition");
    const std::int64_t if_false = Ternary(live && condition == 0);
    --depth_;
    return condition != 0 ? if_true : if_false;
  }

  std::int64_t Binary(int least, bool live) {
    std::int64_t left = Unary(live);
    while (!failed_) {
      const TokenKind op = Kind();
      const int precedence = Precedence(op);
      if (precedence == 0 || precedence < least) break;
      const std::size_t at = position_++;
      const bool skips = (op == TokenKind::kAndAnd && left == 0) || (op == TokenKind::kOrOr && left != 0);
      const std::int64_t right = Binary(precedence + 1, live && !skips);
      if (live && !failed_ && right == 0 && (op == TokenKind::kSlash || op == TokenKind::kPercent)) {
        position_ = at;
        return Fail("division by zero in a condition");
      }
      left = Apply(op, left, right);
    }
    return left;
  }

  // Wraps like two's complement hardware: no text may make this undefined.
  static std::int64_t Apply(TokenKind op, std::int64_t left, std::int64_t right) {
    const auto a = static_cast<std::uint64_t>(left), b = static_cast<std::uint64_t>(right);
    const auto wrap = [](std::uint64_t value) { return static_cast<std::int64_t>(value); };
    const bool overflows = left == std::numeric_limits<std::int64_t>::min() && right == -1;
    switch (op) {
      case TokenKind::kOrOr:
        return left != 0 || right != 0;
      case TokenKind::kAndAnd:
        return left != 0 && right != 0;
      case TokenKind::kPipe:
        return wrap(a | b);
      case TokenKind::kCaret:
        return wrap(a ^ b);
      case TokenKind::kAmpersand:
        return wrap(a & b);
      case TokenKind::kEqual:
        return left == right;
      case TokenKind::kNotEqual:
        return left != right;
      case TokenKind::kLess:
        return left < right;
      case TokenKind::kGreater:
        return left > right;
      case TokenKind::kLessEqual:
        return left <= right;
      case TokenKind::kGreaterEqual:
        return left >= right;
      case TokenKind::kShiftLeft:
        return b < 64 ? wrap(a << b) : 0;
      case TokenKind::kShiftRight:
        return b < 64 ? left >> b : (left < 0 ? -1 : 0);
      case TokenKind::kPlus:
        return wrap(a + b);
      case TokenKind::kMinus:
        return wrap(a - b);
      case TokenKind::kStar:
        return wrap(a * b);
      case TokenKind::kSlash:
        return right == 0 ? 0 : overflows ? left : left / right;
      case TokenKind::kPercent:
        return right == 0 || overflows ? 0 : left % right;
      default:
        return 0;
    }
  }

  std::int64_t Unary(bool live) {
    if (failed_) return 0;
    if (++depth_ > kMaxDepth) return Fail("the condition is nested too deeply");
    const std::int64_t value = UnaryOperand(live);
    --depth_;
    return value;
  }

  std::int64_t UnaryOperand(bool live) {
    if (Accept(TokenKind::kExclamation)) return Unary(live) == 0;
    if (Accept(TokenKind::kTilde)) return ~Unary(live);
    if (Accept(TokenKind::kPlus)) return Unary(live);
    if (Accept(TokenKind::kMinus)) return Apply(TokenKind::kMinus, 0, Unary(live));
    if (Accept(TokenKind::kLeftParen)) {
      const std::int64_t value = Ternary(live);
      if (!failed_ && !Accept(TokenKind::kRightParen)) return Fail("expected ')' in a condition");
      return value;
    }
    return Primary();
  }

  std::int64_t Primary() {
    if (position_ == tokens_.size()) {
      const std::string fault = tokens_.empty() ? " has no expression" : ": the expression ends too early";
      return Fail("#" + std::string(directive_.text) + fault);
    }
    const Token& token = tokens_[position_];
    if (token.kind == TokenKind::kInteger) {
      const std::optional<IntegerValue> value = ParseInteger(token.text);
      if (!value) return Fail("the number " + Describe(token) + " needs more than 64 bits");
      ++position_;
      return static_cast<std::int64_t>(value->value);
    }
    if (token.kind == TokenKind::kFloat) return WholePart(token);
    if (token.Is("defined")) return Fail("expected a macro name after 'defined'");
    if (token.kind == TokenKind::kIdentifier) {
      ++position_;
      return token.text == "true" ? 1 : 0;
    }
    return Fail("unexpected " + Describe(token) + " in a condition");
  }

  std::int64_t WholePart(const Token& token) {
    constexpr double kLimit = 9e18;
    ++position_;
    const double whole = std::trunc(std::clamp(ParseFloat(token.text).value, 0.0, kLimit));
    const auto value = static_cast<std::int64_t>(whole);
    diagnostics_.Warning(token.range(), "B1007",
                         "a condition takes whole numbers: " + Describe(token) + " counts as " + std::to_string(value));
    return value;
  }

  const std::vector<Token>& tokens_;
  const Token& directive_;
  Diagnostics& diagnostics_;
  std::size_t position_ = 0;
  int depth_ = 0;
  bool failed_ = false;
};

}  // namespace

bool EvaluateCondition(MacroContext& context, const std::vector<Token>& line, const Token& directive) {
  std::vector<Token> tokens = ExpandAroundDefined(context, ReplaceDefined(context, line));
  if (context.stopped()) return false;
  tokens = ReplaceDefined(context, tokens);
  return Evaluator(tokens, directive, context.diagnostics()).Run();
}

}  // namespace burin::fx

// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/semantics/constant.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fx_parser/semantics/conversion.h"
#include "fx_parser/semantics/intrinsics.h"
#include "fx_parser/semantics/swizzle.h"

namespace burin::fx {
namespace {

/// Nodes visited before an evaluation gives up: constants that name constants could multiply without end.
constexpr int kMaxSteps = 1 << 20;
/// Nested evaluations, through the initialisers of constants too; each is a few hundred bytes of stack.
constexpr int kMaxDepth = 2048;

class Evaluator {
 public:
  explicit Evaluator(const VariableLookup& lookup) : lookup_(lookup) {}

  std::optional<Value> Run(const ast::Expression& e) {
    if (++steps_ > kMaxSteps || depth_ >= kMaxDepth) return std::nullopt;
    ++depth_;
    auto result = std::visit([&](const auto& node) { return Visit(e, node); }, e.node);
    --depth_;
    return result;
  }

  std::optional<Value> RunAs(const ast::Expression& e, const Type& type) {
    if (const auto* list = std::get_if<ast::InitializerList>(&e.node)) return List(*list, type);
    const auto value = Run(e);
    return value ? ConvertValue(*value, type) : std::nullopt;
  }

 private:
  using Result = std::optional<Value>;

  static Result Number(const Type& type, double number) { return Value{type, {number}, {}}; }

  Result Visit(const ast::Expression& e, const ast::BoolLiteral& n) { return Number(e.type, n.value ? 1 : 0); }
  Result Visit(const ast::Expression& e, const ast::IntLiteral& n) {
    return Number(e.type, RoundToScalar(static_cast<double>(n.value), e.type.scalar));
  }
  Result Visit(const ast::Expression& e, const ast::FloatLiteral& n) { return Number(e.type, n.value); }
  Result Visit(const ast::Expression& e, const ast::StringLiteral& n) { return Value{e.type, {}, {n.value}}; }

  Result Visit(const ast::Expression&, const ast::Name& n) {
    if (n.variable == nullptr) return std::nullopt;
    if (lookup_) {
      if (const Value* value = lookup_(*n.variable)) return *value;
    }
    if ((n.variable->qualifiers & ast::kConst) == 0 || n.variable->initializer == nullptr) return std::nullopt;
    return RunAs(*n.variable->initializer, n.variable->type);
  }

  Result Visit(const ast::Expression& e, const ast::Unary& n) {
    auto value = Run(*n.operand);
    if (!value || !e.type.is_numeric()) return std::nullopt;
    if (n.op == ast::UnaryOperator::kNot) {
      for (double& x : value->numbers) x = x == 0 ? 1 : 0;
      value->type = e.type;
      return value;
    }
    value = ConvertValue(*value, e.type);
    if (!value) return std::nullopt;
    for (double& x : value->numbers) {
      switch (n.op) {
        case ast::UnaryOperator::kPlus:
          break;
        case ast::UnaryOperator::kNegate:
          x = RoundToScalar(-x, e.type.scalar);
          break;
        case ast::UnaryOperator::kBitNot:
          x = RoundToScalar(static_cast<double>(~static_cast<std::int64_t>(x)), e.type.scalar);
          break;
        default:
          return std::nullopt;
      }
    }
    return value;
  }

  static double Arithmetic(ast::BinaryOperator op, double a, double b, Scalar scalar) {
    using enum ast::BinaryOperator;
    const bool integral = !IsFloating(scalar);
    const auto ia = static_cast<std::int64_t>(integral ? a : 0);
    const auto ib = static_cast<std::int64_t>(integral ? b : 0);
    switch (op) {
      case kMul:
        return integral ? static_cast<double>(ia * ib) : a * b;
      case kDiv:
        if (integral) return ib == 0 ? 0.0 : static_cast<double>(ia / ib);
        return b == 0 ? a * std::numeric_limits<float>::max() : a / b;
      case kMod:
        if (integral) return ib == 0 ? 0.0 : static_cast<double>(ia % ib);
        return std::fmod(a, b);
      case kAdd:
        return a + b;
      case kSub:
        return a - b;
      case kShl:
        return static_cast<double>(static_cast<std::int64_t>(static_cast<std::uint64_t>(ia) << (ib & 31)));
      case kShr:
        return static_cast<double>(ia >> (ib & 31));
      case kBitAnd:
        return static_cast<double>(ia & ib);
      case kBitXor:
        return static_cast<double>(ia ^ ib);
      case kBitOr:
        return static_cast<double>(ia | ib);
      default:
        return 0;
    }
  }

  static bool Compare(ast::BinaryOperator op, double a, double b) {
    using enum ast::BinaryOperator;
    switch (op) {
      case kLess:
        return a < b;
      case kGreater:
        return a > b;
      case kLessEqual:
        return a <= b;
      case kGreaterEqual:
        return a >= b;
      case kEqual:
        return a == b;
      case kNotEqual:
        return a != b;
      case kAnd:
        return a != 0 && b != 0;
      case kOr:
        return a != 0 || b != 0;
      default:
        return false;
    }
  }

  Result Visit(const ast::Expression& e, const ast::Binary& n) {
    using enum ast::BinaryOperator;
    if (n.op == kComma) return Run(*n.left) ? Run(*n.right) : std::nullopt;
    const auto left = Run(*n.left);
    const auto right = left ? Run(*n.right) : std::nullopt;
    if (!right) return std::nullopt;
    const bool logical = n.op == kAnd || n.op == kOr;
    const bool comparison = n.op >= kLess && n.op <= kNotEqual;
    const auto common = CommonType(left->type, right->type);
    if (!common || !e.type.is_numeric()) return std::nullopt;
    // Logic on converted operands would lose 0.5; they only need the common shape.
    const Type operand = logical ? WithScalar(*common, Scalar::kDouble) : comparison ? *common : e.type;
    auto a = ConvertValue(*left, operand);
    const auto b = ConvertValue(*right, operand);
    if (!a || !b) return std::nullopt;
    for (std::size_t i = 0; i < a->numbers.size(); ++i) {
      double& x = a->numbers[i];
      const double y = b->numbers[i];
      if (logical || comparison)
        x = Compare(n.op, x, y) ? 1 : 0;
      else
        x = RoundToScalar(Arithmetic(n.op, x, y, operand.scalar), operand.scalar);
    }
    a->type = e.type;
    return a;
  }

  Result Visit(const ast::Expression&, const ast::Assign&) { return std::nullopt; }

  Result Visit(const ast::Expression& e, const ast::Conditional& n) {
    const auto condition = Run(*n.condition);
    const auto if_true = condition ? RunAs(*n.if_true, e.type) : std::nullopt;
    auto if_false = if_true ? RunAs(*n.if_false, e.type) : std::nullopt;
    if (!if_false) return std::nullopt;
    for (std::size_t i = 0; i < if_false->numbers.size(); ++i) {
      const std::size_t at = condition->numbers.size() == 1 ? 0 : i;
      if (at >= condition->numbers.size()) return std::nullopt;
      if (condition->numbers[at] != 0) if_false->numbers[i] = if_true->numbers[i];
    }
    return if_false;
  }

  Result Visit(const ast::Expression& e, const ast::Call& n) {
    if (n.intrinsic < 0) return std::nullopt;
    std::vector<Type> types;
    for (const auto& argument : n.arguments) types.push_back(argument->type);
    const auto call = ResolveIntrinsic(Intrinsics()[static_cast<std::size_t>(n.intrinsic)], types);
    if (!call) return std::nullopt;
    std::vector<Value> arguments;
    for (std::size_t i = 0; i < n.arguments.size(); ++i) {
      if (call->is_out[i]) return std::nullopt;
      auto value = RunAs(*n.arguments[i], call->parameters[i]);
      if (!value) return std::nullopt;
      arguments.push_back(std::move(*value));
    }
    return EvaluateIntrinsic(n.intrinsic, arguments, e.type);
  }

  bool Flatten(const ast::Expression& e, std::vector<double>& numbers) {
    if (const auto* list = std::get_if<ast::InitializerList>(&e.node)) {
      return std::all_of(list->elements.begin(), list->elements.end(),
                         [&](const auto& element) { return Flatten(*element, numbers); });
    }
    const auto value = Run(e);
    if (!value || !value->strings.empty()) return false;
    numbers.insert(numbers.end(), value->numbers.begin(), value->numbers.end());
    return true;
  }

  Result FromNumbers(const std::vector<double>& numbers, const Type& type) {
    std::vector<Scalar> scalars;
    if (FlatComponents(type) < 0 || static_cast<std::size_t>(FlatComponents(type)) > numbers.size())
      return std::nullopt;
    AppendFlatScalars(type, scalars);
    Value value{type, {}, {}};
    for (std::size_t i = 0; i < scalars.size(); ++i) value.numbers.push_back(RoundToScalar(numbers[i], scalars[i]));
    return value;
  }

  Result List(const ast::InitializerList& list, const Type& type) {
    if (type.kind == TypeKind::kString) {
      Value value{type, {}, {}};
      for (const auto& element : list.elements) {
        const auto string = Run(*element);
        if (!string || string->strings.size() != 1) return std::nullopt;
        value.strings.push_back(string->strings[0]);
      }
      return value;
    }
    std::vector<double> numbers;
    for (const auto& element : list.elements) {
      if (!Flatten(*element, numbers)) return std::nullopt;
    }
    return FromNumbers(numbers, type);
  }

  Result Visit(const ast::Expression& e, const ast::Construct& n) {
    std::vector<double> numbers;
    for (const auto& argument : n.arguments) {
      if (!Flatten(*argument, numbers)) return std::nullopt;
    }
    if (numbers.size() == 1) numbers.resize(static_cast<std::size_t>(e.type.components()), numbers[0]);
    return FromNumbers(numbers, e.type);
  }

  Result Visit(const ast::Expression& e, const ast::Cast& n) { return RunAs(*n.operand, e.type); }

  Result Visit(const ast::Expression& e, const ast::Member& n) {
    if (n.operand->type.is_array()) return Number(e.type, n.operand->type.array.front());
    auto value = Run(*n.operand);
    if (!value) return std::nullopt;
    if (value->type.kind == TypeKind::kStruct && value->type.structure != nullptr) {
      std::ptrdiff_t offset = 0;
      for (const auto& member : value->type.structure->members) {
        const auto count = FlatComponents(member->type);
        if (count < 0) return std::nullopt;
        if (member->name != n.name) {
          offset += count;
          continue;
        }
        const auto first = value->numbers.begin() + offset;
        return Value{member->type, {first, first + count}, {}};
      }
      return std::nullopt;
    }
    const auto swizzle = ParseSwizzle(value->type, n.name);
    if (!swizzle) return std::nullopt;
    Value result{e.type, {}, {}};
    for (const auto& c : *swizzle) {
      result.numbers.push_back(value->numbers[static_cast<std::size_t>(c.row * value->type.columns + c.column)]);
    }
    return result;
  }

  Result Visit(const ast::Expression&, const ast::Index& n) {
    const auto value = Run(*n.operand);
    const auto index = value ? Run(*n.index) : std::nullopt;
    if (!index || index->numbers.empty()) return std::nullopt;
    const auto element = ElementType(value->type);
    if (!element) return std::nullopt;
    const double at = std::trunc(index->numbers[0]);
    if (!(at >= 0) || at >= ElementCount(value->type)) return std::nullopt;
    const auto i = static_cast<std::ptrdiff_t>(at);
    if (element->kind == TypeKind::kString) return Value{*element, {}, {value->strings[static_cast<std::size_t>(i)]}};
    const auto size = static_cast<std::ptrdiff_t>(FlatComponents(*element));
    if (size < 0) return std::nullopt;
    const auto first = value->numbers.begin() + i * size;
    return Value{*element, {first, first + size}, {}};
  }

  Result Visit(const ast::Expression&, const ast::InitializerList&) { return std::nullopt; }
  Result Visit(const ast::Expression&, const ast::Compile&) { return std::nullopt; }
  Result Visit(const ast::Expression&, const ast::AsmBlock&) { return std::nullopt; }
  Result Visit(const ast::Expression&, const ast::StateBlockExpression&) { return std::nullopt; }

  const VariableLookup& lookup_;
  int steps_ = 0;
  int depth_ = 0;
};

std::vector<double> Truncated(const Value& value, const Type& to) {
  const Type& from = value.type;
  std::vector<double> numbers;
  if (from.is_matrix && to.is_matrix) {
    for (int row = 0; row < to.rows; ++row) {
      for (int column = 0; column < to.columns; ++column) {
        numbers.push_back(value.numbers[static_cast<std::size_t>(row * from.columns + column)]);
      }
    }
    return numbers;
  }
  numbers.assign(value.numbers.begin(), value.numbers.begin() + to.components());
  return numbers;
}

}  // namespace

std::optional<Value> Evaluate(const ast::Expression& expression, const VariableLookup& lookup) {
  return Evaluator(lookup).Run(expression);
}

std::optional<Value> EvaluateAs(const ast::Expression& expression, const Type& type, const VariableLookup& lookup) {
  return Evaluator(lookup).RunAs(expression, type);
}

double RoundToScalar(double number, Scalar scalar) {
  switch (scalar) {
    case Scalar::kBool:
      return number != 0 ? 1 : 0;
    case Scalar::kInt:
      if (!(std::fabs(number) < 9.2e18)) return 0;
      return static_cast<double>(
          static_cast<std::int32_t>(static_cast<std::uint64_t>(static_cast<std::int64_t>(number))));
    case Scalar::kUint:
      if (!(std::fabs(number) < 9.2e18)) return 0;
      return static_cast<double>(
          static_cast<std::uint32_t>(static_cast<std::uint64_t>(static_cast<std::int64_t>(number))));
    case Scalar::kHalf:
    case Scalar::kFloat:
      if (std::fabs(number) > std::numeric_limits<float>::max()) {
        return std::copysign(static_cast<double>(std::numeric_limits<float>::max()), number);
      }
      return static_cast<double>(static_cast<float>(number));
    case Scalar::kDouble:
      return number;
  }
  return number;
}

std::optional<Value> ConvertValue(const Value& value, const Type& type) {
  if (SameType(value.type, type)) return Value{type, value.numbers, value.strings};
  if (type.kind == TypeKind::kString || value.type.kind == TypeKind::kString) {
    if (type.kind != value.type.kind) return std::nullopt;
    return Value{type, value.numbers, value.strings};
  }
  const long count = FlatComponents(type);
  if (count < 0 || value.numbers.empty()) return std::nullopt;
  Value result{type, {}, {}};
  const auto wanted = static_cast<std::size_t>(count);
  if (value.numbers.size() == 1 && value.type.is_numeric())
    result.numbers.assign(wanted, value.numbers[0]);
  else if (value.type.is_numeric() && type.is_numeric() && ExplicitlyConvertible(value.type, type))
    result.numbers = Truncated(value, type);
  else if (value.numbers.size() >= wanted)
    result.numbers.assign(value.numbers.begin(), value.numbers.begin() + count);
  else
    return std::nullopt;
  std::vector<Scalar> scalars;
  AppendFlatScalars(type, scalars);
  for (std::size_t i = 0; i < wanted; ++i) result.numbers[i] = RoundToScalar(result.numbers[i], scalars[i]);
  return result;
}

Value ZeroValue(const Type& type) {
  Value value{type, {}, {}};
  if (type.kind == TypeKind::kString) {
    std::size_t count = 1;
    for (const std::uint32_t size : type.array) count *= size;
    value.strings.resize(count);
  } else if (const long count = FlatComponents(type); count > 0) {
    value.numbers.resize(static_cast<std::size_t>(count));
  }
  return value;
}

}  // namespace burin::fx

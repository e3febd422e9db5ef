// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "fx_parser/glsl/function_writer.h"
#include "fx_parser/semantics/constant.h"
#include "fx_parser/semantics/conversion.h"

namespace burin::fx {
namespace {

const char* Sign(ast::BinaryOperator op) {
  using enum ast::BinaryOperator;
  switch (op) {
    case kMul:
      return " * ";
    case kDiv:
      return " / ";
    case kAdd:
      return " + ";
    case kSub:
      return " - ";
    case kShl:
      return " << ";
    case kShr:
      return " >> ";
    case kLess:
      return " < ";
    case kGreater:
      return " > ";
    case kLessEqual:
      return " <= ";
    case kGreaterEqual:
      return " >= ";
    case kEqual:
      return " == ";
    case kNotEqual:
      return " != ";
    case kBitAnd:
      return " & ";
    case kBitXor:
      return " ^ ";
    case kBitOr:
      return " | ";
    default:
      return " + ";
  }
}

const char* VectorComparison(ast::BinaryOperator op) {
  using enum ast::BinaryOperator;
  switch (op) {
    case kLess:
      return "lessThan";
    case kGreater:
      return "greaterThan";
    case kLessEqual:
      return "lessThanEqual";
    case kGreaterEqual:
      return "greaterThanEqual";
    case kEqual:
      return "equal";
    default:
      return "notEqual";
  }
}

bool IsBitwise(ast::BinaryOperator op) {
  using enum ast::BinaryOperator;
  return op == kShl || op == kShr || op == kBitAnd || op == kBitXor || op == kBitOr;
}

/// The type of one column of the GLSL matrix that holds `type`.
Type ColumnType(const Type& type) { return VectorType(Scalar::kFloat, type.columns); }

}  // namespace

std::string FunctionWriter::Prelude(const char* name, const Storage& storage) {
  return stage_.PreludeName(name, StorageText(storage));
}

template <class Form>
std::string FunctionWriter::ByColumns(const Type& type, const std::vector<std::string>& operands,
                                      const std::vector<Type>& types, Form form) {
  std::string setup;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    names.push_back(StorageOf(types[i]).is_matrix() ? Reusable(operands[i], types[i], setup) : operands[i]);
  }
  std::string text = StorageText(StorageOf(type)) + "(";
  for (int column = 0; column < StorageOf(type).columns; ++column) {
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < names.size(); ++i) {
      parts.push_back(StorageOf(types[i]).is_matrix() ? names[i] + "[" + std::to_string(column) + "]" : names[i]);
    }
    text += (column > 0 ? ", " : "") + form(parts);
  }
  return Sequence(setup, text + ")");
}

std::string FunctionWriter::MatrixSelect(const Type& type, const std::string& condition, const std::string& a,
                                         const std::string& b) {
  const Type matrix = MatrixType(Scalar::kFloat, type.rows, type.columns);
  return ByColumns(type, {condition, a, b}, {matrix, matrix, matrix},
                   [](const auto& p) { return "mix(" + p[2] + ", " + p[1] + ", " + p[0] + ")"; });
}

std::string FunctionWriter::Arithmetic(ast::BinaryOperator op, const Type& common, const std::string& a,
                                       const Type& a_type, const std::string& b, const Type& b_type,
                                       bool divisor_is_safe) {
  using enum ast::BinaryOperator;
  const Storage storage = StorageOf(common);
  const bool is_float = IsFloating(common.scalar);
  // GLSL takes a scalar beside a vector or matrix in arithmetic.
  const bool keep_scalars = op == kMul || op == kAdd || op == kSub || (op == kDiv && is_float && divisor_is_safe);
  const auto operand = [&](const std::string& text, const Type& type) {
    return Convert(text, type, keep_scalars && type.components() == 1 ? ScalarType(common.scalar) : common);
  };
  const std::string left = operand(a, a_type);
  const std::string right = operand(b, b_type);
  const bool both_whole = a_type.components() > 1 && b_type.components() > 1;
  if (storage.is_matrix() && IsBitwise(op)) return MatrixBits(op, common, left, right);
  if (storage.is_matrix()) {
    const Type column = ColumnType(common);
    if (op == kMul && both_whole) return "matrixCompMult(" + left + ", " + right + ")";
    if (op == kAdd || op == kSub || op == kMul) return "(" + left + Sign(op) + right + ")";
    const bool truncate = !is_float;
    return ByColumns(common, {left, right},
                     {a_type.components() == 1 && keep_scalars ? ScalarType(common.scalar) : common,
                      b_type.components() == 1 && keep_scalars ? ScalarType(common.scalar) : common},
                     [&](const auto& p) {
                       const char* name = op == kDiv ? "burin_div" : "burin_fmod";
                       if (op == kDiv && divisor_is_safe && !truncate) return "(" + p[0] + " / " + p[1] + ")";
                       const std::string call = Prelude(name, StorageOf(column)) + "(" + p[0] + ", " + p[1] + ")";
                       return truncate && op == kDiv ? "trunc(" + call + ")" : call;
                     });
  }
  if (op == kDiv && is_float && !divisor_is_safe)
    return Prelude("burin_div", storage) + "(" + left + ", " + right + ")";
  if (op == kDiv && !is_float) {
    return divisor_is_safe ? "(" + left + " / " + right + ")"
                           : Prelude("burin_idiv", storage) + "(" + left + ", " + right + ")";
  }
  if (op == kMod) return Prelude(is_float ? "burin_fmod" : "burin_imod", storage) + "(" + left + ", " + right + ")";
  return "(" + left + Sign(op) + right + ")";
}

/// Whole numbers of a matrix are held as floats, which have no bits.
std::string FunctionWriter::MatrixBits(ast::BinaryOperator op, const Type& type, const std::string& a,
                                       const std::string& b) {
  std::string setup;
  const std::string left = Reusable(a, type, setup);
  const std::string right = Reusable(b, type, setup);
  std::vector<std::string> a_parts, b_parts;
  Components(left, type, a_parts);
  Components(right, type, b_parts);
  std::string list;
  for (std::size_t i = 0; i < a_parts.size(); ++i) {
    list += (i > 0 ? ", " : "") + std::string("float(int(") + a_parts[i] + ")" + Sign(op) + "int(" + b_parts[i] + "))";
  }
  return Sequence(setup, StorageText(StorageOf(type)) + "(" + list + ")");
}

std::string FunctionWriter::Comparison(ast::BinaryOperator op, const Type& common, const std::string& a,
                                       const std::string& b) {
  const Storage storage = StorageOf(common);
  if (storage.is_matrix()) {
    return ByColumns(common, {a, b}, {common, common}, [&](const auto& p) {
      return "vec" + std::to_string(storage.size) + "(" + VectorComparison(op) + "(" + p[0] + ", " + p[1] + "))";
    });
  }
  if (storage.size == 1) return "(" + a + Sign(op) + b + ")";
  return std::string(VectorComparison(op)) + "(" + a + ", " + b + ")";
}

std::string FunctionWriter::Logic(ast::BinaryOperator op, const ast::Binary& n, const Type& result) {
  const bool is_and = op == ast::BinaryOperator::kAnd;
  const std::string a = ExpressionAs(*n.left, result);
  const std::string b = ExpressionAs(*n.right, result);
  const Storage storage = StorageOf(result);
  if (storage.is_matrix()) {  // of 0 and 1
    return ByColumns(result, {a, b}, {result, result},
                     [&](const auto& p) { return std::string(is_and ? "min(" : "max(") + p[0] + ", " + p[1] + ")"; });
  }
  if (storage.size == 1 && !NeedsEveryInvocation(*n.right)) return "(" + a + (is_and ? " && " : " || ") + b + ")";
  return Prelude(is_and ? "burin_and" : "burin_or", storage) + "(" + a + ", " + b + ")";
}

std::string FunctionWriter::Negated(const Type& type, const std::string& text) {
  const Storage storage = StorageOf(type);
  if (storage.is_matrix()) {
    return ByColumns(type, {text}, {type}, [&](const auto& p) { return "(1.0 - " + p[0] + ")"; });
  }
  return storage.size == 1 ? "!(" + text + ")" : "not(" + text + ")";
}

std::string FunctionWriter::Emit(const ast::Expression& e, const ast::Unary& n) {
  switch (n.op) {
    case ast::UnaryOperator::kPlus:
      return ExpressionAs(*n.operand, e.type);
    case ast::UnaryOperator::kNegate:
      return "(-" + ExpressionAs(*n.operand, e.type) + ")";
    case ast::UnaryOperator::kBitNot:
      if (StorageOf(e.type).is_matrix()) return "(-1.0 - " + ExpressionAs(*n.operand, e.type) + ")";
      return "(~" + ExpressionAs(*n.operand, e.type) + ")";
    case ast::UnaryOperator::kNot:
      return "(" + Negated(e.type, ExpressionAs(*n.operand, e.type)) + ")";
    default:
      break;
  }
  const bool is_post = n.op == ast::UnaryOperator::kPostIncrement || n.op == ast::UnaryOperator::kPostDecrement;
  const bool is_up = n.op == ast::UnaryOperator::kPreIncrement || n.op == ast::UnaryOperator::kPostIncrement;
  const Lvalue target = Target(*n.operand);
  if (e.type.scalar != Scalar::kBool && IsDirect(target, e.type)) {
    const char* sign = is_up ? "++" : "--";
    return "(" + (is_post ? target.text + sign : sign + target.text) + ")";
  }
  const Type one = ScalarType(Scalar::kInt);
  const auto common = CommonType(e.type, one);
  const auto op = is_up ? ast::BinaryOperator::kAdd : ast::BinaryOperator::kSub;
  if (!is_post) return Store(target, Arithmetic(op, *common, Read(target), e.type, "1", one, true), *common);
  const std::string before = NewTemporary(e.type);
  Lvalue rest = target;
  const std::string setup = (rest.setup.empty() ? "" : rest.setup + ", ") + before + " = " + Read(target);
  rest.setup.clear();
  return "(" + setup + ", " + Store(rest, Arithmetic(op, *common, before, e.type, "1", one, true), *common) + ", " +
         before + ")";
}

std::string FunctionWriter::Emit(const ast::Expression& e, const ast::Binary& n) {
  using enum ast::BinaryOperator;
  if (n.op == kComma) {
    const std::string left = Expression(*n.left);
    return "(" + left + ", " + Expression(*n.right) + ")";
  }
  if (n.op == kAnd || n.op == kOr) return Logic(n.op, n, e.type);
  const auto common = CommonType(n.left->type, n.right->type);
  if (!common) return "0";
  if (n.op >= kLess && n.op <= kNotEqual) {
    const std::string left = ExpressionAs(*n.left, *common);
    return Comparison(n.op, *common, left, ExpressionAs(*n.right, *common));
  }
  bool safe = false;
  if (n.op == kDiv) {
    const auto divisor = Evaluate(*n.right);
    safe = divisor && std::ranges::none_of(divisor->numbers, [](double x) { return x == 0; });
  }
  const std::string left = Expression(*n.left);
  return Arithmetic(n.op, *common, left, n.left->type, Expression(*n.right), n.right->type, safe);
}

std::string FunctionWriter::AnyAll(const std::string& name, const std::string& text, const Type& type) {
  const Type test = WithScalar(type, Scalar::kBool);
  const std::string value = Convert(text, type, test);
  const Storage storage = StorageOf(test);
  if (storage.size == 1 && !storage.is_matrix()) return value;
  if (!storage.is_matrix()) return name + "(" + value + ")";
  std::string setup;
  const std::string matrix = Reusable(value, test, setup);
  std::string list;
  for (int i = 0; i < storage.columns; ++i) {
    list += (i > 0 ? (name == "all" ? " && " : " || ") : "") + name + "(notEqual(" + matrix + "[" + std::to_string(i) +
            "], vec" + std::to_string(storage.size) + "(0.0)))";
  }
  return Sequence(setup, "(" + list + ")");
}

std::string FunctionWriter::Componentwise(const Intrinsic& intrinsic, const IntrinsicCall& call,
                                          const std::vector<std::string>& arguments) {
  const auto form = [&](const std::vector<std::string>& texts, const Storage& storage) {
    const std::string glsl(intrinsic.glsl);
    std::string text;
    if (glsl.find('$') != std::string::npos) {
      for (std::size_t i = 0; i < glsl.size(); ++i) {
        if (glsl[i] == '$')
          text += texts[static_cast<std::size_t>(glsl[++i] - '0')];
        else
          text += glsl[i];
      }
      return text;
    }
    text = glsl.starts_with("burin_") ? Prelude(glsl.c_str(), storage) : glsl;
    text += "(";
    for (std::size_t i = 0; i < texts.size(); ++i) text += (i > 0 ? ", " : "") + texts[i];
    return text + ")";
  };
  const Storage storage = StorageOf(call.parameters[0]);
  const bool shaped = call.result.is_numeric() && StorageOf(call.result).is_matrix();
  if (!storage.is_matrix() || !shaped || intrinsic.name == "transpose") {
    if (storage.is_matrix() && intrinsic.name == "clip") {
      std::string setup;
      const std::string m = Reusable(arguments[0], call.parameters[0], setup);
      std::string list;
      Storage column = storage;
      column.columns = 1;
      for (int i = 0; i < storage.columns; ++i)
        list += (i > 0 ? ", " : "") + form({m + "[" + std::to_string(i) + "]"}, column);
      return "(" + (setup.empty() ? list : setup + ", " + list) + ")";
    }
    return form(arguments, storage);
  }
  Storage column = storage;
  column.columns = 1;
  const bool to_float = !IsFloating(call.result.scalar);
  return ByColumns(call.result, arguments, call.parameters, [&](const auto& p) {
    const std::string text = form(p, column);
    return to_float ? "vec" + std::to_string(column.size) + "(" + text + ")" : text;
  });
}

}  // namespace burin::fx

// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/glsl/function_writer.h"
#include "fx_parser/glsl/interface.h"
#include "fx_parser/semantics/constant.h"
#include "fx_parser/semantics/conversion.h"

namespace burin::fx {
namespace {

constexpr char kLetters[] = "xyzw";

std::string Subscript(int i) { return "[" + std::to_string(i) + "]"; }

Storage ScalarStorage(const Storage& storage) {
  Storage scalar = storage;
  scalar.columns = 1;
  scalar.size = 1;
  return scalar;
}

/// One component of a matrix as GLSL holds it, which for a matrix of one line is a vector.
std::string MatrixComponent(const std::string& text, const Type& type, const SwizzleComponent& c) {
  const Storage storage = StorageOf(type);
  if (storage.is_matrix()) return text + Subscript(c.row) + "." + kLetters[c.column];
  if (storage.size == 1) return text;
  return text + "." + kLetters[type.rows == 1 ? c.column : c.row];
}

}  // namespace

/// An index that cannot leave the array: constants were checked, others are clamped.
std::string FunctionWriter::IndexText(const ast::Expression& index, std::uint32_t count) {
  if (const auto value = Evaluate(index)) {
    return std::to_string(static_cast<long>(RoundToScalar(value->numbers[0], Scalar::kInt)));
  }
  const std::string text = ExpressionAs(index, ScalarType(Scalar::kInt));
  return "clamp(" + text + ", 0, " + std::to_string(count - 1) + ")";
}

std::string FunctionWriter::ElementText(const std::string& text, const Type& type, const std::string& index) {
  if (type.is_array()) return text + "[" + index + "]";
  const Storage storage = StorageOf(type);
  if (storage.size == 1 && !storage.is_matrix()) return text;  // float1
  if (type.is_matrix && type.rows == 1) return text;           // its only row
  return text + "[" + index + "]";
}

std::string FunctionWriter::SwizzleText(const std::string& text, const Type& type,
                                        const std::vector<SwizzleComponent>& swizzle) {
  const Storage storage = StorageOf(type);
  const Type result = SwizzleType(type, swizzle.size());
  if (type.is_matrix) {
    std::string setup;
    const std::string matrix = Reusable(text, type, setup);
    std::string list;
    for (const auto& c : swizzle) list += (list.empty() ? "" : ", ") + MatrixComponent(matrix, type, c);
    const bool convert = !IsFloating(type.scalar);
    if (swizzle.size() > 1 || convert) list = StorageText(StorageOf(result)) + "(" + list + ")";
    return Sequence(setup, list);
  }
  if (storage.size == 1) return swizzle.size() == 1 ? text : StorageText(StorageOf(result)) + "(" + text + ")";
  std::string letters;
  for (const auto& c : swizzle) letters += kLetters[c.column];
  return (IsSimpleText(text) || text.back() == ')' ? text : "(" + text + ")") + "." + letters;
}

FunctionWriter::Lvalue FunctionWriter::Target(const ast::Expression& e) {
  if (const auto* member = std::get_if<ast::Member>(&e.node)) return MemberTarget(e, *member);
  if (const auto* index = std::get_if<ast::Index>(&e.node)) return IndexTarget(e, *index);
  Lvalue target;
  target.type = e.type;
  if (const auto* name = std::get_if<ast::Name>(&e.node); name != nullptr && name->variable != nullptr) {
    target.text = stage_.VariableName(*name->variable);
  }
  if (e.type.is_numeric()) target.storage = StorageOf(e.type);
  return target;
}

FunctionWriter::Lvalue FunctionWriter::MemberTarget(const ast::Expression& e, const ast::Member& n) {
  Lvalue target = Target(*n.operand);
  const Type operand = n.operand->type;
  target.type = e.type;
  if (operand.kind == TypeKind::kStruct) {
    target.text += "." + GlslMemberName(n.name);
    if (e.type.is_numeric()) target.storage = StorageOf(e.type);
    return target;
  }
  const auto swizzle = ParseSwizzle(operand, n.name);
  if (!swizzle) return target;
  if (operand.is_matrix) {
    target.storage = StorageOf(operand);
    target.storage.columns = 1;
    target.storage.size = static_cast<int>(swizzle->size());
    if (swizzle->size() == 1) {
      target.text = MatrixComponent(target.text, operand, swizzle->front());
    } else {
      target.scattered = *swizzle;
      target.matrix = operand;
    }
    return target;
  }
  if (target.storage.size == 1) {
    return target;  // .x of a scalar
  }
  if (!target.scattered.empty()) {  // m._m00_m11.yx: choose among the scattered components
    std::vector<SwizzleComponent> chosen;
    for (const auto& c : *swizzle) chosen.push_back(target.scattered[static_cast<std::size_t>(c.column)]);
    if (chosen.size() == 1) {
      target.text = MatrixComponent(target.text, target.matrix, chosen.front());
      target.scattered.clear();
    } else {
      target.scattered = chosen;
    }
    target.storage.size = static_cast<int>(swizzle->size());
    return target;
  }
  target.text += ".";
  for (const auto& c : *swizzle) target.text += kLetters[c.column];
  target.storage.size = static_cast<int>(swizzle->size());
  return target;
}

FunctionWriter::Lvalue FunctionWriter::IndexTarget(const ast::Expression& e, const ast::Index& n) {
  Lvalue target = Target(*n.operand);
  const Type operand = n.operand->type;
  std::string index = IndexText(*n.index, ElementCount(operand));
  if (!IsSimpleText(index)) {
    const std::string name = NewTemporary(ScalarType(Scalar::kInt));
    target.setup += (target.setup.empty() ? "" : ", ") + name + " = " + index;
    index = name;
  }
  target.type = e.type;
  if (!target.scattered.empty()) {  // an element of a matrix swizzle: only constant ones have a place
    const auto value = Evaluate(*n.index);
    const auto at = value ? static_cast<std::size_t>(value->numbers[0]) : 0;
    if (!value)
      stage_.Error(n.index->range, "B1014", "an element of a matrix swizzle can only be assigned by a constant index");
    target.text =
        MatrixComponent(target.text, target.matrix, target.scattered[std::min(at, target.scattered.size() - 1)]);
    target.scattered.clear();
    target.storage = ScalarStorage(target.storage);
    return target;
  }
  target.text = ElementText(target.text, operand, index);
  if (operand.is_array()) {
    if (e.type.is_numeric()) target.storage = StorageOf(e.type);
  } else if (operand.is_matrix) {
    target.storage = StorageOf(operand);
    target.storage.columns = 1;
    target.storage.size = operand.columns;
  } else {
    target.storage = ScalarStorage(target.storage);
  }
  return target;
}

std::string FunctionWriter::Read(const Lvalue& target) {
  if (!target.scattered.empty()) return SwizzleText(target.text, target.matrix, target.scattered);
  return target.type.is_numeric() ? FromStorage(target.text, target.storage, target.type) : target.text;
}

bool FunctionWriter::IsDirect(const Lvalue& target, const Type& type) {
  if (!target.scattered.empty() || !target.setup.empty()) return false;
  if (!target.type.is_numeric() || !type.is_numeric()) return SameType(target.type, type);
  const bool whole_matrix = target.type.is_matrix && target.type.scalar != type.scalar;
  return target.storage == StorageOf(type) && !whole_matrix;
}

std::string FunctionWriter::Store(const Lvalue& target, const std::string& value, const Type& value_type) {
  std::string converted = Convert(value, value_type, target.type);
  if (target.scattered.empty()) {
    const bool is_numeric = target.type.is_numeric();
    const Storage held = is_numeric ? StorageOf(target.type) : Storage{};
    if (is_numeric && !(held == target.storage)) converted = StorageText(target.storage) + "(" + converted + ")";
    std::string text = target.text + " = " + converted;
    if (!target.setup.empty()) text = target.setup + ", " + text;
    if (is_numeric && !(held == target.storage)) text += ", " + Read(target);
    return "(" + text + ")";
  }
  std::string setup = target.setup;
  const std::string source = Reusable(converted, target.type, setup);
  const bool is_float = StorageOf(target.matrix).scalar == Scalar::kFloat;
  for (std::size_t i = 0; i < target.scattered.size(); ++i) {
    const std::string component = source + "." + kLetters[i];
    setup += (setup.empty() ? "" : ", ") + MatrixComponent(target.text, target.matrix, target.scattered[i]) + " = " +
             (is_float ? "float(" + component + ")" : component);
  }
  return "(" + setup + ", " + source + ")";
}

}  // namespace burin::fx

// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "fx_parser/glsl/function_writer.h"
#include "fx_parser/glsl/interface.h"
#include "fx_parser/semantics/conversion.h"

namespace burin::fx {
namespace {

constexpr char kLetters[] = "xyzw";

}  // namespace

std::string FunctionWriter::NewTemporary(const Type& type) {
  const std::string name = stage_.UniqueName("t_", std::to_string(temporaries_.size()));
  temporaries_ += "  " + stage_.TypeText(type) + " " + name + ";\n";
  return name;
}

std::string FunctionWriter::Reusable(const std::string& text, const Type& type, std::string& setup) {
  if (IsSimpleText(text)) return text;
  const std::string name = NewTemporary(type);
  setup += (setup.empty() ? "" : ", ") + name + " = " + text;
  return name;
}

std::string FunctionWriter::Sequence(const std::string& setup, const std::string& value) {
  return setup.empty() ? value : "(" + setup + ", " + value + ")";
}

/// A scalar or vector held as `from` becomes one of `to`, without change of size.
std::string FunctionWriter::ConvertScalar(const std::string& text, const Storage& from, Scalar to) {
  Storage result = from;
  result.scalar = IsFloating(to) ? Scalar::kFloat : to;
  if (result == from) return text;
  const bool is_literal = std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
  if (is_literal && result.scalar == Scalar::kFloat && result.size == 1) return text + ".0";
  return StorageText(result) + "(" + text + ")";
}

std::string FunctionWriter::FromStorage(const std::string& text, const Storage& held, const Type& type) {
  return ConvertScalar(text, held, StorageOf(type).scalar);
}

/// Appends one text for each component, in HLSL's order; `text` must be simple. Returns nothing useful for other kinds.
std::string FunctionWriter::Components(const std::string& text, const Type& type,
                                       std::vector<std::string>& components) {
  if (type.is_array()) {
    const Type element = *ElementType(type);
    for (std::uint32_t i = 0; i < type.array.front(); ++i)
      Components(text + "[" + std::to_string(i) + "]", element, components);
    return text;
  }
  if (type.kind == TypeKind::kStruct && type.structure != nullptr) {
    for (const auto& member : type.structure->members)
      Components(text + "." + GlslMemberName(member->name), member->type, components);
    return text;
  }
  const Storage storage = StorageOf(type);
  for (int column = 0; column < storage.columns; ++column) {
    const std::string line = storage.is_matrix() ? text + "[" + std::to_string(column) + "]" : text;
    if (storage.size == 1)
      components.push_back(line);
    else
      for (int i = 0; i < storage.size; ++i) components.push_back(line + "." + kLetters[i]);
  }
  return text;
}

/// Builds a value of any numeric, struct or array type from component texts of the given scalars.
std::string FunctionWriter::FromComponents(const Type& type, const std::vector<std::string>& components,
                                           const std::vector<Scalar>& scalars, std::size_t& next) {
  std::string text = stage_.TypeText(type) + "(";
  if (type.is_array()) {
    const Type element = *ElementType(type);
    for (std::uint32_t i = 0; i < type.array.front(); ++i)
      text += (i > 0 ? ", " : "") + FromComponents(element, components, scalars, next);
    return text + ")";
  }
  if (type.kind == TypeKind::kStruct && type.structure != nullptr) {
    const auto& members = type.structure->members;
    for (std::size_t i = 0; i < members.size(); ++i)
      text += (i > 0 ? ", " : "") + FromComponents(members[i]->type, components, scalars, next);
    return text + (members.empty() ? "0.0)" : ")");
  }
  const Storage wanted = StorageOf(type);
  for (int i = 0; i < type.components(); ++i) {
    std::string component = ConvertScalar(components[next], StorageOf(ScalarType(scalars[next])), type.scalar);
    ++next;
    // Matrices hold floats, so that an int or bool in one has to be made whole first.
    if (wanted.is_matrix() && !IsFloating(type.scalar)) component = "float(" + component + ")";
    if (wanted.size == 1 && wanted.columns == 1) return component;
    text += (i > 0 ? ", " : "") + component;
  }
  return text + ")";
}

std::string FunctionWriter::Convert(const std::string& text, const Type& from, const Type& to) {
  if (SameType(from, to) || from.kind == TypeKind::kError || to.kind == TypeKind::kError) return text;
  if (from.is_numeric() && to.is_numeric()) {
    const Storage have = StorageOf(from);
    const Storage want = StorageOf(to);
    const bool whole_matrix =
        (have.is_matrix() || want.is_matrix()) && from.scalar != to.scalar && !IsFloating(to.scalar);
    if (have == want && !whole_matrix) return text;
    if (!have.is_matrix() && !want.is_matrix() && !whole_matrix) {
      if (have.size == want.size) return ConvertScalar(text, have, want.scalar);
      if (have.size == 1) return StorageText(want) + "(" + text + ")";
      const std::string letters(kLetters, static_cast<std::size_t>(want.size));
      const std::string part = (IsSimpleText(text) ? text : "(" + text + ")") + "." + letters;
      Storage cut = have;
      cut.size = want.size;
      return ConvertScalar(part, cut, want.scalar);
    }
    if (have.is_matrix() && want.is_matrix() && !whole_matrix) return StorageText(want) + "(" + text + ")";
  }
  // The general way: component by component, in order; a matrix loses rows and columns, not its tail.
  std::string setup;
  const std::string source = Reusable(text, from, setup);
  std::vector<std::string> components;
  std::vector<Scalar> scalars;
  Components(source, from, components);
  AppendFlatScalars(from, scalars);
  // A component of an int matrix is held as a float.
  if (from.is_numeric() && StorageOf(from).is_matrix()) std::fill(scalars.begin(), scalars.end(), Scalar::kFloat);
  if (from.is_numeric() && to.is_numeric() && from.is_matrix && to.is_matrix && from.components() > 1) {
    std::vector<std::string> kept;
    for (int r = 0; r < to.rows; ++r) {
      for (int c = 0; c < to.columns; ++c) kept.push_back(components[static_cast<std::size_t>(r * from.columns + c)]);
    }
    components = std::move(kept);
  }
  if (components.size() == 1) {
    const auto wanted = static_cast<std::size_t>(std::max(FlatComponents(to), 1L));
    components.resize(wanted, components[0]);
    scalars.resize(wanted, scalars[0]);
  }
  std::size_t next = 0;
  return Sequence(setup, FromComponents(to, components, scalars, next));
}

/// Whether each element stands for exactly one member or element of `type`.
bool FunctionWriter::ListMatches(const std::vector<ast::ExpressionPtr>& elements, const Type& type) {
  std::vector<Type> parts;
  if (type.is_array())
    parts.assign(type.array.front(), *ElementType(type));
  else if (type.kind == TypeKind::kStruct && type.structure != nullptr) {
    for (const auto& member : type.structure->members) parts.push_back(member->type);
  } else if (type.is_numeric() && !type.is_matrix) {
    parts.assign(static_cast<std::size_t>(type.columns), ScalarType(type.scalar));
  }
  if (parts.size() != elements.size()) return false;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto* inner = std::get_if<ast::InitializerList>(&elements[i]->node);
    if (inner != nullptr) {
      if (parts[i].is_scalar() ? inner->elements.size() != 1 : !ListMatches(inner->elements, parts[i])) return false;
    } else if (FlatComponents(elements[i]->type) != FlatComponents(parts[i]) ||
               !ImplicitConversion(elements[i]->type, parts[i])) {
      return false;
    }
  }
  return true;
}

void FunctionWriter::FlattenList(const std::vector<ast::ExpressionPtr>& elements, std::string& setup,
                                 std::vector<std::string>& components, std::vector<Scalar>& scalars) {
  for (const auto& element : elements) {
    if (const auto* inner = std::get_if<ast::InitializerList>(&element->node)) {
      FlattenList(inner->elements, setup, components, scalars);
      continue;
    }
    const std::string text = Expression(*element);
    const bool is_single = FlatComponents(element->type) == 1 && element->type.is_numeric();
    Components(is_single ? text : Reusable(text, element->type, setup), element->type, components);
    const std::size_t before = scalars.size();
    AppendFlatScalars(element->type, scalars);
    if (element->type.is_numeric() && StorageOf(element->type).is_matrix()) {
      std::fill(scalars.begin() + static_cast<std::ptrdiff_t>(before), scalars.end(), Scalar::kFloat);
    }
  }
}

std::string FunctionWriter::List(const std::vector<ast::ExpressionPtr>& elements, const Type& type) {
  if (ListMatches(elements, type)) {
    const bool is_struct = type.kind == TypeKind::kStruct && !type.is_array();
    std::string text;
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const Type part = is_struct ? type.structure->members[i]->type : type.is_scalar() ? type : *ElementType(type);
      text += (i > 0 ? ", " : "") + ExpressionAs(*elements[i], part);
    }
    return stage_.TypeText(type) + "(" + text + ")";
  }
  std::string setup;
  std::vector<std::string> components;
  std::vector<Scalar> scalars;
  FlattenList(elements, setup, components, scalars);
  if (components.size() == 1) {
    const auto wanted = static_cast<std::size_t>(std::max(FlatComponents(type), 1L));
    components.resize(wanted, components[0]);
    scalars.resize(wanted, scalars[0]);
  }
  std::size_t next = 0;
  return Sequence(setup, FromComponents(type, components, scalars, next));
}

std::string FunctionWriter::ExpressionAs(const ast::Expression& e, const Type& type) {
  if (const auto* list = std::get_if<ast::InitializerList>(&e.node)) return List(list->elements, type);
  // Literals take their final form, which reads better than a conversion.
  if (type.is_numeric() && !type.is_matrix && type.components() == 1) {
    if (const auto* n = std::get_if<ast::IntLiteral>(&e.node); n != nullptr && IsFloating(type.scalar)) {
      return NumberText(static_cast<double>(n->value), Scalar::kFloat);
    }
  }
  return Convert(Expression(e), e.type, type);
}

std::string FunctionWriter::Initialisation(const std::string& name, const Type& type,
                                           const ast::Expression* initializer) {
  const std::string value = initializer != nullptr ? ExpressionAs(*initializer, type) : stage_.ZeroText(type);
  std::string text = temporaries_.empty() ? "" : "  {\n" + temporaries_;
  if (value.empty()) {
    text += "  for (int i = 0; i < " + std::to_string(type.array.front()) + "; ++i) " + name +
            "[i] = " + stage_.ZeroText(*ElementType(type)) + ";\n";
  } else {
    text += "  " + name + " = " + value + ";\n";
  }
  return text + (temporaries_.empty() ? "" : "  }\n");
}

}  // namespace burin::fx

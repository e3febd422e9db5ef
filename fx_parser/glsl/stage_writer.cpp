// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/glsl/stage_writer.h"

#include <algorithm>

#include "fx_parser/glsl/function_writer.h"
#include "fx_parser/glsl/interface.h"
#include "fx_parser/semantics/constant.h"
#include "fx_parser/semantics/conversion.h"
#include "fx_parser/semantics/host_parameter.h"

namespace burin::fx {
namespace {

/// Arrays above this many components are zeroed by a loop, not by a literal.
constexpr long kMaxLiteralComponents = 1024;

std::string DimensionText(Dimension dimension) {
  switch (dimension) {
    case Dimension::k1D:
      return "sampler1D";
    case Dimension::k3D:
      return "sampler3D";
    case Dimension::kCube:
      return "samplerCube";
    default:
      return "sampler2D";
  }
}

std::string ArraySuffix(const Type& type) {
  std::string text;
  for (const std::uint32_t size : type.array) text += "[" + std::to_string(size) + "]";
  return text;
}

}  // namespace

std::string SamplerNameOf(const SamplerBinding& binding) {
  if (binding.texture == nullptr) return PublicName(binding.sampler->name);
  return PublicName(binding.texture->name) + "_with_" + PublicName(binding.sampler->name) +
         (binding.element >= 0 ? "_" + std::to_string(binding.element) : "");
}

bool StageWriter::IsReported(const Range& range, const std::string& text) const {
  return std::ranges::any_of(diagnostics_.all(), [&](const Diagnostic& d) {
    return d.text == text && d.range.begin.file == range.begin.file && d.range.begin.line == range.begin.line &&
           d.range.begin.column == range.begin.column;
  });
}

void StageWriter::Error(const Range& range, const char* code, const std::string& text) {
  failed_ = true;
  if (!IsReported(range, text)) diagnostics_.Error(range, code, text);
}

void StageWriter::Warning(const Range& range, const char* code, const std::string& text) {
  if (!IsReported(range, text)) diagnostics_.Warning(range, code, text);
}

std::string StageWriter::StructName(const ast::Struct& structure) {
  if (const auto at = struct_names_.find(&structure); at != struct_names_.end()) return at->second;
  const std::string name = names_.Unique("T_", structure.name);
  std::string text = "struct " + name + " {\n";
  for (const auto& member : structure.members)
    text += "  " + TypeText(member->type) + " " + GlslMemberName(member->name) + ";\n";
  if (structure.members.empty()) text += "  float burin_empty;\n";
  structs_ += text + "};\n";
  struct_names_.emplace(&structure, name);
  return name;
}

std::string StageWriter::TypeText(const Type& type) {
  Type element = type;
  element.array.clear();
  std::string text = "void";
  if (type.kind == TypeKind::kStruct && type.structure != nullptr)
    text = StructName(*type.structure);
  else if (type.kind == TypeKind::kNumeric)
    text = StorageText(StorageOf(element));
  return text + ArraySuffix(type);
}

std::string StageWriter::ZeroText(const Type& type) {
  if (FlatComponents(type) > kMaxLiteralComponents) return "";
  std::size_t next = 0;
  const std::vector<double> zeros(static_cast<std::size_t>(std::max(FlatComponents(type), 0L)));
  return ValueText(type, zeros, next);
}

std::string StageWriter::ValueText(const Type& type, const std::vector<double>& numbers, std::size_t& next) {
  if (type.is_array()) {
    const Type element = *ElementType(type);
    std::string text = TypeText(type) + "(";
    for (std::uint32_t i = 0; i < type.array.front(); ++i)
      text += (i > 0 ? ", " : "") + ValueText(element, numbers, next);
    return text + ")";
  }
  if (type.kind == TypeKind::kStruct && type.structure != nullptr) {
    std::string text = TypeText(type) + "(";
    for (std::size_t i = 0; i < type.structure->members.size(); ++i) {
      text += (i > 0 ? ", " : "") + ValueText(type.structure->members[i]->type, numbers, next);
    }
    return text + (type.structure->members.empty() ? "0.0)" : ")");
  }
  const Storage storage = StorageOf(type);
  const std::size_t count = static_cast<std::size_t>(type.components());
  const auto first = numbers.begin() + static_cast<std::ptrdiff_t>(next);
  next += count;
  if (count == 1) return NumberText(*first, storage.scalar);
  const bool splat = !storage.is_matrix() && std::all_of(first, first + static_cast<std::ptrdiff_t>(count),
                                                         [&](double x) { return x == *first; });
  std::string text = StorageText(storage) + "(";
  for (std::size_t i = 0; i < (splat ? 1 : count); ++i)
    text += (i > 0 ? ", " : "") + NumberText(first[static_cast<std::ptrdiff_t>(i)], storage.scalar);
  return text + ")";
}

std::string StageWriter::DeclareParameter(const ast::Variable& variable) {
  const std::string uniform = "burin_p_" + PublicName(variable.name);
  parameters_.push_back(&variable);
  // The host gives every matrix as floats.
  const bool is_line = variable.type.is_numeric() && variable.type.is_matrix && !IsFloating(variable.type.scalar) &&
                       !StorageOf(variable.type).is_matrix();
  const Type given = is_line ? WithScalar(variable.type, Scalar::kFloat) : variable.type;
  globals_ += "uniform " + TypeText(given) + " " + uniform + ";\n";
  if (!written_.contains(&variable) && !is_line) return uniform;
  // Direct3D 9 lets a shader write to its parameters; each invocation then has its own copy.
  const std::string copy = names_.Unique("w_", variable.name);
  globals_ += TypeText(variable.type) + " " + copy + ";\n";
  const std::string value = is_line ? TypeText(variable.type) + "(" + uniform + ")" : uniform;
  initialisers_ += "  " + copy + " = " + value + ";\n";
  return copy;
}

bool StageWriter::DeclareConstant(const ast::Variable& variable) {
  if (variable.initializer == nullptr || (variable.qualifiers & ast::kConst) == 0) return false;
  const auto value = EvaluateAs(*variable.initializer, variable.type);
  if (!value || value->numbers.empty()) return false;
  const std::string name = names_.Unique("k_", variable.name);
  variable_names_[&variable] = name;
  std::size_t next = 0;
  const std::string type = TypeText(variable.type);
  globals_ += "const " + type + " " + name + " = " + ValueText(variable.type, value->numbers, next) + ";\n";
  return true;
}

std::string StageWriter::DeclareGlobal(const ast::Variable& variable) {
  if (IsHostParameter(variable)) return DeclareParameter(variable);
  if (DeclareConstant(variable)) return variable_names_[&variable];
  const std::string name = names_.Unique("g_", variable.name);
  variable_names_[&variable] = name;
  if (call_depth_ >= kMaxCallDepth) {
    Error(variable.range, "B1013",
          "the shader grows past what can be translated: initial values that need each other, nested too deeply");
    return name;
  }
  globals_ += TypeText(variable.type) + " " + name + ";\n";
  FunctionWriter writer(*this, {});
  // Written first: what the initialiser reads is initialised before it.
  ++call_depth_;
  const std::string text = writer.Initialisation(name, variable.type, variable.initializer.get());
  --call_depth_;
  initialisers_ += text;
  return name;
}

std::string StageWriter::VariableName(const ast::Variable& variable) {
  if (const auto at = variable_names_.find(&variable); at != variable_names_.end()) return at->second;
  const std::string name = variable.is_global ? DeclareGlobal(variable) : names_.Unique("l_", variable.name);
  variable_names_[&variable] = name;
  return name;
}

std::string StageWriter::SamplerName(const SamplerBinding& binding, Dimension dimension, const Range& range) {
  const auto [at, inserted] = samplers_.emplace(binding, dimension);
  if (inserted) {
    sampler_order_.push_back(binding);
  } else if (at->second != dimension) {
    Error(range, "B1012",
          "sampler '" + binding.sampler->name + "' is looked up as a " + DimensionText(dimension) + " here and as a " +
              DimensionText(at->second) + " elsewhere in the same shader");
  }
  const bool is_element = binding.element >= 0 && binding.texture == nullptr;
  return "burin_s_" + SamplerNameOf(binding) + (is_element ? "[" + std::to_string(binding.element) + "]" : "");
}

std::string StageWriter::PreludeName(const std::string& name, const std::string& type) {
  prelude_.insert({name, type});
  return name;
}

std::string StageWriter::FunctionName(const ast::Function& function, const SamplerBindings& bindings,
                                      const Range& call) {
  if (failed_) return {};
  const ast::Function* definition = checker_.Definition(function);
  if (definition == nullptr) {
    Error(call, "X3001", "function '" + function.name + "' is declared but has no body");
    return {};
  }
  InstanceKey key{definition, {}};
  SamplerBindings inner;
  for (std::size_t i = 0; i < definition->parameters.size(); ++i) {
    if (const auto at = bindings.find(function.parameters[i].get()); at != bindings.end()) {
      key.samplers.push_back(at->second);
      inner[definition->parameters[i].get()] = at->second;
    }
  }
  if (const auto at = instances_.find(key); at != instances_.end()) return at->second;
  if (instances_.size() >= kMaxInstances || functions_.size() > kMaxStageText || call_depth_ >= kMaxCallDepth) {
    Error(call, "B1013",
          "the shader grows past what can be translated: too many functions, or calls nested too deeply");
    return {};
  }
  const std::string name = names_.Unique("f_", definition->name);
  instances_.emplace(key, name);
  ++call_depth_;
  FunctionWriter writer(*this, inner);
  const std::string text = writer.Function(*definition, name);
  --call_depth_;
  functions_ += text;
  return name;
}

std::optional<Value> StageWriter::ConstantOf(const ast::Expression& expression) const {
  return Evaluate(expression, [this](const ast::Variable& variable) -> const Value* {
    const auto at = constants_.find(&variable);
    return at == constants_.end() ? nullptr : &at->second;
  });
}

std::string StageWriter::Declarations() const {
  std::string text;
  std::set<std::string> declared;
  for (const auto& [binding, dimension] : samplers_) {
    const std::string name = SamplerNameOf(binding);
    if (!declared.insert(name).second) continue;
    const bool is_array = binding.texture == nullptr;
    text += "uniform " + DimensionText(dimension) + " burin_s_" + name +
            (is_array ? ArraySuffix(binding.sampler->type) : "") + ";\n";
  }
  return structs_ + text + globals_ + PreludeText(prelude_) + functions_;
}

}  // namespace burin::fx

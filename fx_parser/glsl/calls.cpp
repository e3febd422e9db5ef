// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "fx_parser/glsl/function_writer.h"
#include "fx_parser/semantics/constant.h"
#include "fx_parser/semantics/conversion.h"
#include "fx_parser/semantics/methods.h"

namespace burin::fx {
namespace {

bool IsSampler(const Type& type) { return type.kind == TypeKind::kSampler || type.kind == TypeKind::kTexture; }

std::string Joined(const std::vector<std::string>& texts) {
  std::string list;
  for (const std::string& text : texts) list += (list.empty() ? "" : ", ") + text;
  return list;
}

void Append(std::string& list, const std::string& text) {
  if (!text.empty()) list += (list.empty() ? "" : ", ") + text;
}

}  // namespace

SamplerBinding FunctionWriter::ResolveSampler(const ast::Expression& e) {
  if (const auto* name = std::get_if<ast::Name>(&e.node); name != nullptr && name->variable != nullptr) {
    if (const auto at = bindings_.find(name->variable); at != bindings_.end()) return at->second;
    if (name->variable->is_global) return {name->variable, -1};
    stage_.Error(e.range, "B1015", "sampler parameter '" + name->name + "' has no sampler of the file bound to it");
    return {};
  }
  if (const auto* index = std::get_if<ast::Index>(&e.node)) {
    SamplerBinding binding = ResolveSampler(*index->operand);
    const auto at = stage_.ConstantOf(*index->index);
    if (binding.sampler == nullptr) return {};
    if (!at || at->numbers.empty() || binding.element >= 0) {
      stage_.Error(index->index->range, "X3512", "sampler array index must be a literal expression");
      return {};
    }
    const double element = at->numbers[0];
    const auto& sizes = binding.sampler->type.array;
    if (sizes.size() != 1 || !(element >= 0) || element >= sizes[0]) {
      stage_.Error(index->index->range, "X3504",
                   "index out of bounds: '" + binding.sampler->name + "' is a " + ToString(binding.sampler->type));
      return {};
    }
    binding.element = static_cast<int>(element);
    return binding;
  }
  if (const auto* cast = std::get_if<ast::Cast>(&e.node)) return ResolveSampler(*cast->operand);
  stage_.Error(e.range, "B1015", "a sampler of the file was expected here");
  return {};
}

FunctionWriter::OutArgument FunctionWriter::Out(const ast::Expression& e, const Type& parameter, bool also_in) {
  const Lvalue target = Target(e);
  if (IsDirect(target, parameter)) return {"", target.text, ""};
  OutArgument out;
  out.argument = NewTemporary(parameter);
  out.setup = target.setup;
  if (also_in) Append(out.setup, out.argument + " = " + Convert(Read(target), e.type, parameter));
  Lvalue after = target;
  after.setup.clear();
  out.after = Store(after, out.argument, parameter);
  return out;
}

std::string FunctionWriter::WithOuts(const std::string& setup, const std::string& call, const std::string& after,
                                     const Type& result) {
  if (setup.empty() && after.empty()) return call;
  std::string text = setup;
  if (after.empty() || result.kind == TypeKind::kVoid) {
    Append(text, call);
    Append(text, after);
    return "(" + text + ")";
  }
  const std::string value = NewTemporary(result);
  Append(text, value + " = " + call);
  Append(text, after);
  return "(" + text + ", " + value + ")";
}

std::string FunctionWriter::UserCall(const ast::Expression& e, const ast::Call& n) {
  const ast::Function& function = *n.function;
  SamplerBindings bindings;
  std::vector<std::string> arguments;
  std::string setup;
  std::string after;
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    const ast::Variable& parameter = *function.parameters[i];
    const ast::Expression* argument = i < n.arguments.size() ? n.arguments[i].get() : parameter.initializer.get();
    if (argument == nullptr) return "0";
    if (IsSampler(parameter.type)) {
      const SamplerBinding binding = ResolveSampler(*argument);
      if (binding.sampler == nullptr) return "0";
      bindings[&parameter] = binding;
    } else if ((parameter.qualifiers & ast::kOut) != 0) {
      const OutArgument out = Out(*argument, parameter.type, (parameter.qualifiers & ast::kIn) != 0);
      Append(setup, out.setup);
      Append(after, out.after);
      arguments.push_back(out.argument);
    } else {
      arguments.push_back(ExpressionAs(*argument, parameter.type));
    }
  }
  const std::string name = stage_.FunctionName(function, bindings, e.range);
  return WithOuts(setup, name + "(" + Joined(arguments) + ")", after, function.return_type);
}

/// The vertex stage has no derivatives: its look-ups take the top level, as those of Direct3D 9's vs_3_0 with level 0.
std::string FunctionWriter::Lookup(const ast::Call& n, const Intrinsic& intrinsic, const IntrinsicCall& call) {
  std::string chosen;  // the element's number, where it is known only as the shader runs
  std::string setup;
  std::vector<SamplerBinding> bindings = LookupSamplers(*n.arguments[0], chosen, setup);
  if (n.object != nullptr) {
    const ast::Variable* texture = ResolveSampler(*n.object).sampler;
    if (texture == nullptr) return "vec4(0.0)";
    for (SamplerBinding& binding : bindings) binding.texture = texture;
  }
  std::vector<std::string> texts = {""};
  for (std::size_t i = 1; i < n.arguments.size(); ++i) {
    std::string text = ExpressionAs(*n.arguments[i], call.parameters[i]);
    const std::string mark = "$" + std::to_string(i);
    const std::size_t first = intrinsic.glsl.find(mark);
    const bool twice =
        first != std::string_view::npos && intrinsic.glsl.find(mark, first + 1) != std::string_view::npos;
    texts.push_back(twice || bindings.size() > 1 ? Reusable(text, call.parameters[i], setup) : text);
  }
  std::string text;
  for (std::size_t i = 0; i < bindings.size(); ++i) {
    texts[0] = stage_.SamplerName(bindings[i], LookupDimension(intrinsic), n.arguments[0]->range);
    if (i + 1 < bindings.size()) text += chosen + " == " + std::to_string(i) + " ? ";
    text += LookupText(intrinsic, texts) + (i + 1 < bindings.size() ? " : " : "");
  }
  if (bindings.empty()) return "vec4(0.0)";
  if (bindings.size() > 1) text = "(" + text + ")";
  const auto components = static_cast<std::size_t>(call.result.components());
  if (components < 4) text += "." + std::string("xyzw").substr(0, components);
  return Sequence(setup, text);
}

/// One sampler, or all of an array whose element is chosen as the shader runs: then a look-up becomes a choice.
std::vector<SamplerBinding> FunctionWriter::LookupSamplers(const ast::Expression& e, std::string& chosen,
                                                           std::string& setup) {
  const auto* index = std::get_if<ast::Index>(&e.node);
  if (index == nullptr || stage_.ConstantOf(*index->index)) {
    const SamplerBinding binding = ResolveSampler(e);
    return binding.sampler == nullptr ? std::vector<SamplerBinding>() : std::vector{binding};
  }
  const SamplerBinding array = ResolveSampler(*index->operand);
  if (array.sampler == nullptr) return {};
  if (array.element >= 0 || array.sampler->type.array.size() != 1) {
    stage_.Error(e.range, "B1015", "a sampler of the file was expected here");
    return {};
  }
  const Type number = ScalarType(Scalar::kInt);
  chosen = Reusable(ExpressionAs(*index->index, number), number, setup);
  std::vector<SamplerBinding> elements;
  for (std::uint32_t i = 0; i < array.sampler->type.array[0]; ++i)
    elements.push_back({array.sampler, static_cast<int>(i)});
  return elements;
}

std::string FunctionWriter::LookupText(const Intrinsic& intrinsic, const std::vector<std::string>& texts) const {
  std::string form(intrinsic.glsl);
  if (stage_.stage() == Stage::kVertex && (intrinsic.traits & kImplicitDerivatives) != 0) {
    const bool projects = form.starts_with("textureProj");
    const std::size_t bias = form.find(", ($1).w)");
    form = (projects ? "textureProjLod" : "textureLod") + form.substr(projects ? 11 : 7);
    form.resize(bias != std::string::npos ? form.find(", ($1).w)") : form.size() - 1);
    form += ", 0.0)";
  }
  std::string text;
  for (std::size_t i = 0; i < form.size(); ++i) {
    if (form[i] == '$')
      text += texts[static_cast<std::size_t>(form[++i] - '0')];
    else
      text += form[i];
  }
  return text;
}

/// Matrices are held with HLSL's rows as GLSL's columns, so products swap sides. Those of one row or column are
/// vectors.
std::string FunctionWriter::Mul(const std::string& a, const Type& a_type, const std::string& b, const Type& b_type) {
  const auto is_scalar = [](const Type& t) { return t.components() == 1; };
  if (is_scalar(a_type) || is_scalar(b_type)) return "(" + a + " * " + b + ")";
  const bool a_row = a_type.is_vector || a_type.rows == 1;
  const bool b_column = b_type.is_vector || b_type.columns == 1;
  const bool a_full = StorageOf(a_type).is_matrix();
  const bool b_full = StorageOf(b_type).is_matrix();
  if (!a_full && !b_full) {
    if (a_row && b_column) return "dot(" + a + ", " + b + ")";
    return "outerProduct(" + b + ", " + a + ")";  // a column times a row
  }
  return "(" + b + " * " + a + ")";
}

/// asfloat, asint, asuint: the same bits as another scalar.
std::string FunctionWriter::Reinterpreted(const std::string& text, const Type& from, const Type& to) {
  if (StorageOf(from).is_matrix() || IsFloating(from.scalar) == IsFloating(to.scalar)) return Convert(text, from, to);
  const char* name = from.scalar == Scalar::kInt    ? "intBitsToFloat"
                     : from.scalar == Scalar::kUint ? "uintBitsToFloat"
                     : to.scalar == Scalar::kInt    ? "floatBitsToInt"
                                                    : "floatBitsToUint";
  return std::string(name) + "(" + text + ")";
}

std::string FunctionWriter::MethodText(const ast::Expression& e, const ast::Call& n) {
  const Intrinsic& method = Methods()[static_cast<std::size_t>(n.method)];
  std::vector<Type> types;
  for (const auto& argument : n.arguments) types.push_back(argument->type);
  auto call = ResolveIntrinsic(method, types);
  if (!call) return "0";
  if ((method.traits & kFragmentOnly) != 0 && stage_.stage() == Stage::kVertex) {
    stage_.Error(n.name_range, "X4532", "'" + n.name + "' cannot be used in a vertex shader");
    return "0";
  }
  call->result = WithScalar(e.type, Scalar::kFloat);
  return Convert(Lookup(n, method, *call), call->result, e.type);
}

std::string FunctionWriter::IntrinsicText(const ast::Expression& e, const ast::Call& n) {
  const Intrinsic& intrinsic = Intrinsics()[static_cast<std::size_t>(n.intrinsic)];
  std::vector<Type> types;
  for (const auto& argument : n.arguments) types.push_back(argument->type);
  const auto call = ResolveIntrinsic(intrinsic, types);
  if (!call) return "0";
  if ((intrinsic.traits & kFragmentOnly) != 0 && stage_.stage() == Stage::kVertex) {
    stage_.Error(n.name_range, "X4532", "'" + n.name + "' cannot be used in a vertex shader");
    return "0";
  }
  if (LookupDimension(intrinsic) != Dimension::kUnknown) return Lookup(n, intrinsic, *call);
  std::vector<std::string> arguments;
  std::string setup;
  std::string after;
  for (std::size_t i = 0; i < n.arguments.size(); ++i) {
    if (call->is_out[i]) {
      const OutArgument out = Out(*n.arguments[i], call->parameters[i], false);
      Append(setup, out.setup);
      Append(after, out.after);
      arguments.push_back(out.argument);
    } else {
      arguments.push_back(ExpressionAs(*n.arguments[i], call->parameters[i]));
    }
  }
  if (intrinsic.name == "mul") {
    const bool product = call->parameters[0].components() > 1 && call->parameters[1].components() > 1;
    const std::string text = Mul(arguments[0], call->parameters[0], arguments[1], call->parameters[1]);
    // GLSL's products are of floats.
    return product ? Convert(text, WithScalar(call->result, Scalar::kFloat), call->result) : text;
  }
  if (intrinsic.name == "any" || intrinsic.name == "all") return AnyAll(n.name, arguments[0], call->parameters[0]);
  const Type& first = call->parameters[0];
  if (intrinsic.glsl.empty()) return Reinterpreted(arguments[0], first, call->result);
  if (intrinsic.name == "transpose" && !StorageOf(first).is_matrix()) return arguments[0];
  if (intrinsic.name == "determinant" && first.components() == 1) return arguments[0];
  if (intrinsic.name == "sign" && !StorageOf(first).is_matrix()) {
    const Type sign = WithScalar(first, IsFloating(first.scalar) ? Scalar::kFloat : Scalar::kInt);
    return Convert("sign(" + arguments[0] + ")", sign, e.type);
  }
  return WithOuts(setup, Componentwise(intrinsic, *call, arguments), after, call->result);
}

std::string FunctionWriter::Emit(const ast::Expression& e, const ast::Call& n) {
  if (n.function != nullptr) return UserCall(e, n);
  if (n.method >= 0) return MethodText(e, n);
  if (n.intrinsic >= 0) return IntrinsicText(e, n);
  return "0";
}

}  // namespace burin::fx

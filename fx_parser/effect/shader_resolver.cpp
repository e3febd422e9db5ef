// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/effect/builder.h"
#include "fx_parser/effect/case.h"
#include "fx_parser/effect/profile.h"
#include "fx_parser/semantics/constant.h"
#include "fx_parser/semantics/portability.h"

namespace burin::fx {
namespace {

constexpr int kMaxShaderIndirection = 8;

std::size_t UniformCount(const ast::Function& function) {
  std::size_t count = 0;
  for (const auto& parameter : function.parameters) {
    const bool is_sampler = parameter->type.kind == TypeKind::kSampler || parameter->type.kind == TypeKind::kTexture;
    if (is_sampler || (parameter->qualifiers & ast::kUniform) != 0) ++count;
  }
  return count;
}

}  // namespace

const ast::Function* EffectBuilder::FindEntry(const ast::Compile& compile) {
  const auto candidates = checker_.FindFunctions(compile.function);
  if (candidates.empty()) {
    const std::string near = NearestName(compile.function, checker_.FunctionNames());
    diagnostics_.Error(
        compile.function_range, "X3501",
        "'" + compile.function + "': entrypoint not found" + (near.empty() ? "" : "; did you mean '" + near + "'?"));
    return nullptr;
  }
  // Overloads: the one whose uniform parameters the arguments fill.
  for (const ast::Function* candidate : candidates) {
    if (UniformCount(*candidate) == compile.arguments.size()) return candidate;
  }
  return candidates.front();
}

EffectBuilder::Shader EffectBuilder::ResolveCompile(ast::Compile& compile, const Range& range, bool vertex) {
  Shader shader;
  shader.present = true;
  const Profile profile = FindProfile(compile.profile);
  if (profile.stage == ProfileStage::kUnknown || profile.stage == ProfileStage::kOther) {
    shader.unsupported = "unknown or unsupported profile '" + compile.profile + "'";
    return shader;
  }
  const ProfileStage wanted = vertex ? ProfileStage::kVertex : ProfileStage::kPixel;
  if (profile.stage != ProfileStage::kEither && profile.stage != wanted) {
    diagnostics_.Error(compile.profile_range, "B1017",
                       "'" + compile.profile + "' is no profile of a " + (vertex ? "vertex" : "pixel") + " shader");
    shader.failed = true;
    return shader;
  }
  shader.entry.shader_model = profile.shader_model;
  shader.entry.range = range;
  shader.entry.function = FindEntry(compile);
  shader.failed = shader.entry.function == nullptr;
  for (auto& argument : compile.arguments) {
    if (checker_.CheckExpression(*argument).kind == TypeKind::kError) shader.failed = true;
    shader.entry.arguments.push_back(argument.get());
  }
  if (shader.failed) return shader;
  shader.unsupported = write_programs_ ? Unportable(*shader.entry.function, checker_) : "";
  std::size_t at = 0;
  for (const auto& parameter : shader.entry.function->parameters) {
    const bool is_sampler = parameter->type.kind == TypeKind::kSampler || parameter->type.kind == TypeKind::kTexture;
    if (!is_sampler && (parameter->qualifiers & ast::kUniform) == 0) continue;
    if (at < compile.arguments.size() && !checker_.RequireConversion(*compile.arguments[at], parameter->type))
      shader.failed = true;
    ++at;
  }
  return shader;
}

EffectBuilder::Shader EffectBuilder::ResolveShaderElement(ast::Index& index, const Range& range, bool vertex,
                                                          int depth) {
  Shader failed;
  failed.failed = true;
  const auto* name = std::get_if<ast::Name>(&index.operand->node);
  ast::Variable* array = name != nullptr ? checker_.FindGlobal(name->name) : nullptr;
  auto* list = array != nullptr && array->initializer != nullptr
                   ? std::get_if<ast::InitializerList>(&array->initializer->node)
                   : nullptr;
  if (list == nullptr) {
    diagnostics_.Error(range, "X3020", "an array of shaders was expected here");
    return failed;
  }
  if (checker_.CheckExpression(*index.index).kind == TypeKind::kError) return failed;
  std::map<const ast::Variable*, Value> defaults;
  const VariableLookup lookup = [&](const ast::Variable& variable) -> const Value* {
    if (!parameters_.contains(&variable)) return nullptr;
    return &defaults.try_emplace(&variable, effect_.parameters[parameters_.at(&variable)].default_value).first->second;
  };
  const auto value = EvaluateAs(*index.index, ScalarType(Scalar::kInt), lookup);
  const double at = value ? value->numbers[0] : -1;
  if (at < 0 || at >= static_cast<double>(list->elements.size())) {
    diagnostics_.Error(
        index.index->range, "X3504",
        "index out of bounds: '" + array->name + "' has " + std::to_string(list->elements.size()) + " shaders");
    return failed;
  }
  Shader shader = ResolveShader(*list->elements[static_cast<std::size_t>(at)], vertex, depth + 1);
  if (defaults.empty()) return shader;
  shader.choice = index.index.get();
  for (const auto& element : list->elements) shader.options.push_back(ResolveShader(*element, vertex, depth + 1));
  return shader;
}

EffectBuilder::Shader EffectBuilder::ResolveShader(ast::Expression& value, bool vertex, int depth) {
  Shader shader;
  if (depth > kMaxShaderIndirection) {
    diagnostics_.Error(value.range, "X3020", "shader variables name each other in a circle");
    shader.failed = true;
    return shader;
  }
  if (auto* compile = std::get_if<ast::Compile>(&value.node)) return ResolveCompile(*compile, value.range, vertex);
  if (std::holds_alternative<ast::AsmBlock>(value.node)) {
    shader.present = true;
    shader.unsupported = "asm shaders";
    return shader;
  }
  if (const auto* literal = std::get_if<ast::IntLiteral>(&value.node); literal != nullptr && literal->value == 0)
    return shader;
  if (auto* index = std::get_if<ast::Index>(&value.node))
    return ResolveShaderElement(*index, value.range, vertex, depth);
  if (const auto* name = std::get_if<ast::Name>(&value.node)) {
    if (EqualsIgnoringCase(name->name, "NULL")) return shader;
    const ast::Variable* variable = checker_.FindGlobal(name->name);
    const TypeKind wanted = vertex ? TypeKind::kVertexShader : TypeKind::kPixelShader;
    if (variable != nullptr && variable->type.kind == wanted && !variable->type.is_array()) {
      return variable->initializer != nullptr ? ResolveShader(*variable->initializer, vertex, depth + 1) : shader;
    }
    const auto near = checker_.FunctionNames();
    diagnostics_.Error(value.range, variable == nullptr ? "X3004" : "X3020",
                       variable == nullptr ? "undeclared identifier '" + name->name + "' as a shader"
                                           : "'" + name->name + "' is a " + ToString(variable->type) + ", a " +
                                                 (vertex ? "vertexshader" : "pixelshader") + " was expected");
    shader.failed = true;
    return shader;
  }
  diagnostics_.Error(value.range, "X3020", "a compile expression, a shader variable or NULL was expected here");
  shader.failed = true;
  return shader;
}

}  // namespace burin::fx

// SPDX-License-Identifier: Apache-2.0
// States of the fixed pipeline: D3DTEXTURESTAGESTATETYPE, D3DMATERIAL9, D3DLIGHT9 and transforms, as effect files name
// them.
#include "fx_parser/effect/fixed_builder.h"

#include <algorithm>

#include "fx_parser/effect/builder.h"
#include "fx_parser/effect/case.h"
#include "fx_parser/effect/state_table.h"
#include "fx_parser/glsl/fixed_pipeline.h"
#include "fx_parser/semantics/constant.h"

namespace burin::fx {
namespace {

constexpr Enumerant kOperations[] = {{"disable", 1},
                                     {"selectarg1", 2},
                                     {"selectarg2", 3},
                                     {"modulate", 4},
                                     {"modulate2x", 5},
                                     {"modulate4x", 6},
                                     {"add", 7},
                                     {"addsigned", 8},
                                     {"addsigned2x", 9},
                                     {"subtract", 10},
                                     {"addsmooth", 11},
                                     {"blenddiffusealpha", 12},
                                     {"blendtexturealpha", 13},
                                     {"blendfactoralpha", 14},
                                     {"blendtexturealphapm", 15},
                                     {"blendcurrentalpha", 16},
                                     {"premodulate", 17},
                                     {"modulatealpha_addcolor", 18},
                                     {"modulatecolor_addalpha", 19},
                                     {"modulateinvalpha_addcolor", 20},
                                     {"modulateinvcolor_addalpha", 21},
                                     {"bumpenvmap", 22},
                                     {"bumpenvmapluminance", 23},
                                     {"dotproduct3", 24},
                                     {"multiplyadd", 25},
                                     {"lerp", 26}};
constexpr Enumerant kArguments[] = {{"diffuse", 0},  {"current", 1},     {"texture", 2},
                                    {"tfactor", 3},  {"specular", 4},    {"temp", 5},
                                    {"constant", 6}, {"complement", 16}, {"alphareplicate", 32}};
constexpr Enumerant kCoordinates[] = {{"passthru", 0},
                                      {"cameraspacenormal", 1 << 16},
                                      {"cameraspaceposition", 2 << 16},
                                      {"cameraspacereflectionvector", 3 << 16},
                                      {"spheremap", 4 << 16}};
constexpr Enumerant kTransformFlags[] = {{"disable", 0}, {"count1", 1}, {"count2", 2},
                                         {"count3", 3},  {"count4", 4}, {"projected", 256}};
constexpr Enumerant kSources[] = {{"material", 0}, {"color1", 1}, {"color2", 2}};
constexpr Enumerant kLightTypes[] = {{"point", 1}, {"spot", 2}, {"directional", 3}};

struct NamedFixed {
  std::string_view name;
  FixedName state;
};
constexpr NamedFixed kValues[] = {{"WorldTransform", FixedName::kWorldTransform},
                                  {"ViewTransform", FixedName::kViewTransform},
                                  {"ProjectionTransform", FixedName::kProjectionTransform},
                                  {"TextureTransform", FixedName::kTextureTransform},
                                  {"MaterialDiffuse", FixedName::kMaterialDiffuse},
                                  {"MaterialAmbient", FixedName::kMaterialAmbient},
                                  {"MaterialSpecular", FixedName::kMaterialSpecular},
                                  {"MaterialEmissive", FixedName::kMaterialEmissive},
                                  {"MaterialPower", FixedName::kMaterialPower},
                                  {"Ambient", FixedName::kAmbient},
                                  {"TextureFactor", FixedName::kTextureFactor},
                                  {"Constant", FixedName::kConstant},
                                  {"LightEnable", FixedName::kLightEnable},
                                  {"LightType", FixedName::kLightType},
                                  {"LightDiffuse", FixedName::kLightDiffuse},
                                  {"LightSpecular", FixedName::kLightSpecular},
                                  {"LightAmbient", FixedName::kLightAmbient},
                                  {"LightPosition", FixedName::kLightPosition},
                                  {"LightDirection", FixedName::kLightDirection},
                                  {"LightRange", FixedName::kLightRange},
                                  {"LightFalloff", FixedName::kLightFalloff},
                                  {"LightAttenuation0", FixedName::kLightAttenuation0},
                                  {"LightAttenuation1", FixedName::kLightAttenuation1},
                                  {"LightAttenuation2", FixedName::kLightAttenuation2},
                                  {"LightTheta", FixedName::kLightTheta},
                                  {"LightPhi", FixedName::kLightPhi}};

bool IsNull(const ast::Expression& value) {
  if (const auto* name = std::get_if<ast::Name>(&value.node)) return EqualsIgnoringCase(name->name, "NULL");
  const auto* number = std::get_if<ast::IntLiteral>(&value.node);
  return number != nullptr && number->value == 0;
}

}  // namespace

/// A number that the shader text depends on: that of the parameters' initial values.
std::optional<int> EffectBuilder::FixedNumber(ast::StateAssignment& assignment, std::span<const Enumerant> values) {
  if (assignment.form != ast::StateAssignment::Form::kAngled) {
    if (const auto number = EnumerantValue(*assignment.value, values)) return number;
  }
  if (const auto* name = std::get_if<ast::Name>(&assignment.value->node);
      name != nullptr && checker_.FindGlobal(name->name) == nullptr) {
    diagnostics_.Warning(assignment.value->range, "B1009",
                         "unknown value '" + name->name + "' of " + assignment.name + " is ignored");
    return std::nullopt;
  }
  if (checker_.CheckExpression(*assignment.value).kind == TypeKind::kError) return std::nullopt;
  std::map<const ast::Variable*, Value> defaults;
  const VariableLookup lookup = [&](const ast::Variable& variable) -> const Value* {
    if (!parameters_.contains(&variable)) return nullptr;
    return &defaults.try_emplace(&variable, effect_.parameters[parameters_.at(&variable)].default_value).first->second;
  };
  const auto value = EvaluateAs(*assignment.value, ScalarType(Scalar::kInt), lookup);
  return value && !value->numbers.empty() ? std::optional(static_cast<int>(value->numbers[0])) : std::nullopt;
}

void EffectBuilder::AddFixedValue(ast::StateAssignment& assignment, FixedName name, int index, FixedPassStates& fixed) {
  FixedState state{.name = name, .index = index, .value = Value{}, .range = assignment.range};
  ast::Expression& value = *assignment.value;
  const bool is_light_type = name == FixedName::kLightType;
  if (assignment.form != ast::StateAssignment::Form::kAngled) {
    if (const auto number = EnumerantValue(
            value, is_light_type ? std::span<const Enumerant>(kLightTypes) : std::span<const Enumerant>())) {
      state.value = Value{ScalarType(Scalar::kInt), {static_cast<double>(*number)}, {}};
      fixed.states.push_back(std::move(state));
      return;
    }
  }
  if (std::holds_alternative<ast::InitializerList>(value.node)) {
    const auto& elements = std::get<ast::InitializerList>(value.node).elements;
    const Type type =
        elements.size() == 16
            ? MatrixType(Scalar::kFloat, 4, 4)
            : VectorType(Scalar::kFloat, static_cast<int>(std::clamp<std::size_t>(elements.size(), 1, 4)));
    checker_.CheckInitializer(value, type, assignment.name);
    if (auto constant = EvaluateAs(value, type)) {
      state.value = *std::move(constant);
      fixed.states.push_back(std::move(state));
    }
    return;
  }
  const Type type = checker_.CheckExpression(value);
  if (type.kind == TypeKind::kError) return;
  if (type.kind != TypeKind::kNumeric || type.is_array()) {
    diagnostics_.Error(value.range, "X3020", assignment.name + " takes numbers, found '" + ToString(type) + "'");
    return;
  }
  if (auto constant = Evaluate(value))
    state.value = *std::move(constant);
  else
    state.value = static_cast<const ast::Expression*>(&value);
  fixed.states.push_back(std::move(state));
}

bool EffectBuilder::BuildTextureOfStage(ast::StateAssignment& assignment, TextureStageStates& stage) {
  if (IsNull(*assignment.value)) {
    stage.has_no_texture = true;
    return true;
  }
  const auto* name = std::get_if<ast::Name>(&assignment.value->node);
  const ast::Variable* variable = name != nullptr ? checker_.FindGlobal(name->name) : nullptr;
  if (EqualsIgnoringCase(assignment.name, "Texture")) {
    const auto at = variable != nullptr ? textures_.find(variable) : textures_.end();
    if (at != textures_.end()) stage.texture = at->second;
    return at != textures_.end();
  }
  const auto at = variable != nullptr ? samplers_.find({variable, -1}) : samplers_.end();
  if (at != samplers_.end()) stage.sampler = at->second;
  return at != samplers_.end();
}

bool EffectBuilder::BuildStageState(ast::StateAssignment& assignment, TextureStageStates& stage) {
  const auto is = [&](std::string_view name) { return EqualsIgnoringCase(assignment.name, name); };
  if (is("ColorOp")) return stage.color_op = FixedNumber(assignment, kOperations), true;
  if (is("AlphaOp")) return stage.alpha_op = FixedNumber(assignment, kOperations), true;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string number = std::to_string(i);
    if (is("ColorArg" + number)) return stage.color_args[i] = FixedNumber(assignment, kArguments), true;
    if (is("AlphaArg" + number)) return stage.alpha_args[i] = FixedNumber(assignment, kArguments), true;
  }
  if (is("ResultArg")) return stage.result = FixedNumber(assignment, kArguments), true;
  if (is("TexCoordIndex")) return stage.texcoord = FixedNumber(assignment, kCoordinates), true;
  if (is("TextureTransformFlags")) return stage.transform_flags = FixedNumber(assignment, kTransformFlags), true;
  if (is("Texture") || is("Sampler")) return BuildTextureOfStage(assignment, stage);
  const auto* info = FindState(SamplerStates(), assignment.name);
  if (info == nullptr) return false;
  if (auto value = ResolveState(*assignment.value, std::string(info->name), static_cast<int>(info->kind), info->values,
                                assignment.form)) {
    stage.sampler_states.push_back({info->state, std::move(*value), assignment.range});
  }
  return true;
}

bool EffectBuilder::BuildFixedState(ast::StateAssignment& assignment, FixedPassStates& fixed) {
  const auto is = [&](std::string_view name) { return EqualsIgnoringCase(assignment.name, name); };
  int index = 0;
  if (assignment.index != nullptr) {
    if (checker_.CheckExpression(*assignment.index).kind == TypeKind::kError) return true;
    const auto value = EvaluateAs(*assignment.index, ScalarType(Scalar::kInt));
    index = value ? static_cast<int>(value->numbers[0]) : -1;
    if (index < 0 || index >= kFixedStages) return false;
  }
  if (is("Lighting")) return fixed.lighting = FixedNumber(assignment, {}).value_or(1) != 0, true;
  if (is("SpecularEnable")) return fixed.specular_enable = FixedNumber(assignment, {}).value_or(0) != 0, true;
  if (is("LocalViewer")) return fixed.local_viewer = FixedNumber(assignment, {}).value_or(1) != 0, true;
  if (is("NormalizeNormals") || is("ColorVertex")) return true;
  constexpr std::string_view kSourceNames[] = {"DiffuseMaterialSource", "SpecularMaterialSource",
                                               "AmbientMaterialSource", "EmissiveMaterialSource"};
  for (std::size_t i = 0; i < 4; ++i) {
    if (is(kSourceNames[i])) return fixed.sources[i] = FixedNumber(assignment, kSources), true;
  }
  for (const NamedFixed& named : kValues) {
    if (!is(named.name)) continue;
    // WorldTransform[1] and on are for blended vertices.
    if (index > 0 && named.state < FixedName::kTextureTransform) return true;
    AddFixedValue(assignment, named.state, index, fixed);
    return true;
  }
  const bool is_stage_state = assignment.index != nullptr || is("Texture") || is("Sampler") || is("TexCoordIndex") ||
                              is("TextureTransformFlags") || LowerCase(assignment.name).starts_with("colorop") ||
                              LowerCase(assignment.name).starts_with("colorarg") ||
                              LowerCase(assignment.name).starts_with("alphaop") ||
                              LowerCase(assignment.name).starts_with("alphaarg");
  return is_stage_state && BuildStageState(assignment, fixed.stages[index]);
}

/// The sampler of a stage, with the states that the pass adds; empty when it has no texture.
std::optional<std::size_t> EffectBuilder::SamplerOfStage(const TextureStageStates& stage, const std::string& name,
                                                         const Range& range) {
  if (!stage.texture && !stage.sampler) return std::nullopt;
  Sampler sampler;
  if (stage.sampler) sampler = effect_.samplers[*stage.sampler];
  if (stage.texture) {
    sampler.texture = stage.texture;
    sampler.dimension = effect_.textures[*stage.texture].dimension;
  }
  if (!stage.sampler) sampler.range = range;
  sampler.name = name;
  if (sampler.dimension == Dimension::kUnknown) sampler.dimension = Dimension::k2D;
  sampler.states.insert(sampler.states.end(), stage.sampler_states.begin(), stage.sampler_states.end());
  effect_.samplers.push_back(std::move(sampler));
  return effect_.samplers.size() - 1;
}

/// `own_texture`: the vertex shader gives texture coordinates, or none is there, so that an object's own texture is
/// looked up where the pass says nothing of the first stage, as the programs did that such files came with.
FixedPipeline EffectBuilder::MakeFixedPipeline(const FixedPassStates& fixed, const Pass& pass, bool own_texture,
                                               std::vector<std::size_t>& samplers) {
  FixedPipeline pipeline;
  pipeline.lighting = fixed.lighting.value_or(true);
  pipeline.specular = fixed.specular_enable.value_or(false);
  for (std::size_t i = 0; i < 4; ++i) pipeline.sources[i] = fixed.sources[i].value_or(0);
  constexpr int kDisable = 1, kSelectArg1 = 2, kModulate = 4, kTexture = 2;
  for (int i = 0; i < kFixedStages; ++i) {
    const auto at = fixed.stages.find(i);
    const TextureStageStates none;
    const TextureStageStates& states = at != fixed.stages.end() ? at->second : none;
    FixedStage stage;
    stage.color_op = states.color_op.value_or(i == 0 ? kModulate : kDisable);
    stage.alpha_op = states.alpha_op.value_or(i == 0 ? kSelectArg1 : kDisable);
    if (stage.color_op == kDisable) break;
    const bool is_textured = states.texture || states.sampler;
    for (std::size_t k = 0; k < 3; ++k) {
      // Without a texture the first argument is the diffuse colour, unless the pass says otherwise.
      const std::array<int, 3> usual = {1, is_textured || (i == 0 && own_texture && !states.has_no_texture) ? 2 : 0, 1};
      stage.color_args[k] = states.color_args[k].value_or(usual[k]);
      stage.alpha_args[k] = states.alpha_args[k].value_or(usual[k]);
    }
    stage.result = states.result.value_or(1);
    stage.texcoord = states.texcoord.value_or(i);
    const int flags = states.transform_flags.value_or(0);
    stage.transform_count = flags & 255;
    stage.is_projected = (flags & 256) != 0;
    const std::string name = "fixed_stage" + std::to_string(i);
    auto sampler = SamplerOfStage(states, name, pass.range);
    const bool asks_for_texture = (stage.color_args[1] & 15) == kTexture || (stage.color_args[2] & 15) == kTexture;
    const bool is_usual = at == fixed.stages.end() || (!states.has_no_texture && asks_for_texture);
    if (!sampler && i == 0 && own_texture && is_usual) {
      Sampler own;
      own.name = name;
      own.range = pass.range;
      own.states = {LinearFilter(SamplerStateName::kMinFilter, pass.range),
                    LinearFilter(SamplerStateName::kMagFilter, pass.range),
                    LinearFilter(SamplerStateName::kMipFilter, pass.range)};
      effect_.samplers.push_back(std::move(own));
      sampler = effect_.samplers.size() - 1;
      // An object without a texture keeps its own alpha.
      if (!states.alpha_op) stage.alpha_op = kModulate;
    }
    if (sampler) {
      stage.sampler = "burin_s_" + name;
      stage.dimension = effect_.samplers[*sampler].dimension;
      samplers.push_back(*sampler);
    } else if (at == fixed.stages.end() && i == 0) {
      break;  // the usual first stage without a texture hands the diffuse colour on
    }
    pipeline.stages.push_back(std::move(stage));
  }
  return pipeline;
}

SamplerState EffectBuilder::LinearFilter(SamplerStateName name, const Range& range) {
  constexpr double kLinear = 2;
  return {name, Value{ScalarType(Scalar::kInt), {kLinear}, {}}, range};
}

}  // namespace burin::fx

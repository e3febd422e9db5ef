// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/effect/builder.h"
#include "fx_parser/effect/case.h"
#include "fx_parser/effect/state_table.h"

namespace burin::fx {
namespace {

/// Direct3D 10's Filter names: MIN_MAG_MIP_LINEAR, MIN_MAG_LINEAR_MIP_POINT ... ANISOTROPIC. The kind that follows a
/// letter group holds for every group before it that has none yet. Also one of Direct3D 9's for all three.
bool ParseFilter(std::string_view text, int& min, int& mag, int& mip) {
  const std::string name = LowerCase(text);
  if (name == "anisotropic") {
    min = mag = 3;
    mip = 2;
    return true;
  }
  if (name == "none" || name == "point" || name == "linear") {
    min = mag = name == "linear" ? 2 : 1;
    mip = name == "linear" ? 2 : name == "point" ? 1 : 0;
    return true;
  }
  std::vector<int*> waiting;
  std::size_t begin = 0;
  bool any = false;
  while (begin <= name.size()) {
    const std::size_t end = std::min(name.find('_', begin), name.size());
    const std::string token = name.substr(begin, end - begin);
    if (token == "min")
      waiting.push_back(&min);
    else if (token == "mag")
      waiting.push_back(&mag);
    else if (token == "mip")
      waiting.push_back(&mip);
    else if (token == "linear" || token == "point") {
      for (int* filter : waiting) *filter = token == "linear" ? 2 : 1;
      any = any || !waiting.empty();
      waiting.clear();
    } else {
      return false;
    }
    begin = end + 1;
  }
  return any && waiting.empty();
}

SamplerState Constant(SamplerStateName name, int value, const Range& range) {
  return {name, Value{ScalarType(Scalar::kInt), {static_cast<double>(value)}, {}}, range};
}

/// Cg's minification filters name the mipmap filter too.
std::optional<int> ImpliedMipFilter(const ast::Expression& value) {
  const auto* name = std::get_if<ast::Name>(&value.node);
  if (name == nullptr) return std::nullopt;
  const std::string lower = LowerCase(name->name);
  if (lower.ends_with("mipmapnearest")) return 1;
  if (lower.ends_with("mipmaplinear")) return 2;
  return std::nullopt;
}

}  // namespace

void EffectBuilder::ResolveSamplerTexture(ast::StateAssignment& assignment, Sampler& sampler) {
  const auto* name = assignment.value != nullptr ? std::get_if<ast::Name>(&assignment.value->node) : nullptr;
  if (name == nullptr || EqualsIgnoringCase(name->name, "NULL")) {
    const auto* zero = assignment.value != nullptr ? std::get_if<ast::IntLiteral>(&assignment.value->node) : nullptr;
    if (name == nullptr && (zero == nullptr || zero->value != 0)) {
      diagnostics_.Error(assignment.range, "X3020",
                         "sampler '" + sampler.name + "': Texture takes the name of a texture");
    }
    return;
  }
  const ast::Variable* texture = checker_.FindGlobal(name->name);
  if (texture == nullptr) {
    std::vector<std::string> names;
    for (const Texture& candidate : effect_.textures) names.push_back(candidate.name);
    const std::string near = NearestName(name->name, names);
    diagnostics_.Error(
        assignment.value->range, "X3004",
        "undeclared identifier '" + name->name + "'" + (near.empty() ? "" : "; did you mean '" + near + "'?"));
    return;
  }
  const auto at = textures_.find(texture);
  if (at == textures_.end()) {
    if (texture->type.kind != TypeKind::kError) {
      diagnostics_.Error(assignment.value->range, "X3020",
                         "'" + name->name + "' is a " + ToString(texture->type) + ", a texture was expected");
    }
    return;
  }
  sampler.texture = at->second;
  assignment.value->type = texture->type;
}

void EffectBuilder::ResolveSamplerState(ast::StateAssignment& assignment, Sampler& sampler) {
  if (EqualsIgnoringCase(assignment.name, "Texture")) return ResolveSamplerTexture(assignment, sampler);
  if (assignment.value == nullptr) return;
  if (EqualsIgnoringCase(assignment.name, "Filter")) {
    const auto* name = std::get_if<ast::Name>(&assignment.value->node);
    int min = 1, mag = 1, mip = 1;
    if (name != nullptr && ParseFilter(name->name, min, mag, mip)) {
      sampler.states.push_back(Constant(SamplerStateName::kMinFilter, min, assignment.range));
      sampler.states.push_back(Constant(SamplerStateName::kMagFilter, mag, assignment.range));
      sampler.states.push_back(Constant(SamplerStateName::kMipFilter, mip, assignment.range));
      return;
    }
  }
  const auto* info = FindState(SamplerStates(), assignment.name);
  if (info == nullptr) {
    if (IsHarmlessSamplerState(assignment.name)) return;
    const std::string near = NearestName(assignment.name, KnownSamplerStates());
    diagnostics_.Warning(assignment.name_range, "B1009",
                         "unknown sampler state '" + assignment.name + "' is ignored" +
                             (near.empty() ? "" : "; did you mean '" + near + "'?"));
    return;
  }
  auto value = ResolveState(*assignment.value, std::string(info->name), static_cast<int>(info->kind), info->values,
                            assignment.form);
  if (!value) return;
  sampler.states.push_back({info->state, std::move(*value), assignment.range});
  if (info->state == SamplerStateName::kMinFilter) {
    if (const auto mip = ImpliedMipFilter(*assignment.value))
      sampler.states.push_back(Constant(SamplerStateName::kMipFilter, *mip, assignment.range));
  }
}

void EffectBuilder::BuildSampler(const ast::Variable& variable, int element, ast::Expression* initializer) {
  Sampler sampler;
  sampler.name = PublicName(variable.name) + (element >= 0 ? "[" + std::to_string(element) + "]" : "");
  sampler.dimension = variable.type.dimension;
  sampler.range = variable.range;
  auto* block = initializer != nullptr ? std::get_if<ast::StateBlockExpression>(&initializer->node) : nullptr;
  if (block != nullptr && block->block != nullptr) {
    for (ast::StateAssignment& assignment : block->block->states) ResolveSamplerState(assignment, sampler);
  } else if (initializer != nullptr) {
    diagnostics_.Error(initializer->range, "X3000", "sampler '" + variable.name + "': expected sampler_state { ... }");
  }
  const Texture* texture = sampler.texture ? &effect_.textures[*sampler.texture] : nullptr;
  const bool typed = sampler.dimension != Dimension::kUnknown;
  if (texture != nullptr && typed && texture->dimension != Dimension::kUnknown &&
      texture->dimension != sampler.dimension) {
    diagnostics_
        .Error(variable.range, "B1018",
               "sampler '" + sampler.name + "' is a " + ToString(variable.type) + ", but its texture '" +
                   texture->name + "' is not")
        .notes.push_back({texture->range, "'" + texture->name + "' was declared here"});
  }
  samplers_[{&variable, element}] = effect_.samplers.size();
  effect_.samplers.push_back(std::move(sampler));
}

void EffectBuilder::BuildSamplers() {
  for (ast::Variable* variable : checker_.globals()) {
    if (variable->type.kind != TypeKind::kSampler) continue;
    if (!variable->type.is_array()) {
      BuildSampler(*variable, -1, variable->initializer.get());
      continue;
    }
    auto* list =
        variable->initializer != nullptr ? std::get_if<ast::InitializerList>(&variable->initializer->node) : nullptr;
    if (variable->type.array.size() != 1 || variable->type.array[0] > 64) {
      diagnostics_.Error(variable->range, "X3059",
                         "'" + variable->name + "': an array of samplers has one dimension and at most 64 elements");
      continue;
    }
    for (std::uint32_t i = 0; i < variable->type.array[0]; ++i) {
      BuildSampler(*variable, static_cast<int>(i),
                   list != nullptr && i < list->elements.size() ? list->elements[i].get() : nullptr);
    }
  }
}

/// Pairs of a texture and a sampler of Direct3D 10 become samplers when a shader first uses them.
std::optional<std::size_t> EffectBuilder::FindSampler(const SamplerBinding& binding) {
  if (const auto at = samplers_.find(binding); at != samplers_.end()) return at->second;
  const auto own = samplers_.find({binding.sampler, binding.element, nullptr});
  const auto texture = textures_.find(binding.texture);
  if (own == samplers_.end() || texture == textures_.end()) return std::nullopt;
  Sampler sampler = effect_.samplers[own->second];
  sampler.name = SamplerNameOf(binding);
  sampler.texture = texture->second;
  sampler.dimension = effect_.textures[texture->second].dimension;
  samplers_[binding] = effect_.samplers.size();
  effect_.samplers.push_back(std::move(sampler));
  return effect_.samplers.size() - 1;
}

void EffectBuilder::ResolveDimensions() {
  for (Sampler& sampler : effect_.samplers) {
    Texture* texture = sampler.texture ? &effect_.textures[*sampler.texture] : nullptr;
    if (sampler.dimension == Dimension::kUnknown && texture != nullptr) sampler.dimension = texture->dimension;
    if (sampler.dimension == Dimension::kUnknown) sampler.dimension = Dimension::k2D;
    if (texture != nullptr && texture->dimension == Dimension::kUnknown) texture->dimension = sampler.dimension;
  }
  for (Texture& texture : effect_.textures) {
    if (texture.dimension == Dimension::kUnknown) texture.dimension = Dimension::k2D;
  }
}

}  // namespace burin::fx

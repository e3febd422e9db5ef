// SPDX-License-Identifier: Apache-2.0
// CgFX's states, which are OpenGL's: several values in one, and culling and stencil in OpenGL's terms. (Cg Toolkit 3.1,
// "CgFX states"; the values' meaning: OpenGL 2.1 specification, sections 3.5 and 4.1.)

#include <algorithm>
#include <array>
#include <cmath>

#include "fx_parser/effect/builder.h"
#include "fx_parser/effect/case.h"
#include "fx_parser/effect/state_table.h"
#include "fx_parser/semantics/constant.h"

namespace burin::fx {
namespace {

using enum RenderState;

// OpenGL's increments stop at the end of the range, Direct3D's INCR wraps.
constexpr Enumerant kStencilOps[] = {{"keep", 1},   {"zero", 2},     {"replace", 3},  {"incr", 4},    {"decr", 5},
                                     {"invert", 6}, {"incrwrap", 7}, {"decrwrap", 8}, {"incrsat", 4}, {"decrsat", 5}};
constexpr Enumerant kFills[] = {{"point", 1}, {"line", 2}, {"fill", 3}, {"wireframe", 2}, {"solid", 3}};
constexpr Enumerant kFaces[] = {{"front", 0}, {"back", 1}, {"frontandback", 2}};
constexpr Enumerant kWindings[] = {{"cw", 1}, {"ccw", 0}};
constexpr Enumerant kNone[] = {{"none", 0}};

/// The arguments of `int2(a, b)`; of anything else the value itself.
std::vector<ast::Expression*> Parts(ast::Expression& value) {
  std::vector<ast::Expression*> parts;
  if (auto* construct = std::get_if<ast::Construct>(&value.node)) {
    for (const auto& argument : construct->arguments) parts.push_back(argument.get());
  } else if (auto* list = std::get_if<ast::InitializerList>(&value.node)) {
    for (const auto& element : list->elements) parts.push_back(element.get());
  } else {
    parts.push_back(&value);
  }
  return parts;
}

Value Integer(double number) { return Value{ScalarType(Scalar::kInt), {number}, {}}; }

/// States whose parts are states of Direct3D, in order.
struct Compound {
  std::string_view name;
  std::array<std::optional<RenderState>, 4> parts;
  std::span<const Enumerant> values;  ///< of all parts; empty: of the states
};
constexpr Compound kCompounds[] = {
    {"BlendFunc", {kSrcBlend, kDestBlend}, {}},
    {"BlendFuncSeparate", {kSrcBlend, kDestBlend, kSrcBlendAlpha, kDestBlendAlpha}, {}},
    {"BlendEquation", {kBlendOp}, {}},
    {"BlendEquationSeparate", {kBlendOp, kBlendOpAlpha}, {}},
    {"StencilFunc", {kStencilFunc, kStencilRef, kStencilMask}, {}},
    {"StencilOp", {kStencilFail, kStencilZFail, kStencilPass}, kStencilOps},
};

const Compound* FindCompound(std::string_view name) {
  for (const Compound& compound : kCompounds) {
    if (EqualsIgnoringCase(compound.name, name)) return &compound;
  }
  return nullptr;
}

const StateInfo<RenderState>& InfoOf(RenderState state) {
  for (const auto& info : RenderStates()) {
    if (info.state == state) return info;
  }
  return RenderStates().front();
}

}  // namespace

void EffectBuilder::SetState(Pass& pass, RenderState state, ast::Expression& value, std::span<const Enumerant> values) {
  const auto& info = InfoOf(state);
  auto resolved = ResolveState(value, std::string(info.name), static_cast<int>(info.kind),
                               values.empty() ? info.values : values, ast::StateAssignment::Form::kPlain);
  if (resolved) pass.states.push_back({state, std::move(*resolved), value.range});
}

bool EffectBuilder::BuildCgState(ast::StateAssignment& assignment, Pass& pass, PassShaders& shaders) {
  const std::vector<ast::Expression*> parts = Parts(*assignment.value);
  const auto is = [&](std::string_view name) { return EqualsIgnoringCase(assignment.name, name); };
  const auto number = [&](std::size_t part, std::span<const Enumerant> values) -> std::optional<double> {
    if (part >= parts.size()) return std::nullopt;
    const auto value = ResolveState(*parts[part], assignment.name, static_cast<int>(StateKind::kFloat), values,
                                    ast::StateAssignment::Form::kPlain);
    const auto* constant = value ? std::get_if<Value>(&*value) : nullptr;
    return constant == nullptr ? std::nullopt : std::optional(constant->numbers[0]);
  };
  const auto set = [&](RenderState state, double value) {
    pass.states.push_back({state, Integer(value), assignment.range});
  };
  // D3D's StencilFunc and AlphaFunc take one value; CgFX's several.
  if (const Compound* compound = FindCompound(assignment.name);
      compound != nullptr && (parts.size() > 1 || !is("StencilFunc"))) {
    for (std::size_t i = 0; i < parts.size() && i < compound->parts.size() && compound->parts[i]; ++i)
      SetState(pass, *compound->parts[i], *parts[i], compound->values);
    if (is("BlendFuncSeparate") || is("BlendEquationSeparate")) set(kSeparateAlphaBlendEnable, 1);
    return true;
  }
  if (is("AlphaFunc") && parts.size() == 2) {
    SetState(pass, kAlphaFunc, *parts[0]);
    if (const auto reference = number(1, kNone)) set(kAlphaRef, std::round(std::clamp(*reference, 0.0, 1.0) * 255));
    return true;
  }
  if (is("ColorMask")) {
    int mask = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      if (number(parts.size() == 1 ? 0 : i, kNone).value_or(1) != 0) mask |= 1 << i;
    }
    set(kColorWriteEnable, mask);
    return true;
  }
  if (is("PolygonMode")) {
    SetState(pass, kFillMode, *parts.back(), kFills);
    return true;
  }
  if (is("PolygonOffset") && parts.size() == 2) {
    // A unit is the smallest difference of a depth buffer, of 24 bits in OpenGL's usual ones.
    const double units = number(1, kNone).value_or(0) / (1 << 24);
    SetState(pass, kSlopeScaleDepthBias, *parts[0]);
    pass.states.push_back({kDepthBias, Value{ScalarType(Scalar::kFloat), {units}, {}}, assignment.range});
    return true;
  }
  if (is("BlendColor")) {
    SetState(pass, kBlendFactor, *assignment.value);
    return true;
  }
  if (is("StencilMask") && LowerCase(effect_.path).ends_with(".cgfx")) {  // OpenGL's is what may be written
    SetState(pass, kStencilWriteMask, *assignment.value);
    return true;
  }
  if (is("CullFaceEnable")) {
    shaders.cull_enable = number(0, kNone).value_or(0) != 0;
    return true;
  }
  if (is("CullFace")) {
    shaders.cull_front = number(0, kFaces).value_or(1) == 0;
    return true;
  }
  if (is("FrontFace")) {
    shaders.front_is_clockwise = number(0, kWindings).value_or(0) != 0;
    return true;
  }
  return false;
}

// OpenGL culls nothing unless it is told to; what it culls are back faces, the clockwise ones, unless it is told
// otherwise.
void EffectBuilder::FinishCgCulling(Pass& pass, const PassShaders& shaders) {
  constexpr int kNoCulling = 1;
  constexpr int kClockwise = 2;
  constexpr int kCounterClockwise = 3;
  const bool is_cg = LowerCase(effect_.path).ends_with(".cgfx");
  const bool sets_d3d = std::any_of(pass.states.begin(), pass.states.end(),
                                    [](const PassState& state) { return state.name == kCullMode; });
  if (!shaders.cull_enable && (!is_cg || sets_d3d)) return;
  int mode = kNoCulling;
  // As Direct3D names it: what is counter-clockwise to it is the back of a model that is turned the usual way.
  if (shaders.cull_enable.value_or(false))
    mode = shaders.cull_front != shaders.front_is_clockwise ? kClockwise : kCounterClockwise;
  pass.states.push_back({kCullMode, Integer(mode), pass.range});
}

}  // namespace burin::fx

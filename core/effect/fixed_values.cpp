// SPDX-License-Identifier: Apache-2.0
#include "core/effect/fixed_values.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/matrix.hpp>
#include <span>

#include "core/effect/render_states.h"

namespace burin::effect {
namespace {

using fx::FixedName;

// Of lights that the scene does not say: what is all around.
constexpr float kAmbientLight = 0.25f;
constexpr float kDirectional = 3.0f;

class Slots {
 public:
  Slots() : numbers_(4u * fx::kFixedSlots, 0.0f) {}

  [[nodiscard]] std::span<float> At(int slot) {
    return std::span(numbers_).subspan(4u * static_cast<std::size_t>(slot));
  }
  void Set(int slot, const glm::vec4& v) {
    for (int i = 0; i < 4; ++i) At(slot)[static_cast<std::size_t>(i)] = v[i];
  }
  /// As rows for row vectors.
  void SetMatrix(int slot, const glm::mat4& column_vector_matrix) {
    for (int row = 0; row < 4; ++row) Set(slot + row, column_vector_matrix[row]);
  }
  [[nodiscard]] std::vector<float> Take() { return std::move(numbers_); }

 private:
  std::vector<float> numbers_;
};

int LightSlot(int light) { return fx::kSlotLights + fx::kLightSlots * light; }

// Where a state's components go, and how many there are at most; 0: handled apart.
struct Place {
  int slot = 0;
  int component = 0;
  int components = 4;
};

Place PlaceOf(const fx::FixedState& state) {
  const int light = LightSlot(state.index);
  switch (state.name) {
    case FixedName::kWorldTransform:
      return {fx::kSlotWorld, 0, 16};
    case FixedName::kViewTransform:
      return {fx::kSlotView, 0, 16};
    case FixedName::kProjectionTransform:
      return {fx::kSlotProjection, 0, 16};
    case FixedName::kTextureTransform:
      return {fx::kSlotTextureTransforms + 4 * state.index, 0, 16};
    case FixedName::kMaterialDiffuse:
      return {fx::kSlotMaterialDiffuse};
    case FixedName::kMaterialAmbient:
      return {fx::kSlotMaterialAmbient};
    case FixedName::kMaterialSpecular:
      return {fx::kSlotMaterialSpecular};
    case FixedName::kMaterialEmissive:
      return {fx::kSlotMaterialEmissive};
    case FixedName::kMaterialPower:
      return {fx::kSlotMaterialPower, 0, 1};
    case FixedName::kAmbient:
      return {fx::kSlotAmbient};
    case FixedName::kTextureFactor:
      return {fx::kSlotTextureFactor};
    case FixedName::kConstant:
      return {fx::kSlotConstants + state.index};
    case FixedName::kLightEnable:
    case FixedName::kLightType:
      return {light, 0, 1};
    case FixedName::kLightRange:
      return {light, 1, 1};
    case FixedName::kLightFalloff:
      return {light, 2, 1};
    case FixedName::kLightDiffuse:
      return {light + 1};
    case FixedName::kLightSpecular:
      return {light + 2};
    case FixedName::kLightAmbient:
      return {light + 3};
    case FixedName::kLightPosition:
      return {light + 4, 0, 3};
    case FixedName::kLightDirection:
      return {light + 5, 0, 3};
    case FixedName::kLightAttenuation0:
      return {light + 6, 0, 1};
    case FixedName::kLightAttenuation1:
      return {light + 6, 1, 1};
    case FixedName::kLightAttenuation2:
      return {light + 6, 2, 1};
    case FixedName::kLightTheta:
      return {light + 7, 0, 1};
    case FixedName::kLightPhi:
      return {light + 7, 1, 1};
  }
  return {};
}

bool IsColor(FixedName name) {
  return name == FixedName::kAmbient || name == FixedName::kTextureFactor || name == FixedName::kConstant ||
         (name >= FixedName::kMaterialDiffuse && name <= FixedName::kMaterialEmissive) ||
         (name >= FixedName::kLightDiffuse && name <= FixedName::kLightAmbient);
}

bool IsOfLight(FixedName name) { return name >= FixedName::kLightEnable; }

void SetSceneValues(const FrameContext& context, Slots& slots) {
  slots.SetMatrix(fx::kSlotWorld, context.world_from_object);
  slots.SetMatrix(fx::kSlotView, context.view_from_world);
  slots.SetMatrix(fx::kSlotProjection, context.clip_from_view);
  const MaterialContext& material = context.material;
  slots.Set(fx::kSlotMaterialDiffuse, material.diffuse);
  slots.Set(fx::kSlotMaterialAmbient, material.diffuse);
  slots.Set(fx::kSlotMaterialSpecular, glm::vec4(material.specular, 1.0f));
  slots.Set(fx::kSlotMaterialEmissive, glm::vec4(material.emissive, 1.0f));
  slots.Set(fx::kSlotMaterialPower, glm::vec4(material.specular_power));
  slots.Set(fx::kSlotAmbient, glm::vec4(glm::vec3(kAmbientLight), 1.0f));
  slots.Set(fx::kSlotTextureFactor, glm::vec4(1.0f));
  slots.Set(fx::kSlotEye, glm::vec4(context.eye_world, 1.0f));
  for (int stage = 0; stage < fx::kFixedStages; ++stage)
    slots.SetMatrix(fx::kSlotTextureTransforms + 4 * stage, glm::mat4(1.0f));
}

void SetKeyLight(const FrameContext& context, Slots& slots) {
  const int slot = LightSlot(0);
  slots.At(slot)[0] = kDirectional;
  slots.Set(slot + 1, context.light_color);
  slots.Set(slot + 2, context.light_color);
  slots.Set(slot + 5, glm::vec4(context.light_direction_world, 0.0f));
}

// Direct3D's own defaults are zeros, by which a light gives nothing: what a pass leaves out of a light is white, shines
// from the front and reaches everywhere.
void SetUsualLight(int light, Slots& slots) {
  constexpr float kEndless = 1.0e6f;
  const int slot = LightSlot(light);
  slots.Set(slot, {kDirectional, kEndless, 1.0f, 0.0f});
  slots.Set(slot + 1, glm::vec4(1.0f));
  slots.Set(slot + 5, {0.0f, 0.0f, -1.0f, 0.0f});
  slots.Set(slot + 6, {1.0f, 0.0f, 0.0f, 0.0f});
  slots.Set(slot + 7, glm::vec4(0.0f));
}

void Put(const fx::FixedState& state, const fx::Value& value, Slots& slots) {
  const Place place = PlaceOf(state);
  const std::span<float> to = slots.At(place.slot).subspan(static_cast<std::size_t>(place.component));
  if (IsColor(state.name) && value.numbers.size() == 1) {
    const std::array<float, 4> color = ColorFromState(value);
    std::copy(color.begin(), color.end(), to.begin());
    return;
  }
  const std::size_t count = std::min(value.numbers.size(), static_cast<std::size_t>(place.components));
  const auto columns = std::max<std::size_t>(1, value.type.columns);
  for (std::size_t i = 0; i < count; ++i) {
    // A narrow matrix leaves the last columns of the rows as they are.
    const std::size_t at = value.type.is_matrix ? i / columns * 4 + i % columns : i;
    if (at < static_cast<std::size_t>(place.components)) to[at] = static_cast<float>(value.numbers[i]);
  }
}

// A position of (0, 0, 0) is where a switched-on light stands unless it says otherwise; its direction is made unit.
void FinishLight(int light, Slots& slots) {
  const int slot = LightSlot(light);
  const std::span<float> direction = slots.At(slot + 5);
  const glm::vec3 d(direction[0], direction[1], direction[2]);
  if (glm::dot(d, d) > 0.0f) slots.Set(slot + 5, glm::vec4(glm::normalize(d), 0.0f));
  const std::span<float> cone = slots.At(slot + 7);
  const bool has_cone = cone[1] != 0.0f;
  cone[0] = has_cone ? std::cos(0.5f * cone[0]) : 0.5f;
  cone[1] = has_cone ? std::cos(0.5f * cone[1]) : 0.0f;
  const std::span<float> attenuation = slots.At(slot + 6);
  if (attenuation[0] == 0.0f && attenuation[1] == 0.0f && attenuation[2] == 0.0f) attenuation[0] = 1.0f;
}

glm::vec3 EyeOf(Slots& slots) {
  glm::mat4 view(1.0f);
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column)
      view[row][column] = slots.At(fx::kSlotView + row)[static_cast<std::size_t>(column)];
  }
  return glm::vec3(glm::inverse(view)[3]);
}

}  // namespace

std::vector<float> FixedValues(const fx::Effect& effect, const fx::FixedFunction& fixed, const FrameContext& context,
                               const fx::ParameterLookup& lookup) {
  Slots slots;
  SetSceneValues(context, slots);
  const bool names_lights =
      std::ranges::any_of(fixed.states, [](const fx::FixedState& state) { return IsOfLight(state.name); });
  if (!names_lights) SetKeyLight(context, slots);
  const auto value_of = [&](const fx::FixedState& state) -> std::optional<fx::Value> {
    if (const auto* constant = std::get_if<fx::Value>(&state.value)) return *constant;
    return fx::EvaluateExpression(effect, *std::get<const fx::ast::Expression*>(state.value), lookup);
  };
  std::array<std::optional<bool>, fx::kFixedLights> enabled;
  for (const fx::FixedState& state : fixed.states) {
    auto& light = enabled[static_cast<std::size_t>(state.index)];
    if (!IsOfLight(state.name) || light) continue;
    light = true;
    SetUsualLight(state.index, slots);
  }
  bool moves_eye = false;
  for (const fx::FixedState& state : fixed.states) {
    const auto value = value_of(state);
    if (!value || value->numbers.empty()) continue;
    if (state.name == FixedName::kLightEnable) {
      enabled[static_cast<std::size_t>(state.index)] = value->numbers[0] != 0;
      continue;
    }
    moves_eye |= state.name == FixedName::kViewTransform;
    Put(state, *value, slots);
  }
  for (int light = 0; light < fx::kFixedLights; ++light) {
    const auto& is_on = enabled[static_cast<std::size_t>(light)];
    if (!is_on) continue;
    FinishLight(light, slots);
    if (!*is_on) slots.At(LightSlot(light))[0] = 0.0f;
  }
  if (moves_eye) slots.Set(fx::kSlotEye, glm::vec4(EyeOf(slots), 1.0f));
  return slots.Take();
}

}  // namespace burin::effect

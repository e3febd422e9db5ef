// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a pass says of Direct3D 9's fixed pipeline: what the host evaluates before each draw. What never changes while
// an effect runs (operations of texture stages, what is switched on) is in the pass's shader text.

#include <cstdint>
#include <string_view>
#include <vector>

#include "fx_parser/effect/state.h"

namespace burin::fx {

enum class FixedName : std::uint8_t {
  kWorldTransform,
  kViewTransform,
  kProjectionTransform,
  kTextureTransform,
  kMaterialDiffuse,
  kMaterialAmbient,
  kMaterialSpecular,
  kMaterialEmissive,
  kMaterialPower,
  kAmbient,
  kTextureFactor,
  kConstant,
  kLightEnable,
  kLightType,
  kLightDiffuse,
  kLightSpecular,
  kLightAmbient,
  kLightPosition,
  kLightDirection,
  kLightRange,
  kLightFalloff,
  kLightAttenuation0,
  kLightAttenuation1,
  kLightAttenuation2,
  kLightTheta,
  kLightPhi
};

struct FixedState {
  FixedName name{};
  int index = 0;  ///< of the light, stage or matrix; less than kFixedLights, kFixedStages
  StateValue value;
  Range range;
};

inline constexpr int kFixedLights = 8;
inline constexpr int kFixedStages = 8;

/// Present where a pass lacks a vertex or a pixel shader, so that the fixed pipeline stands in for it.
struct FixedFunction {
  bool is_vertex = false;  ///< there is no vertex shader
  bool is_pixel = false;   ///< there is no pixel shader
  bool is_lit = false;     ///< is_vertex, and Lighting is on
  std::vector<FixedState> states;
};

/// Where the values lie in the array of vec4 that such a program reads (kUniformFixed); matrices are four rows each.
enum FixedSlot : int {
  kSlotWorld = 0,
  kSlotView = 4,
  kSlotProjection = 8,
  kSlotMaterialDiffuse = 12,
  kSlotMaterialAmbient = 13,
  kSlotMaterialSpecular = 14,
  kSlotMaterialEmissive = 15,
  kSlotMaterialPower = 16,  ///< x
  kSlotAmbient = 17,
  kSlotTextureFactor = 18,
  kSlotEye = 19,     ///< in world space
  kSlotLights = 20,  ///< kLightSlots each
  kLightSlots = 8,   ///< (type or 0, range, falloff, 0), diffuse, specular, ambient, position, direction,
                     ///< attenuation 0 to 2, (cos(theta/2), cos(phi/2), 0, 0)
  kSlotTextureTransforms = kSlotLights + kFixedLights * kLightSlots,  ///< four rows each
  kSlotConstants = kSlotTextureTransforms + kFixedStages * 4,
  kFixedSlots = kSlotConstants + kFixedStages
};

}  // namespace burin::fx

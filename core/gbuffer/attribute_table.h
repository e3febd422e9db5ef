// SPDX-License-Identifier: Apache-2.0
#pragma once
// The one table of G-buffer attributes: the renderer, `burin info`, the diagnostics and burin-attributes(7) follow it.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace burin::gbuffer {

enum class Attribute : std::uint8_t {
  kColor,
  kIntensity,
  kAlpha,
  kAlbedo,
  kDepth,
  kZbuffer,
  kNormal,
  kViewNormal,
  kTangent,
  kPosition,
  kViewPosition,
  kScreenPosition,
  kTexcoord,
  kTexcoord1,
  kVertexColor,
  kObjectId,
  kMaterialId,
  kPrimitiveId,
  kFacing,
  kVelocity,
  kEmissive,
  kRoughness,
  kMetallic,
  kLightDepth,
  kPatchUv,
  kPatchId,
  kVideo,
  kEdges,
  kEdgeDist,
  kIrradiance,
  kTranslucency,
  kLocalScattering,
  kGlobalScattering,
  kCount
};

struct AttributeInfo {
  Attribute attribute;
  std::string_view name;            ///< as in GBA<name>, lower case
  int components;                   ///< that carry data; the rest of a wider format: alpha 1 (0 on the background)
  bool is_signed;                   ///< stored as 0.5x + 0.5 in unsigned formats
  bool is_color;                    ///< takes part in display / scene-linear conversion
  bool is_id;                       ///< exact integers: never filtered or antialiased
  std::array<float, 4> background;  ///< where nothing is drawn, before encoding
  std::string_view space;           ///< "world", "view", "-" ...
  std::string_view range;           ///< "-1..1", ">= 0" ...
  std::string_view unit;            ///< "scene units (metres in glTF)", "pixels a frame" ...
  std::array<std::string_view, 4> exr_channels;  ///< field's names: "R","G","B","A"; "N.X" ...; "Z"
  std::string_view description;                  ///< one sentence
};

[[nodiscard]] std::optional<Attribute> FindAttribute(std::string_view name);  ///< case ignored
[[nodiscard]] const AttributeInfo& Info(Attribute attribute);
[[nodiscard]] std::span<const AttributeInfo> AllAttributes();

/// True for those that an EdgeStage fills (attribute_renderer.h).
[[nodiscard]] constexpr bool IsEdgeAttribute(Attribute attribute) {
  return attribute == Attribute::kEdges || attribute == Attribute::kEdgeDist;
}

/// True for those that tell light scattered nearby from the rest.
[[nodiscard]] constexpr bool IsScatteringPart(Attribute attribute) {
  return attribute == Attribute::kLocalScattering || attribute == Attribute::kGlobalScattering;
}

/// True for those that a TranslucencyStage has a part in, colour included.
[[nodiscard]] constexpr bool IsScattering(Attribute attribute) {
  return attribute == Attribute::kColor || attribute == Attribute::kIntensity || attribute == Attribute::kIrradiance ||
         attribute == Attribute::kTranslucency || IsScatteringPart(attribute);
}

}  // namespace burin::gbuffer

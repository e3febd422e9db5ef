// SPDX-License-Identifier: Apache-2.0
#pragma once
// How a target keeps an attribute: the rules of burin-attributes(7), ENCODING, as GLSL for the shaders and as numbers
// for what is cleared. Both forms stand side by side in storage.cpp.

#include <array>
#include <string>
#include <string_view>

#include "core/gbuffer/attribute_table.h"
#include "core/gl/format.h"
#include "core/image/image.h"

namespace burin::gbuffer {

/// Where and how one output is stored: everything of a target but its size.
struct Storage {
  Attribute attribute = Attribute::kColor;
  gl::Format format;
  image::Encoding encoding = image::Encoding::kSceneLinear;  ///< kData counts as kSceneLinear
  bool operator==(const Storage&) const = default;
};

/// GLSL functions that the expressions of StoreExpression call.
[[nodiscard]] std::string_view StorageFunctions();

/// A GLSL vec4 that is written to the target. `value`: an expression of type vec4 (the data components, then 0s; colour
/// is scene-linear with associated alpha; 4-component data keeps its alpha) or uint for ids.
[[nodiscard]] std::string StoreExpression(const Storage& storage, std::string_view value);

/// True where a target holds the alpha of its colour; without it colour stands on black.
[[nodiscard]] bool KeepsAlpha(const Storage& storage);

/// True where the scene-linear colour with associated alpha can be read back: `color` in a target that keeps red, green
/// and blue.
[[nodiscard]] bool CanLoadColor(const Storage& storage);

/// The GLSL vec4 of that colour, from `texel` as the target's texture reads it.
[[nodiscard]] std::string LoadColorExpression(const Storage& storage, std::string_view texel);

/// The same as StoreExpression for color, intensity, alpha and video where `value` has the
/// target's encoding and alpha already.
[[nodiscard]] std::string StorePictureExpression(const Storage& storage, std::string_view value);

/// What an empty target is cleared to. `color`: the background of `color`, scene-linear with associated alpha.
[[nodiscard]] std::array<float, 4> StoredBackground(const Storage& storage, const std::array<float, 4>& color);

/// The largest finite binary16 number: half-float targets are clamped to it.
inline constexpr float kMaxHalf = 65504.0f;

/// True for color, intensity, alpha: they follow from one shaded colour.
[[nodiscard]] bool IsColorClass(Attribute attribute);

}  // namespace burin::gbuffer

// SPDX-License-Identifier: Apache-2.0
#pragma once
// Shaders that draw a body's faces. First their depth: each triangle on every face that it looks towards nearly as
// squarely as towards any. Then its sources of light: each triangle on the one face it looks towards most squarely, so
// that every piece of surface counts exactly once whatever hides it. What another surface hides goes to a second row of
// faces; fragments add up there.
//
// The paper (section 4.2) draws each triangle on every face that it looks towards and so knows only what is visible.

#include <cstdint>
#include <string>

namespace burin::translucency {

/// How squarely a triangle must look towards a face, of its best face, to be drawn on it.
inline constexpr float kFaceReach = 0.75f;

[[nodiscard]] std::string FaceDepthVertexText();
[[nodiscard]] std::string FaceDepthGeometryText();
/// `features`: gbuffer::DrawFeature bits of the draw.
[[nodiscard]] std::string SourceVertexText();
[[nodiscard]] std::string SourceGeometryText();
/// Outputs: irradiance times area in RGB and area in A, in units of a texel's area and the largest irradiance; and unit
/// position times weight in RGB, weight in A.
[[nodiscard]] std::string SourceFragmentText(std::uint32_t features);

}  // namespace burin::translucency

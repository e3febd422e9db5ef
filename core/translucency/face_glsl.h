// SPDX-License-Identifier: Apache-2.0
#pragma once
// Shaders that draw a body's faces. First their depth: each triangle on every face that it looks towards nearly as
// squarely as towards any. Then its sources of light: each point on the face that its normal looks towards most
// squarely, or shared between those that are about equal, so that every piece of surface counts exactly once whatever
// hides it, and what a raster misses of a narrow triangle at the border between two faces counts for nothing. What
// another surface hides goes to a second row of faces; fragments add up there.
//
// The paper (section 4.2) draws each triangle on every face that it looks towards and so knows only what is visible.

#include <cstdint>
#include <string>

#include "core/translucency/scattering_quality.h"

namespace burin::translucency {

/// How squarely a triangle must look towards a face, of its best face, to be drawn on it.
inline constexpr float kFaceReach = 0.75f;
/// The same for its sources' points, where their share goes to 0.
inline constexpr float kSharing = 0.85f;
/// The paper's way, for sources, in one pass that keeps what is nearest; each face has all of it.
inline constexpr float kPaperReach = 0.2f;

[[nodiscard]] std::string FaceDepthVertexText();
[[nodiscard]] std::string FaceDepthGeometryText();
/// `features`: gbuffer::DrawFeature bits of the draw.
[[nodiscard]] std::string SourceVertexText();
[[nodiscard]] std::string SourceGeometryText(bool is_paper);
/// Outputs: irradiance times area in RGB and area in A, in units of a texel's area and the largest irradiance; and unit
/// position times weight in RGB, weight in A. `fixed_lights`: as of IrradianceFunctions.
[[nodiscard]] std::string SourceFragmentText(const Quality& quality, std::uint32_t features, int fixed_lights);

}  // namespace burin::translucency

// SPDX-License-Identifier: Apache-2.0
#pragma once
// Shaders that draw a body's faces. First their depth: each triangle on every face that it looks towards nearly as
// squarely as towards any. Then its sources of light: each triangle on the face that it looks towards most squarely, or
// shared between those that are about equal, so that every piece of surface counts exactly once whatever hides it, and
// what a raster misses of a narrow triangle at the border between two faces counts for nothing. What another surface
// hides goes to a second row of faces; fragments add up there.
//
// The paper (section 4.2) draws each triangle on every face that it looks towards and so knows only what is visible.

#include <cstdint>
#include <string>

namespace burin::translucency {

/// How squarely a triangle must look towards a face, of its best face, to be drawn on it.
inline constexpr float kFaceReach = 0.75f;
/// The same for its sources, where its share goes to 0.
inline constexpr float kSharing = 0.85f;
/// The paper's way, for both, and each face has all of it.
inline constexpr float kPaperReach = 0.2f;

[[nodiscard]] std::string FaceDepthVertexText();
[[nodiscard]] std::string FaceDepthGeometryText(bool is_paper);
/// `features`: gbuffer::DrawFeature bits of the draw.
[[nodiscard]] std::string SourceVertexText();
[[nodiscard]] std::string SourceGeometryText(bool is_paper);
/// Outputs: irradiance times area in RGB and area in A, in units of a texel's area and the largest irradiance; and unit
/// position times weight in RGB, weight in A.
[[nodiscard]] std::string SourceFragmentText(std::uint32_t features);

}  // namespace burin::translucency

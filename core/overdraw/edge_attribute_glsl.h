// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/gbuffer/storage.h"

namespace burin::overdraw {

/// Pixels: `edgedist` knows no edge that is farther off.
inline constexpr int kLargestEdgeDistance = 16;
/// Above whatever is gathered.
inline constexpr int kNoEdgeDistance = 4 * kLargestEdgeDistance;

/// Draws edge quads (EdgeQuadBuffer) grown by uniform `reach`, in pixels, round the part of each edge that is seen; the
/// depth texture is at unit 0.
[[nodiscard]] std::string EdgeLineVertexText();
/// For GL_MAX into four components, empty at 0: coverage by lines one pixel wide, as `edges` has it.
[[nodiscard]] std::string EdgeCoverageFragmentText();
/// For GL_MIN into three components, empty at kNoEdgeDistance. The third is the distance to the nearest edge; the
/// lesser of the first two tells if that is an outline on whose surface the pixel lies, or anything else.
[[nodiscard]] std::string EdgeDistanceFragmentText();
/// What was gathered that way, at unit 0, into a target of `edges` or `edgedist`.
[[nodiscard]] std::string EdgeStoreVertexText();
[[nodiscard]] std::string EdgeStoreFragmentText(const gbuffer::Storage& storage);

}  // namespace burin::overdraw

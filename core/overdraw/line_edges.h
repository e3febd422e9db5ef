// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/overdraw/frame_edges.h"

namespace burin::overdraw {

/// Faces with normals of their own that meet at less shade apart and yet are one surface to the eye: the facets of flat
/// shading, the fan round a sphere's pole.
inline constexpr float kLeastFoldDeg = 30.0f;

/// The edges that a line drawing has, of those that antialiasing wants: no seams, and no creases where the faces meet,
/// in this frame, at less than kLeastFoldDeg and at less than `crease_angle_deg`. `lines` is overwritten.
void SelectLines(std::span<const EdgeSegment> segments, float crease_angle_deg, std::vector<EdgeSegment>& lines);

}  // namespace burin::overdraw

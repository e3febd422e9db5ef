// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/mat4x4.hpp>
#include <span>
#include <vector>

#include "core/gbuffer/attribute_renderer.h"
#include "core/overdraw/frame_edges.h"

namespace burin::overdraw {

/// The lines that are drawn over a picture of `width` x `height` pixels for its edges, in their order: with the shading
/// of the one face, or double-drawn with both, the second at the share of beta (Sander et al. 2001, section 3.3).
/// `clip_from_world`: depth reversed.
void BuildShadedLines(std::span<const EdgeSegment> segments, const glm::mat4& clip_from_world, int width, int height,
                      std::vector<gbuffer::ShadedLine>& lines);

/// The shading on both sides of a picture's edges, for the resolve: `inner`, the two faces of every
/// edge both of whose sides show a surface; `outlines`, the face of every other edge.
struct AreaLines {
  std::vector<gbuffer::ShadedLine> inner, outlines;
};

/// The same parameters as BuildShadedLines.
void BuildAreaLines(std::span<const EdgeSegment> segments, const glm::mat4& clip_from_world, int width, int height,
                    AreaLines& lines);

}  // namespace burin::overdraw

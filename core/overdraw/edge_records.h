// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "core/gbuffer/attribute_renderer.h"
#include "core/overdraw/frame_edges.h"

namespace burin::overdraw {

/// An edge in the picture, as the passes over its pixels read it: three vectors of a std430 array.
struct EdgeRecord {
  /// Both ends in pixels, x right and y down from the picture's top left corner.
  glm::vec4 segment;
  /// Reversed window depth at the ends; slack: how far behind the picture's surface it is still seen; of areas, 0 or
  /// one of the numbers below; of lines, their alpha.
  glm::vec4 depth;
  /// Places of the first point (gbuffer::FaceShader) of the face on the side of (-d.y, d.x), d from the first end to
  /// the second, and of the face on the other side; the number of points. Outlines and lines have one face.
  glm::uvec4 shade;
};

/// A picture's edges, and what is to be shaded for them. As built, `shade` holds indices of `faces` in place of places.
struct EdgeRecords {
  std::vector<EdgeRecord> records;
  std::vector<gbuffer::FaceEdge> faces;

  /// `first`: the place of the first point of every one of `faces`.
  void SetPlaces(std::span<const std::uint32_t> first);
};

/// EdgeRecord::depth.w of outlines, below 0. A smooth surface is seen at a grazing angle at its outline, where
/// reflection grows to all of the light, and transmission goes to nothing, within a pixel: shading at the edge itself
/// says little about that beside it.
inline constexpr float kSharpOutline = -1.0f;
inline constexpr float kSmoothOutline = -2.0f;

struct PictureView {
  glm::mat4 clip_from_world{1.0f};  ///< depth reversed: 1 at the near plane, 0 at the far one
  int width = 0;                    ///< pixels
  int height = 0;
};

/// For the resolve: every edge in the picture, once. The surface of an outline, an edge one of whose sides shows no
/// surface, lies on the side of (-d.y, d.x).
void BuildAreas(std::span<const EdgeSegment> segments, const PictureView& view, EdgeRecords& areas);

/// For the paper's modes: the lines that are drawn over the picture, in their order: with the shading of the one face,
/// or double-drawn with both, the second at the share of beta (Sander et al. 2001, section 3.3).
void BuildLines(std::span<const EdgeSegment> segments, const PictureView& view, EdgeRecords& lines);

}  // namespace burin::overdraw

// SPDX-License-Identifier: Apache-2.0
#pragma once
// Catmull-Clark surfaces as Bézier patches, by OpenSubdiv's refinement and limit evaluation.

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "core/base/error.h"
#include "core/geometry/bezier_patches.h"

namespace burin::geometry {

/// A control mesh: polygons of any number of corners from 3 up. Indices are in range.
struct SubdivisionCage {
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> face_sizes;  ///< corners of each face
  std::vector<std::uint32_t> corners;     ///< vertices, face after face, counterclockwise from the front
  std::vector<glm::vec2> texcoords;
  std::vector<std::uint32_t> texcoord_corners;  ///< in `texcoords`, one a corner; empty: none
  std::vector<std::uint32_t> face_groups;       ///< which of the results a face goes to; empty: the first

  struct Crease {
    std::array<std::uint32_t, 2> vertices{};  ///< an edge's ends
    float sharpness = 0.0f;                   ///< 0 smooth, 10 and more infinitely sharp (RenderMan's scale)
  };
  struct SharpVertex {
    std::uint32_t vertex = 0;
    float sharpness = 0.0f;
  };
  std::vector<Crease> creases;
  std::vector<SharpVertex> sharp_vertices;
};

/// The limit surface as bicubic patches, one set a group, with equal control points wherever two patches meet, also of
/// different groups. The mesh is refined uniformly first; then faces without irregular vertices are the surface itself,
/// and the others meet it in position and tangent along their sides and interpolate it within, with normal nets of
/// their own. Boundaries and their corners are sharp. BezierPatch::face is the control face. Errors: kInput for meshes
/// that OpenSubdiv refuses and for more than 4 million patches; the caller names the file.
[[nodiscard]] Result<std::vector<BezierPatches>> MakeCatmullClarkPatches(const SubdivisionCage& cage,
                                                                         std::uint32_t group_count = 1);

}  // namespace burin::geometry

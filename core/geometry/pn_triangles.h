// SPDX-License-Identifier: Apache-2.0
#pragma once
// Triangles with normals as cubic Bézier triangles: Vlachos, Peters, Boyd, Mitchell, "Curved PN Triangles" (2001).

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "core/geometry/bezier_patches.h"

namespace burin::geometry {

/// Triangles of one material, as they are at rest. Arrays are empty or have one entry a vertex; they are looked at
/// while the surface is made, not after.
struct PnPart {
  std::span<const std::uint32_t> indices;  ///< three a triangle, counterclockwise from the front
  std::span<const glm::vec3> positions;
  /// The file's own normals say where the surface is creased: wherever two vertices at one place differ. Without them
  /// (false) normals are made, smooth but for edges that bend by more than the crease angle.
  bool has_normals = true;
  std::array<std::span<const glm::vec2>, 2> texcoords;
  std::span<const glm::vec4> colors;
};

/// The same vertices in one pose. `normals` are not looked at where the part has none of its own.
struct PnPose {
  std::span<const glm::vec3> positions;
  std::span<const glm::vec3> normals;
};

/// The curved surface of a mesh whose parts share a space. An edge's control points are computed once for all triangles
/// that meet in it, so that they are the same bits in each: along creases and between parts too, where the edge runs
/// along the line in which the planes of both sides' normals meet. Vertices that are together at rest but apart in a
/// pose part the surface there.
class PnSurface {
 public:
  /// What does not change with the pose: O(n log n) in the triangles.
  PnSurface(std::span<const PnPart> parts, float crease_angle_deg);

  /// Moves the surface, in parallel; the bits do not depend on threads. `poses`: one a part. Deterministic.
  void Pose(std::span<const PnPose> poses);

  /// One patch a triangle in the part's order: cubic positions, quadratic normals, linear texture coordinates and
  /// colours. Empty positions before the first Pose.
  [[nodiscard]] const std::vector<BezierPatches>& parts() const { return parts_; }

 private:
  /// An edge as one triangle has it. Corners are 3 * triangle + corner, over all parts.
  struct Side {
    std::uint32_t low, high;  ///< corners at the edge's lower and higher welded end
  };
  struct Frame;  ///< this pose's corners

  void FindEdges(std::span<const std::uint32_t> welded);
  void JoinSmoothCorners(std::span<const glm::vec3> positions, float crease_angle_deg);
  void MakeNormals(std::span<const glm::vec3> positions, std::span<glm::vec3> normals) const;
  void PlaceEdge(std::span<const Side> sides, const Frame& frame);
  void PlaceTriangle(std::uint32_t triangle, const Frame& frame);
  [[nodiscard]] glm::vec4* NetOf(std::uint32_t triangle);
  [[nodiscard]] std::size_t PartOf(std::uint32_t triangle) const;

  std::vector<BezierPatches> parts_;
  std::vector<std::uint32_t> first_triangle_;  ///< of each part, and the end
  std::vector<std::vector<std::uint32_t>> indices_;
  std::vector<bool> has_normals_;
  std::vector<Side> sides_;                 ///< edge by edge
  std::vector<std::uint32_t> edge_begins_;  ///< in sides_, and the end
  /// Corners of parts without normals that share one: joined_[joined_begins_[i]] ... are the corners of group i.
  std::vector<std::uint32_t> joined_, joined_begins_;
};

}  // namespace burin::geometry

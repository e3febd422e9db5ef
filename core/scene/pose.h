// SPDX-License-Identifier: Apache-2.0
#pragma once
// A scene at one time: animation, hierarchy, skins and morphs evaluated on the CPU, in parallel over vertices.

#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/scene/scene.h"
#include "core/tessellation/tessellate.h"

namespace burin::scene {

/// Which animations play. Indices in Scene::animations.
using AnimationSelection = std::vector<int>;

/// "auto" or "": every animation whose targets (node and property) no earlier one of the selection moves; "all" (where
/// two move one target, the later wins), "none", a name or an index; a name goes before an index. kUsage otherwise,
/// naming what there is.
[[nodiscard]] Result<AnimationSelection> SelectAnimations(const Scene& scene, const std::string& choice);

/// The longest duration of the selection, seconds; 0 when nothing moves.
[[nodiscard]] float Duration(const Scene& scene, const AnimationSelection& selection);

struct Pose {
  std::vector<glm::mat4> world_from_node;   ///< one a node
  std::vector<std::vector<float>> weights;  ///< one a node with a morphed mesh; else empty
};

/// `time_s` is taken modulo each animation's duration (loops): at its duration an animation is back at 0. Negative
/// times are 0.
[[nodiscard]] Pose EvaluatePose(const Scene& scene, const AnimationSelection& selection, double time_s);

/// Vertices of a primitive after morph and skin, at this frame and at the previous one. Arrays as long as the
/// primitive's; `normals`/`tangents` empty where the primitive has none, else of unit length.
///
/// Space: a skinned primitive's vertices (morphed first) are in world space, and its item's two matrices are the
/// identity, as a skin ignores its node's own transform. A primitive with morph targets only stays in object space, and
/// its item's matrices are its node's. So in every case world = world_from_object * positions[i] and previous world =
/// previous_world_from_object * (is_deformed ? previous_positions[i] : positions[i]).
struct DeformedVertices {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> previous_positions;
  std::vector<glm::vec3> normals;
  std::vector<glm::vec3> previous_normals;  ///< only where they were asked for
  std::vector<glm::vec4> tangents;
};

/// The triangles that stand in for a primitive's own in one frame, in the item's space.
struct ItemSurface {
  tessellation::Surface triangles;
  std::vector<glm::vec3> previous_positions;  ///< one a vertex; empty: as now
};

/// One primitive of one node, as drawn in one frame. GeometryOf (item_geometry.h) gives what is drawn.
struct DrawItem {
  int node = kNone;
  int mesh = kNone;
  int primitive = kNone;                 ///< in the mesh
  std::uint32_t object_id = 0;           ///< 1 + the node's index among the nodes with a mesh, in node order
  std::uint32_t material_id = 0;         ///< 1 + the material's index; 0: the default material
  std::uint32_t first_primitive_id = 0;  ///< of this item; ids run on over a frame, from 1, background 0
  bool is_deformed = false;              ///< then `deformed` holds world-space (skinned) or object-space vertices
  DeformedVertices deformed;
  std::shared_ptr<const ItemSurface> surface;  ///< drawn instead of the primitive; null: not tessellated
  std::uint32_t first_patch_id = 0;            ///< of a tessellated item; ids run on over a frame, from 1
  glm::mat4 world_from_object{1.0f};
  glm::mat4 previous_world_from_object{1.0f};
};

/// What a frame draws: `pose` now and `previous` one frame earlier (for velocities), in node order. Only nodes below
/// Scene::roots are drawn. The bits do not depend on the number of threads.
[[nodiscard]] std::vector<DrawItem> BuildDrawItems(const Scene& scene, const Pose& pose, const Pose& previous);

/// The same into the items of an earlier frame of the same scene, whose arrays are reused: no allocation a frame.
/// `wants_previous_normals`: tessellated items need them.
void UpdateDrawItems(const Scene& scene, const Pose& pose, const Pose& previous, std::vector<DrawItem>& items,
                     bool wants_previous_normals = false);

/// World-space bounds of the items (min, max); min > max when empty.
struct Bounds {
  glm::vec3 min{1e30f};
  glm::vec3 max{-1e30f};
  void Extend(const Bounds& other) {
    min = glm::min(min, other.min);
    max = glm::max(max, other.max);
  }
  [[nodiscard]] bool empty() const { return min.x > max.x; }
};
/// `from_world`: of the items mapped by it (affine).
[[nodiscard]] Bounds ComputeBounds(const Scene& scene, const std::vector<DrawItem>& items,
                                   const glm::mat4& from_world = glm::mat4(1.0f));

}  // namespace burin::scene

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <map>
#include <memory>
#include <tuple>
#include <utility>

#include "core/base/error.h"
#include "core/gl/handle.h"
#include "core/scene/pose.h"
#include "core/scene/scene.h"

namespace burin::gbuffer {

/// A primitive on the device. Attributes at gl::VertexLocation; the patch's (u, v), its id and the previous position at
/// the places of TEXCOORD5 to TEXCOORD7, in `vertex_array` only.
struct GpuPrimitive {
  gl::BufferHandle vertices;  ///< what never changes
  gl::BufferHandle indices;
  gl::BufferHandle effect_texcoords;  ///< TEXCOORD0 of effects where it is not the mesh's own
  gl::BufferHandle deformed;          ///< positions, previous positions, normals, tangents of this frame
  gl::VertexArrayHandle vertex_array;
  gl::VertexArrayHandle effect_vertex_array;  ///< for an effect's own shaders
  std::uint32_t mode = 0;                     ///< GLenum
  int index_count = 0;
  bool has_normals = false;
  bool has_tangents = false;
  bool has_texcoords = false;
  bool has_patches = false;
  glm::vec3 center{0.0f};  ///< of the bounds, in the space of the draw's vertices
};

/// Uploads primitives when they are first drawn: one copy for all nodes that show a mesh, one a node where it is
/// deformed. Tessellated surfaces are one a node too, uploaded when they change.
class MeshStore {
 public:
  explicit MeshStore(const scene::Scene& scene) : scene_(&scene) {}

  /// The item's primitive with this frame's vertices. `wants_center`: the centre of a deformed one is computed anew.
  /// The pointer holds until the store ends. Errors: kFailed when memory is short.
  [[nodiscard]] Result<const GpuPrimitive*> Prepare(const scene::DrawItem& item, bool wants_center);

 private:
  struct Surface {
    GpuPrimitive primitive;
    std::shared_ptr<const scene::ItemSurface> shown;  ///< what the buffers hold
  };
  [[nodiscard]] Result<const GpuPrimitive*> PrepareSurface(const scene::DrawItem& item);

  const scene::Scene* scene_;
  std::map<std::tuple<bool, int, int>, GpuPrimitive> primitives_;  // deformed?, node or mesh, primitive
  std::map<std::pair<int, int>, Surface> surfaces_;                // node, primitive
};

/// Values that vertex shaders read where a mesh has no array: white vertex colours, zeros.
void SetMissingAttributes();

}  // namespace burin::gbuffer

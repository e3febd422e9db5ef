// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/overdraw/edge_mesh.h"
#include "core/overdraw/edge_options.h"
#include "core/overdraw/frame_edges.h"
#include "core/scene/camera.h"
#include "core/scene/pose.h"
#include "core/scene/scene.h"

namespace burin::overdraw {

/// The discontinuity edges of a scene, frame by frame. What does not depend on the view is prepared when an object is
/// first seen: once a mesh, or once a node where skins or morphs move it; of tessellated surfaces whenever they change.
class SceneEdges {
 public:
  /// `scene` outlives this.
  SceneEdges(const scene::Scene& scene, const EdgeOptions& options) : scene_(&scene), options_(options) {}

  /// The edges of `items` in `view`; valid until the next call. Errors: kInput, naming the mesh.
  [[nodiscard]] Result<const FrameEdges*> Extract(std::span<const scene::DrawItem> items, const scene::View& view);

  /// A line an object that was prepared: its edges, and how its silhouettes are found. Each line is given once.
  [[nodiscard]] std::vector<std::string> TakeNotes() { return std::exchange(notes_, {}); }

 private:
  /// The items of one node that share a space, and its edges.
  struct Object {
    EdgeMesh mesh;
    std::vector<std::uint32_t> first_vertex;                          ///< of each primitive among the mesh's vertices
    std::vector<std::uint32_t> first_triangle;                        ///< and triangles
    std::vector<std::shared_ptr<const scene::ItemSurface>> surfaces;  ///< of each item, what it was built from
  };
  using Items = std::span<const scene::DrawItem>;

  [[nodiscard]] Result<Object*> Prepare(Items items);
  [[nodiscard]] Result<Object> Build(Items items);
  void Append(const Object& object, Items items, std::uint32_t first_item, const scene::View& view);
  void Order();

  const scene::Scene* scene_;
  EdgeOptions options_;
  std::map<std::pair<bool, int>, Object> objects_;  ///< deformed?, node or mesh
  std::vector<RenderedEdge> rendered_;
  std::vector<std::pair<bool, float>> keys_;  ///< of the segments: sorted?, distance
  FrameEdges frame_;
  std::vector<std::string> notes_;
};

}  // namespace burin::overdraw

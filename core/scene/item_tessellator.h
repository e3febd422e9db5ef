// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <span>
#include <tuple>
#include <vector>

#include "core/base/error.h"
#include "core/geometry/pn_triangles.h"
#include "core/scene/camera.h"
#include "core/scene/pose.h"
#include "core/scene/scene.h"
#include "core/scene/tessellation_options.h"
#include "core/tessellation/tessellate.h"

namespace burin::scene {

/// What a frame's tessellation came to.
struct TessellationCounts {
  std::size_t patches = 0;
  std::size_t triangles = 0;
  std::size_t clamped = 0;  ///< sides that would have needed a larger factor than the largest
};

/// Gives each frame's items their surfaces: patches where the scene has them, PN triangles for other triangles. What
/// does not change from frame to frame (nets, and whole surfaces whose factors stay) is kept. One thread at a time;
/// the surfaces live as long as anyone holds them, and their memory is used again afterwards.
class ItemTessellator {
 public:
  /// `scene` outlives this.
  ItemTessellator(const Scene& scene, const TessellationOptions& options) : scene_(&scene), options_(options) {}

  /// False when no item would get a surface.
  [[nodiscard]] bool is_active() const;
  /// Items need the previous pose's normals (UpdateDrawItems).
  [[nodiscard]] bool wants_previous_normals() const { return is_active(); }

  /// After UpdateDrawItems: sets surfaces, and counts primitive and patch ids anew. By the options' factor, or so that
  /// sides are as long as they say in a picture of width x height pixels. Errors: kFailed when the frame would have too
  /// many triangles.
  [[nodiscard]] Result<TessellationCounts> Tessellate(const View& view, int width, int height,
                                                      std::vector<DrawItem>& items);
  /// With this factor on all sides, as for bounds.
  [[nodiscard]] Result<TessellationCounts> TessellateEvenly(float factor, std::vector<DrawItem>& items);

 private:
  using Items = std::span<DrawItem>;
  using FactorList = std::vector<tessellation::Factors>;

  /// The PN surfaces of a mesh, or of a node where it is deformed: primitives by their index, others null.
  struct Curved {
    std::vector<int> primitives;  ///< those in the surface, in its parts' order
    std::unique_ptr<geometry::PnSurface> now, before;
    bool is_posed = false;
  };
  /// What an item had last.
  struct Kept {
    FactorList factors;
    std::shared_ptr<const ItemSurface> surface;
    std::uint32_t patch_ids = 0;  ///< how many
    tessellation::Tessellator now, before;
  };
  /// Where an item's surface comes from in this frame.
  struct Source {
    const geometry::BezierPatches* now = nullptr;
    const geometry::BezierPatches* before = nullptr;  ///< null: as now
  };
  template <class FactorsOf>
  Result<TessellationCounts> Run(std::vector<DrawItem>& items, const FactorsOf& factors_of);

  [[nodiscard]] tessellation::Pattern pattern() const;
  [[nodiscard]] bool Curves(const Primitive& primitive) const;
  void PoseCurved(Items of_space);
  [[nodiscard]] Source SourceOf(const DrawItem& item) const;
  void Refine(const Source& source, FactorList factors, DrawItem& item);
  [[nodiscard]] std::shared_ptr<ItemSurface> TakeSurface();
  [[nodiscard]] static std::pair<bool, int> SpaceOf(const DrawItem& item) {
    return {item.is_deformed, item.is_deformed ? item.node : item.mesh};
  }

  const Scene* scene_;
  TessellationOptions options_;
  std::map<std::pair<bool, int>, Curved> curved_;       ///< deformed?, node or mesh
  std::map<std::pair<int, int>, Kept> kept_;            ///< node, primitive
  std::vector<std::shared_ptr<ItemSurface>> surfaces_;  ///< all that were made; those held by no one else are free
  tessellation::Surface scratch_;
};

}  // namespace burin::scene

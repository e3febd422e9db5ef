// SPDX-License-Identifier: Apache-2.0
#include "core/scene/item_geometry.h"

namespace burin::scene {
namespace {

ItemGeometry OfSurface(const ItemSurface& surface) {
  const tessellation::Surface& t = surface.triangles;
  return {.positions = t.positions,
          .previous_positions = surface.previous_positions,
          .normals = t.normals,
          .tangents = t.tangents,
          .texcoords = {t.texcoords[0], t.texcoords[1]},
          .colors = t.colors,
          .patch_uv = t.patch_uv,
          .patch_ids = t.patch_ids,
          .indices = t.indices};
}

}  // namespace

const Primitive& PrimitiveOf(const Scene& scene, const DrawItem& item) {
  return scene.meshes[static_cast<std::size_t>(item.mesh)].primitives[static_cast<std::size_t>(item.primitive)];
}

ItemGeometry GeometryOf(const Scene& scene, const DrawItem& item) {
  if (item.surface) return OfSurface(*item.surface);
  const Primitive& primitive = PrimitiveOf(scene, item);
  ItemGeometry geometry{.mode = primitive.mode,
                        .positions = primitive.positions,
                        .previous_positions = {},
                        .normals = primitive.normals,
                        .tangents = primitive.tangents,
                        .texcoords = {primitive.texcoords[0], primitive.texcoords[1]},
                        .colors = primitive.colors,
                        .patch_uv = {},
                        .patch_ids = {},
                        .indices = primitive.indices};
  if (item.is_deformed) {
    geometry.positions = item.deformed.positions;
    geometry.previous_positions = item.deformed.previous_positions;
    geometry.normals = item.deformed.normals;
    geometry.tangents = item.deformed.tangents;
  }
  return geometry;
}

std::uint32_t ElementCount(PrimitiveMode mode, std::size_t indices) {
  const std::size_t corners = mode == PrimitiveMode::kTriangles ? 3 : mode == PrimitiveMode::kLines ? 2 : 1;
  return static_cast<std::uint32_t>(indices / corners);
}

}  // namespace burin::scene

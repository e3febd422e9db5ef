// SPDX-License-Identifier: Apache-2.0
#include "core/scene/patch_primitive.h"

#include <memory>
#include <utility>

#include "core/tessellation/tessellate.h"

namespace burin::scene {

Primitive MakePatchPrimitive(geometry::BezierPatches patches, int material) {
  tessellation::Surface coarse;
  const std::vector<tessellation::Factors> factors(patches.patches.size(), {1.0f, 1.0f, 1.0f, 1.0f});
  tessellation::Tessellate(
      patches, factors, {.pattern = tessellation::Pattern::kInteger, .wants_patch_uv = false, .wants_patch_ids = false},
      coarse);
  Primitive primitive;
  primitive.positions = std::move(coarse.positions);
  primitive.normals = std::move(coarse.normals);
  primitive.texcoords = std::move(coarse.texcoords);
  primitive.colors = std::move(coarse.colors);
  primitive.indices = std::move(coarse.indices);
  primitive.material = material;
  primitive.patches = std::make_shared<const geometry::BezierPatches>(std::move(patches));
  return primitive;
}

}  // namespace burin::scene

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/catmull_clark.h"
#include "core/scene/obj_file.h"
#include "core/scene/scene.h"

namespace burin::scene {

/// The elements of one "o" that have the same kind and material, in the file's order.
struct ObjGroup {
  ObjElement element = ObjElement::kFace;
  std::uint32_t material = kNoIndex;  ///< index in ObjFile::materials
  std::vector<std::uint32_t> polygons;
};

/// One list for each of ObjFile::objects.
[[nodiscard]] std::vector<std::vector<ObjGroup>> GroupByObject(const ObjFile& file);

/// A group's vertices: one for each combination of position, texture coordinates and normal. `material` is not set.
[[nodiscard]] Primitive MakePrimitive(const ObjFile& file, const ObjGroup& group);

/// True when faces are all quads without normals, or have crease or corner tags.
[[nodiscard]] bool IsCage(const ObjFile& file, std::span<const ObjGroup> groups);

/// The faces of all groups; SubdivisionCage::face_groups counts the face groups among `groups`.
[[nodiscard]] geometry::SubdivisionCage MakeCage(const ObjFile& file, std::span<const ObjGroup> groups);

}  // namespace burin::scene

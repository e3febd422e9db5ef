// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a primitive needs beyond its file's arrays: index lists of every mode, vertices re-ordered, normals and tangents
// made.

#include <cstdint>
#include <span>
#include <vector>

#include "core/scene/scene.h"

namespace burin::scene {

/// glTF primitive modes 0 to 6 (specification 3.7.2.1) to a list of points, lines or triangles. Indices that do not
/// fill a last line or triangle are dropped, and so are a strip's triangles with a repeated index (they only join
/// strips).
[[nodiscard]] std::vector<std::uint32_t> IndexList(std::vector<std::uint32_t> indices, int gltf_mode);

/// Replaces every vertex array by its entries at `sources`, morph targets included. Indices are left alone.
void GatherVertices(Primitive& primitive, std::span<const std::uint32_t> sources);

/// Drops the vertices that no index names.
void DropUnusedVertices(Primitive& primitive);

/// Gives each triangle three vertices of its own and its plane's normal (specification 3.7.2.1: flat normals when the
/// file has none, its tangents ignored).
void MakeFlatNormals(Primitive& primitive);

/// A triangle's unit normal by the right-hand rule; +z for one without area.
[[nodiscard]] glm::vec3 TriangleNormal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

/// Makes tangents from the texture coordinates of `set`, which must be there, like the normals. A vertex where the
/// texture is mirrored on one side is doubled.
void MakeTangents(Primitive& primitive, int set);

}  // namespace burin::scene

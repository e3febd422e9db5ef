// SPDX-License-Identifier: Apache-2.0
// Tangents after MikkTSpace (M. Mikkelsen, "Simulation of Wrinkled Surfaces Revisited", 2008): each triangle's tangent
// is the direction of growing u, projected on the vertex' normal plane, summed by the triangle's angle there, apart for
// each handedness. Deviation: vertices are kept as the file shares them, not welded by position first, so a seam in the
// file stays a seam of the tangents.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "core/scene/primitive_geometry.h"

namespace burin::scene {
namespace {

/// The direction of growing u over a triangle, and whether (u, v) turn clockwise where the corners turn
/// counter-clockwise.
struct TextureFrame {
  glm::vec3 tangent{0.0f};
  bool turns_against = false;
  bool degenerate = true;
};

TextureFrame FrameOf(const Primitive& p, const std::vector<glm::vec2>& uv, const std::uint32_t* corner) {
  const glm::vec3 e1 = p.positions[corner[1]] - p.positions[corner[0]];
  const glm::vec3 e2 = p.positions[corner[2]] - p.positions[corner[0]];
  const glm::vec2 d1 = uv[corner[1]] - uv[corner[0]];
  const glm::vec2 d2 = uv[corner[2]] - uv[corner[0]];
  const float area = d1.x * d2.y - d1.y * d2.x;
  const glm::vec3 direction = (e1 * d2.y - e2 * d1.y) * (area < 0.0f ? -1.0f : 1.0f);
  const float length = glm::length(direction);
  if (area == 0.0f || !(length > 0.0f)) return {};
  return {direction / length, area < 0.0f, false};
}

float AngleAt(const Primitive& p, const std::uint32_t* triangle, int corner) {
  const glm::vec3 at = p.positions[triangle[corner]];
  const glm::vec3 a = p.positions[triangle[(corner + 1) % 3]] - at;
  const glm::vec3 b = p.positions[triangle[(corner + 2) % 3]] - at;
  const float lengths = glm::length(a) * glm::length(b);
  return lengths > 0.0f ? std::acos(std::clamp(glm::dot(a, b) / lengths, -1.0f, 1.0f)) : 0.0f;
}

glm::vec3 AnyPerpendicular(const glm::vec3& n) {
  const glm::vec3 axis = std::abs(n.x) < 0.9f ? glm::vec3(1.0f, 0.0f, 0.0f) : glm::vec3(0.0f, 1.0f, 0.0f);
  return glm::normalize(axis - n * glm::dot(n, axis));
}

/// Doubles each vertex that triangles of both handednesses share.
void SplitByHandedness(Primitive& primitive, const std::vector<TextureFrame>& frames) {
  constexpr std::uint8_t kWith = 1;
  constexpr std::uint8_t kAgainst = 2;
  std::vector<std::uint8_t> uses(primitive.positions.size(), 0);
  for (std::size_t i = 0; i < primitive.indices.size(); ++i) {
    const TextureFrame& frame = frames[i / 3];
    if (!frame.degenerate) uses[primitive.indices[i]] |= frame.turns_against ? kAgainst : kWith;
  }
  std::vector<std::uint32_t> sources(primitive.positions.size());
  std::iota(sources.begin(), sources.end(), 0u);
  std::vector<std::uint32_t> copy_of(primitive.positions.size(), 0);
  for (std::size_t i = 0; i < primitive.indices.size(); ++i) {
    std::uint32_t& index = primitive.indices[i];
    const TextureFrame& frame = frames[i / 3];
    if (frame.degenerate || !frame.turns_against || uses[index] != (kWith | kAgainst)) continue;
    if (copy_of[index] == 0) {
      copy_of[index] = static_cast<std::uint32_t>(sources.size());
      sources.push_back(index);
    }
    index = copy_of[index];
  }
  if (sources.size() > primitive.positions.size()) GatherVertices(primitive, sources);
}

}  // namespace

void MakeTangents(Primitive& primitive, int set) {
  primitive.tangents.clear();
  const std::size_t triangles = primitive.indices.size() / 3;
  std::vector<TextureFrame> frames(triangles);
  const std::size_t set_index = static_cast<std::size_t>(set);
  for (std::size_t t = 0; t < triangles; ++t) {
    frames[t] = FrameOf(primitive, primitive.texcoords[set_index], &primitive.indices[3 * t]);
  }
  SplitByHandedness(primitive, frames);

  std::vector<glm::vec4> tangents(primitive.positions.size(), glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
  for (std::size_t t = 0; t < triangles; ++t) {
    if (frames[t].degenerate) continue;
    const std::uint32_t* triangle = &primitive.indices[3 * t];
    for (int corner = 0; corner < 3; ++corner) {
      const glm::vec3& n = primitive.normals[triangle[corner]];
      const glm::vec3 projected = frames[t].tangent - n * glm::dot(n, frames[t].tangent);
      const float length = glm::length(projected);
      if (!(length > 0.0f)) continue;
      glm::vec4& sum = tangents[triangle[corner]];
      sum += glm::vec4(projected * (AngleAt(primitive, triangle, corner) / length), 0.0f);
      // A normal map's green axis points up in the image, where glTF's v falls: a triangle whose (u, v) turn against
      // the surface is the ordinary case, with bitangent = +cross(n, t).
      sum.w = frames[t].turns_against ? 1.0f : -1.0f;
    }
  }
  for (std::size_t i = 0; i < tangents.size(); ++i) {
    const glm::vec3 sum(tangents[i]);
    const float length = glm::length(sum);
    const glm::vec3 unit = length > 1e-12f ? sum / length : AnyPerpendicular(primitive.normals[i]);
    tangents[i] = glm::vec4(unit, tangents[i].w);
  }
  primitive.tangents = std::move(tangents);
}

}  // namespace burin::scene

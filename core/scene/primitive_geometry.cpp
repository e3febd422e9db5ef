// SPDX-License-Identifier: Apache-2.0
#include "core/scene/primitive_geometry.h"

#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

namespace burin::scene {
namespace {

template <class T>
void Gather(std::vector<T>& values, std::span<const std::uint32_t> sources) {
  if (values.empty()) return;
  std::vector<T> gathered(sources.size());
  for (std::size_t i = 0; i < sources.size(); ++i) gathered[i] = values[sources[i]];
  values = std::move(gathered);
}

std::vector<std::uint32_t> Lines(const std::vector<std::uint32_t>& in, bool loop) {
  std::vector<std::uint32_t> out;
  if (in.size() < 2) return out;
  out.reserve(in.size() * 2);
  for (std::size_t i = 0; i + 1 < in.size(); ++i) out.insert(out.end(), {in[i], in[i + 1]});
  if (loop) out.insert(out.end(), {in.back(), in.front()});
  return out;
}

std::vector<std::uint32_t> StripTriangles(const std::vector<std::uint32_t>& in) {
  std::vector<std::uint32_t> out;
  out.reserve(in.size() * 3);
  for (std::size_t i = 0; i + 2 < in.size(); ++i) {
    const std::uint32_t a = in[i];
    const std::uint32_t b = in[i + 1 + i % 2];
    const std::uint32_t c = in[i + 2 - i % 2];
    if (a != b && b != c && c != a) out.insert(out.end(), {a, b, c});
  }
  return out;
}

std::vector<std::uint32_t> FanTriangles(const std::vector<std::uint32_t>& in) {
  std::vector<std::uint32_t> out;
  out.reserve(in.size() * 3);
  for (std::size_t i = 0; i + 2 < in.size(); ++i) out.insert(out.end(), {in[i + 1], in[i + 2], in[0]});
  return out;
}

}  // namespace

std::vector<std::uint32_t> IndexList(std::vector<std::uint32_t> indices, int gltf_mode) {
  switch (gltf_mode) {
    case 0:
      return indices;
    case 1:
      indices.resize(indices.size() / 2 * 2);
      return indices;
    case 2:
      return Lines(indices, true);
    case 3:
      return Lines(indices, false);
    case 5:
      return StripTriangles(indices);
    case 6:
      return FanTriangles(indices);
    default:
      indices.resize(indices.size() / 3 * 3);
      return indices;
  }
}

void GatherVertices(Primitive& primitive, std::span<const std::uint32_t> sources) {
  Gather(primitive.positions, sources);
  Gather(primitive.normals, sources);
  Gather(primitive.tangents, sources);
  Gather(primitive.colors, sources);
  for (int set = 0; set < 2; ++set) {
    Gather(primitive.texcoords[set], sources);
    Gather(primitive.joints[set], sources);
    Gather(primitive.weights[set], sources);
  }
  for (Primitive::MorphTarget& target : primitive.targets) {
    Gather(target.positions, sources);
    Gather(target.normals, sources);
    Gather(target.tangents, sources);
  }
}

void DropUnusedVertices(Primitive& primitive) {
  constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> new_from_old(primitive.positions.size(), kUnused);
  for (const std::uint32_t index : primitive.indices) new_from_old[index] = 0;
  std::vector<std::uint32_t> sources;
  for (std::uint32_t old = 0; old < new_from_old.size(); ++old) {
    if (new_from_old[old] == kUnused) continue;
    new_from_old[old] = static_cast<std::uint32_t>(sources.size());
    sources.push_back(old);
  }
  if (sources.size() == primitive.positions.size()) return;
  GatherVertices(primitive, sources);
  for (std::uint32_t& index : primitive.indices) index = new_from_old[index];
}

glm::vec3 TriangleNormal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  // In double: the squares of a small triangle's sides fall below a float's range.
  const glm::dvec3 n = glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
  const double length = glm::length(n);
  return length > 0.0 ? glm::vec3(n / length) : glm::vec3(0.0f, 0.0f, 1.0f);
}

void MakeFlatNormals(Primitive& primitive) {
  const std::vector<std::uint32_t> sources = std::move(primitive.indices);
  primitive.normals.clear();
  primitive.tangents.clear();
  for (Primitive::MorphTarget& target : primitive.targets) {
    target.normals.clear();
    target.tangents.clear();
  }
  GatherVertices(primitive, sources);
  primitive.indices.resize(sources.size());
  std::iota(primitive.indices.begin(), primitive.indices.end(), 0u);
  primitive.normals.resize(sources.size());
  for (std::size_t i = 0; i + 2 < sources.size(); i += 3) {
    const glm::vec3 normal =
        TriangleNormal(primitive.positions[i], primitive.positions[i + 1], primitive.positions[i + 2]);
    primitive.normals[i] = primitive.normals[i + 1] = primitive.normals[i + 2] = normal;
  }
  primitive.flat_normals = true;
  primitive.has_made_normals = true;
}

}  // namespace burin::scene

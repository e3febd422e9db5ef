// SPDX-License-Identifier: Apache-2.0
#include "core/scene/add_tangents.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "core/scene/primitive_geometry.h"

namespace burin::scene {
namespace {

glm::vec4 AnyTangent(const glm::vec3& n) {
  const glm::vec3 axis = std::abs(n.x) < 0.9f ? glm::vec3(1.0f, 0.0f, 0.0f) : glm::vec3(0.0f, 1.0f, 0.0f);
  return {glm::normalize(axis - n * glm::dot(n, axis)), 1.0f};
}

}  // namespace

void AddTangents(Scene& scene) {
  for (Mesh& mesh : scene.meshes) {
    for (Primitive& primitive : mesh.primitives) {
      if (primitive.mode != PrimitiveMode::kTriangles || !primitive.tangents.empty() || primitive.normals.empty())
        continue;
      if (!primitive.texcoords[0].empty()) {
        MakeTangents(primitive, 0);
        continue;
      }
      for (const glm::vec3& normal : primitive.normals) primitive.tangents.push_back(AnyTangent(normal));
    }
  }
}

}  // namespace burin::scene

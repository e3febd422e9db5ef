// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "tests/bench/tessellation/rivals.h"

namespace burin::bench {
namespace {

using geometry::BezierPatches;

void MakeIndices(std::uint32_t segments, std::vector<std::uint32_t>& indices) {
  indices.clear();
  const std::uint32_t row = segments + 1;
  for (std::uint32_t j = 0; j < segments; ++j) {
    for (std::uint32_t i = 0; i < segments; ++i) {
      const std::uint32_t a = j * row + i;
      indices.insert(indices.end(), {a, a + 1, a + row + 1, a, a + row + 1, a + row});
    }
  }
}

void Prepare(const BezierPatches& patches, std::uint32_t segments, PlainMesh& mesh) {
  static std::vector<std::uint32_t> pattern;
  static std::uint32_t pattern_segments = 0;
  if (pattern_segments != segments) MakeIndices(segments, pattern);
  pattern_segments = segments;
  const std::size_t vertices = std::size_t{segments + 1} * (segments + 1);
  mesh.vertices.resize(6 * vertices * patches.patches.size() + 8);
  mesh.indices.resize(pattern.size() * patches.patches.size());
  for (std::size_t p = 0; p < patches.patches.size(); ++p) {
    const auto first = static_cast<std::uint32_t>(p * vertices);
    std::uint32_t* const out = mesh.indices.data() + p * pattern.size();
    for (std::size_t k = 0; k < pattern.size(); ++k) out[k] = pattern[k] + first;
  }
}

struct Point {
  glm::vec3 value, derivative;
};

Point Curve(const std::array<glm::vec3, 4>& p, float t) {
  const float s = 1.0f - t;
  const glm::vec3 a = s * p[0] + t * p[1], b = s * p[1] + t * p[2], c = s * p[2] + t * p[3];
  const glm::vec3 d = s * a + t * b, e = s * b + t * c;
  return {s * d + t * e, e - d};
}

using Eight = float __attribute__((vector_size(32)));
struct EightPoint {
  Eight x, y, z;
};

[[gnu::always_inline]] inline EightPoint Mix(const EightPoint& a, const EightPoint& b, const Eight& s, const Eight& t) {
  return {s * a.x + t * b.x, s * a.y + t * b.y, s * a.z + t * b.z};
}

}  // namespace

void TessellateByVertex(const BezierPatches& patches, std::uint32_t segments, PlainMesh& mesh) {
  Prepare(patches, segments, mesh);
  float* out = mesh.vertices.data();
  for (const auto& patch : patches.patches) {
    const glm::vec4* const net = &patches.positions[patch.position.first];
    for (std::uint32_t j = 0; j <= segments; ++j) {
      for (std::uint32_t i = 0; i <= segments; ++i, out += 6) {
        const float u = static_cast<float>(i) / static_cast<float>(segments);
        const float v = static_cast<float>(j) / static_cast<float>(segments);
        std::array<glm::vec3, 4> values, derivatives;
        for (std::size_t r = 0; r < 4; ++r) {
          const Point at = Curve({net[4 * r], net[4 * r + 1], net[4 * r + 2], net[4 * r + 3]}, u);
          values[r] = at.value;
          derivatives[r] = at.derivative;
        }
        const Point at = Curve(values, v);
        const glm::vec3 normal = glm::cross(Curve(derivatives, v).value, at.derivative);
        const glm::vec3 unit = normal * (1.0f / std::sqrt(glm::dot(normal, normal)));
        for (int c = 0; c < 3; ++c) {
          out[c] = at.value[c];
          out[3 + c] = unit[c];
        }
      }
    }
  }
}

[[gnu::target("avx2,fma")]] void TessellateByRow(const BezierPatches& patches, std::uint32_t segments,
                                                 PlainMesh& mesh) {
  Prepare(patches, segments, mesh);
  float* out = mesh.vertices.data();
  const float step = 1.0f / static_cast<float>(segments);
  for (const auto& patch : patches.patches) {
    const glm::vec4* const net = &patches.positions[patch.position.first];
    for (std::uint32_t j = 0; j <= segments; ++j) {
      EightPoint p[4], q[4];
      for (std::size_t i = 0; i < 4; ++i) {
        const Point at = Curve({net[i], net[4 + i], net[8 + i], net[12 + i]}, static_cast<float>(j) * step);
        p[i] = {Eight{} + at.value.x, Eight{} + at.value.y, Eight{} + at.value.z};
        q[i] = {Eight{} + at.derivative.x, Eight{} + at.derivative.y, Eight{} + at.derivative.z};
      }
      for (std::uint32_t i = 0; i <= segments; i += 8) {
        const float first = static_cast<float>(i);
        const Eight t = (first + Eight{0, 1, 2, 3, 4, 5, 6, 7}) * step, s = 1.0f - t;
        const EightPoint a = Mix(p[0], p[1], s, t), b = Mix(p[1], p[2], s, t), c = Mix(p[2], p[3], s, t);
        const EightPoint d = Mix(a, b, s, t), e = Mix(b, c, s, t), value = Mix(d, e, s, t);
        const EightPoint along{e.x - d.x, e.y - d.y, e.z - d.z};
        const EightPoint f = Mix(q[0], q[1], s, t), g = Mix(q[1], q[2], s, t), h = Mix(q[2], q[3], s, t);
        const EightPoint across = Mix(Mix(f, g, s, t), Mix(g, h, s, t), s, t);
        const Eight x = along.y * across.z - along.z * across.y, y = along.z * across.x - along.x * across.z,
                    z = along.x * across.y - along.y * across.x;
        const Eight squares = x * x + y * y + z * z;
        for (std::uint32_t l = 0; l < 8 && i + l <= segments; ++l, out += 6) {
          const float inverse = 1.0f / std::sqrt(squares[l]);
          out[0] = value.x[l];
          out[1] = value.y[l];
          out[2] = value.z[l];
          out[3] = x[l] * inverse;
          out[4] = y[l] * inverse;
          out[5] = z[l] * inverse;
        }
      }
    }
  }
}

}  // namespace burin::bench

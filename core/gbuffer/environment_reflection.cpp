// SPDX-License-Identifier: Apache-2.0
// Karis, "Real Shading in Unreal Engine 4" (SIGGRAPH 2013 course): the prefiltered half of the split sum, view and
// normal taken along the reflection. Krivanek and Colbert, "Real-Time Shading with Filtered Importance Sampling" (EGSR
// 2008), equation 5 for the mip level of each sample, so that few samples give no noise.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "core/gbuffer/cube_face.h"
#include "core/gbuffer/environment.h"

namespace burin::gbuffer {
namespace {

constexpr float kPi = glm::pi<float>();
constexpr int kSamples = 32;
constexpr int kSmallestFace = 8;

// A cube map on the CPU: looked up without any of the equirectangular map's arc functions.
struct Cube {
  int size = 0;
  std::vector<glm::vec3> texels;  ///< 6 faces of size * size

  [[nodiscard]] const glm::vec3& At(int face, int x, int y) const {
    return texels[static_cast<std::size_t>((face * size + y) * size + x)];
  }
};

template <class Function>  // of a unit direction
Cube FillCube(int size, Function&& value) {
  Cube cube{.size = size, .texels = std::vector<glm::vec3>(static_cast<std::size_t>(6 * size * size))};
  tbb::parallel_for(0, 6 * size, [&](int row) {
    const float t = 2.0f * (static_cast<float>(row % size) + 0.5f) / static_cast<float>(size) - 1.0f;
    for (int column = 0; column < size; ++column) {
      const float s = 2.0f * (static_cast<float>(column) + 0.5f) / static_cast<float>(size) - 1.0f;
      cube.texels[static_cast<std::size_t>(row * size + column)] =
          value(glm::normalize(CubeFaceDirection(row / size, s, t)));
    }
  });
  return cube;
}

// Each texel the mean of four; equal weights do, as the lobes are wide where small levels are read.
Cube Halve(const Cube& cube) {
  const int size = cube.size / 2;
  Cube half{.size = size, .texels = {}};
  half.texels.reserve(static_cast<std::size_t>(6 * size * size));
  for (int face = 0; face < 6; ++face) {
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        half.texels.push_back(0.25f * (cube.At(face, 2 * x, 2 * y) + cube.At(face, 2 * x + 1, 2 * y) +
                                       cube.At(face, 2 * x, 2 * y + 1) + cube.At(face, 2 * x + 1, 2 * y + 1)));
      }
    }
  }
  return half;
}

// Bilinear inside a face, clamped at its edges: the lobes that look here are wider than a texel.
glm::vec3 SampleCube(const Cube& cube, const glm::vec3& d) {
  const float ax = std::abs(d.x), ay = std::abs(d.y), az = std::abs(d.z);
  int face = 0;
  float s = 0.0f, t = 0.0f, major = 1.0f;
  if (ax >= ay && ax >= az) {
    face = d.x > 0.0f ? 0 : 1;
    s = d.x > 0.0f ? -d.z : d.z;
    t = -d.y;
    major = ax;
  } else if (ay >= az) {
    face = d.y > 0.0f ? 2 : 3;
    s = d.x;
    t = d.y > 0.0f ? d.z : -d.z;
    major = ay;
  } else {
    face = d.z > 0.0f ? 4 : 5;
    s = d.z > 0.0f ? d.x : -d.x;
    t = -d.y;
    major = az;
  }
  const float last = static_cast<float>(cube.size - 1);
  const float scale = 0.5f * static_cast<float>(cube.size) / major;
  const float offset = 0.5f * static_cast<float>(cube.size) - 0.5f;
  const float x = std::clamp(s * scale + offset, 0.0f, last);
  const float y = std::clamp(t * scale + offset, 0.0f, last);
  const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
  const int x1 = std::min(x0 + 1, cube.size - 1), y1 = std::min(y0 + 1, cube.size - 1);
  const float fx = x - static_cast<float>(x0), fy = y - static_cast<float>(y0);
  const glm::vec3 top = cube.At(face, x0, y0) * (1.0f - fx) + cube.At(face, x1, y0) * fx;
  const glm::vec3 bottom = cube.At(face, x0, y1) * (1.0f - fx) + cube.At(face, x1, y1) * fx;
  return top * (1.0f - fy) + bottom * fy;
}

struct LobeSample {
  glm::vec3 direction;  ///< around +z
  float weight;
  float level;  ///< of the mip chain
};

// The radical inverse in base 2 (van der Corput), for Hammersley's points.
float RadicalInverse(std::uint32_t i) {
  std::uint32_t bits = 0;
  for (int k = 0; k < 32; ++k) bits |= ((i >> k) & 1u) << (31 - k);
  return static_cast<float>(bits) * 0x1p-32f;
}

std::vector<LobeSample> LobeSamples(float roughness, int face_size) {
  const float alpha = roughness * roughness;
  const float texel = 4.0f * kPi / (6.0f * static_cast<float>(face_size) * static_cast<float>(face_size));
  std::vector<LobeSample> samples;
  float total = 0.0f;
  for (int i = 0; i < kSamples; ++i) {
    const float u = (static_cast<float>(i) + 0.5f) / kSamples;
    const float phi = 2.0f * kPi * RadicalInverse(static_cast<std::uint32_t>(i));
    const float cosine = std::sqrt((1.0f - u) / (1.0f + (alpha * alpha - 1.0f) * u));
    const float sine = std::sqrt(std::max(0.0f, 1.0f - cosine * cosine));
    const glm::vec3 half(sine * std::cos(phi), sine * std::sin(phi), cosine);
    const glm::vec3 light(2.0f * half.z * half.x, 2.0f * half.z * half.y, 2.0f * half.z * half.z - 1.0f);
    if (light.z <= 0.0f) continue;
    const float d = cosine * cosine * (alpha * alpha - 1.0f) + 1.0f;
    const float density = alpha * alpha / (kPi * d * d) / 4.0f;  // D (n.h) / (4 v.h), with v = n
    const float solid_angle = 1.0f / (kSamples * density);
    const float level = std::max(0.0f, 0.5f * std::log2(solid_angle / texel));
    samples.push_back({light, light.z, level});
    total += light.z;
  }
  for (LobeSample& sample : samples) sample.weight /= total;
  return samples;
}

glm::vec3 SampleChain(const std::vector<Cube>& chain, const glm::vec3& direction, float level) {
  const float clamped = std::min(level, static_cast<float>(chain.size() - 1));
  const auto low = static_cast<std::size_t>(clamped);
  const float f = clamped - static_cast<float>(low);
  const glm::vec3 fine = SampleCube(chain[low], direction);
  if (f < 0.01f || low + 1 == chain.size()) return fine;
  return fine * (1.0f - f) + SampleCube(chain[low + 1], direction) * f;
}

glm::vec3 Filter(const std::vector<Cube>& chain, const std::vector<LobeSample>& lobe, const glm::vec3& axis) {
  const glm::vec3 up = std::abs(axis.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  const glm::vec3 x = glm::normalize(glm::cross(up, axis));
  const glm::vec3 y = glm::cross(axis, x);
  glm::vec3 sum(0.0f);
  for (const LobeSample& sample : lobe) {
    const glm::vec3 direction = sample.direction.x * x + sample.direction.y * y + sample.direction.z * axis;
    sum += sample.weight * SampleChain(chain, direction, sample.level);
  }
  return sum;
}

// The map at the cube's resolution: coarser than a texel of the map, a cell is the mean of 2 x 2 points.
Cube Resample(const EnvironmentMap& map, int face_size) {
  const bool is_coarser = map.width > 6 * face_size;
  Cube cube = FillCube(is_coarser ? 2 * face_size : face_size,
                       [&](const glm::vec3& direction) { return SampleEnvironment(map, direction); });
  return is_coarser ? Halve(cube) : cube;
}

}  // namespace

ReflectionMap FilterReflections(const EnvironmentMap& map, int face_size) {
  ReflectionMap result{.face_size = face_size, .levels = {}};
  std::vector<Cube> chain{Resample(map, face_size)};
  while (chain.back().size > 4) chain.push_back(Halve(chain.back()));
  const int levels = std::max(2, static_cast<int>(std::bit_width(static_cast<unsigned>(face_size / kSmallestFace))));
  result.levels.push_back(chain.front().texels);
  for (int level = 1; level < levels; ++level) {
    const std::vector<LobeSample> lobe =
        LobeSamples(static_cast<float>(level) / static_cast<float>(levels - 1), face_size);
    Cube filtered =
        FillCube(std::max(1, face_size >> level), [&](const glm::vec3& axis) { return Filter(chain, lobe, axis); });
    result.levels.push_back(std::move(filtered.texels));
  }
  return result;
}

}  // namespace burin::gbuffer

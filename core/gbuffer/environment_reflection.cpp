// SPDX-License-Identifier: Apache-2.0
// Karis, "Real Shading in Unreal Engine 4" (SIGGRAPH 2013 course): the prefiltered half of the split sum, view and normal
// taken along the reflection. Krivanek and Colbert, "Real-Time Shading with Filtered Importance Sampling" (EGSR 2008),
// equation 5 for the mip level of each sample, so that few samples give no noise.
#include <algorithm>
#include <bit>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <tbb/parallel_for.h>

#include "core/gbuffer/environment.h"

namespace burin::gbuffer {
namespace {

constexpr float kPi = glm::pi<float>();
constexpr int kSamples = 48;
constexpr int kSmallestFace = 8;

// Half the size, each texel the mean of four; equal weights do, as the lobes are wide where small levels are read.
EnvironmentMap Halve(const EnvironmentMap& map) {
  EnvironmentMap half{.width = std::max(1, map.width / 2), .height = std::max(1, map.height / 2), .pixels = {}};
  half.pixels.resize(static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height));
  const auto at = [&](int x, int y) {
    return map.pixels[static_cast<std::size_t>(std::min(y, map.height - 1)) * static_cast<std::size_t>(map.width) +
                      static_cast<std::size_t>(std::min(x, map.width - 1))];
  };
  for (int y = 0; y < half.height; ++y) {
    for (int x = 0; x < half.width; ++x) {
      half.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(half.width) + static_cast<std::size_t>(x)] =
          0.25f * (at(2 * x, 2 * y) + at(2 * x + 1, 2 * y) + at(2 * x, 2 * y + 1) + at(2 * x + 1, 2 * y + 1));
    }
  }
  return half;
}

std::vector<EnvironmentMap> MipChain(const EnvironmentMap& map) {
  std::vector<EnvironmentMap> chain{map};
  while (chain.back().width > 8 && chain.back().height > 4) chain.push_back(Halve(chain.back()));
  return chain;
}

struct LobeSample {
  glm::vec3 direction;   ///< around +z
  float weight;
  float level;           ///< of the mip chain
};

// The radical inverse in base 2 (van der Corput), for Hammersley's points.
float RadicalInverse(std::uint32_t i) {
  std::uint32_t bits = 0;
  for (int k = 0; k < 32; ++k) bits |= ((i >> k) & 1u) << (31 - k);
  return static_cast<float>(bits) * 0x1p-32f;
}

std::vector<LobeSample> LobeSamples(float roughness, const EnvironmentMap& map) {
  const float alpha = roughness * roughness;
  const float texel = 4.0f * kPi / (static_cast<float>(map.width) * static_cast<float>(map.height));
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
    const float density = alpha * alpha / (kPi * d * d) / 4.0f;   // D (n.h) / (4 v.h), with v = n
    const float solid_angle = 1.0f / (kSamples * density);
    // One level up, as the paper advises against gaps between the samples' footprints.
    const float level = std::max(0.0f, 0.5f * std::log2(solid_angle / texel) + 1.0f);
    samples.push_back({light, light.z, level});
    total += light.z;
  }
  for (LobeSample& sample : samples) sample.weight /= total;
  return samples;
}

glm::vec3 SampleChain(const std::vector<EnvironmentMap>& chain, const glm::vec3& direction, float level) {
  const float clamped = std::min(level, static_cast<float>(chain.size() - 1));
  const auto low = static_cast<std::size_t>(clamped);
  const float f = clamped - static_cast<float>(low);
  const glm::vec3 fine = SampleEnvironment(chain[low], direction);
  if (f < 0.01f || low + 1 == chain.size()) return fine;
  return fine * (1.0f - f) + SampleEnvironment(chain[low + 1], direction) * f;
}

// OpenGL 4.5 core, table 8.19. s and t in -1..1.
glm::vec3 FaceDirection(int face, float s, float t) {
  switch (face) {
    case 0: return {1.0f, -t, -s};
    case 1: return {-1.0f, -t, s};
    case 2: return {s, 1.0f, t};
    case 3: return {s, -1.0f, -t};
    case 4: return {s, -t, 1.0f};
    default: return {-s, -t, -1.0f};
  }
}

glm::vec3 Filter(const std::vector<EnvironmentMap>& chain, const std::vector<LobeSample>& lobe, const glm::vec3& axis) {
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

}  // namespace

ReflectionMap FilterReflections(const EnvironmentMap& map, int face_size) {
  ReflectionMap result{.face_size = face_size, .levels = {}};
  const std::vector<EnvironmentMap> chain = MipChain(map);
  const int levels = std::max(2, static_cast<int>(std::bit_width(static_cast<unsigned>(face_size / kSmallestFace))));
  // A face of the cube covers a quarter of the map's width.
  const float mirror_level = std::max(0.0f, std::log2(static_cast<float>(map.width) / 4.0f / static_cast<float>(face_size)));
  for (int level = 0; level < levels; ++level) {
    const int size = std::max(1, face_size >> level);
    std::vector<glm::vec3> texels(static_cast<std::size_t>(6 * size * size));
    const std::vector<LobeSample> lobe =
        level == 0 ? std::vector<LobeSample>{{glm::vec3(0, 0, 1), 1.0f, mirror_level}}
                   : LobeSamples(static_cast<float>(level) / static_cast<float>(levels - 1), map);
    tbb::parallel_for(0, 6 * size, [&](int row) {
      const int face = row / size;
      const float t = 2.0f * (static_cast<float>(row % size) + 0.5f) / static_cast<float>(size) - 1.0f;
      for (int column = 0; column < size; ++column) {
        const float s = 2.0f * (static_cast<float>(column) + 0.5f) / static_cast<float>(size) - 1.0f;
        texels[static_cast<std::size_t>(row * size + column)] = Filter(chain, lobe, glm::normalize(FaceDirection(face, s, t)));
      }
    });
    result.levels.push_back(std::move(texels));
  }
  return result;
}

}  // namespace burin::gbuffer

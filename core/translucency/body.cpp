// SPDX-License-Identifier: Apache-2.0
#include "core/translucency/body.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "core/scene/item_geometry.h"
#include "core/translucency/dipole.h"

namespace burin::translucency {
namespace {

constexpr float kPadding = 0.002f;   // of the largest extent: surfaces on the box's sides are drawn whole
constexpr float kThinnest = 0.001f;  // of the largest extent
constexpr int kMostAspect = 8;       // of a face's texels along two axes

// FNV-1a over words of eight bytes.
class Hash {
 public:
  void Add(std::span<const std::byte> bytes) {
    std::size_t i = 0;
    for (; i + 8 <= bytes.size(); i += 8) {
      std::uint64_t word = 0;
      std::memcpy(&word, bytes.data() + i, 8);
      AddWord(word);
    }
    std::uint64_t rest = bytes.size();
    for (; i < bytes.size(); ++i) rest = rest << 8 | std::to_integer<std::uint64_t>(bytes[i]);
    AddWord(rest);
  }
  template <class T>
  void AddValue(const T& value) {
    Add(std::as_bytes(std::span(&value, 1)));
  }
  template <class T>
  void AddAll(const std::vector<T>& values) {
    Add(std::as_bytes(std::span(values)));
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  void AddWord(std::uint64_t word) {
    value_ = (value_ ^ word) * 0x100000001b3u;
    value_ ^= value_ >> 29;
  }
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

void AddShape(Hash& hash, const scene::DrawItem& item) {
  hash.AddValue(item.mesh);
  hash.AddValue(item.primitive);
  hash.AddValue(item.world_from_object);
  if (item.surface != nullptr) {
    hash.AddAll(item.surface->triangles.positions);
    hash.AddAll(item.surface->triangles.normals);
  } else if (item.is_deformed) {
    hash.AddAll(item.deformed.positions);
    hash.AddAll(item.deformed.normals);
  }
}

// Texels along an axis: a power of two times less than the longest, so that texels are about square.
int TexelsAlong(float extent, float largest, int most) {
  const double ratio = std::clamp(static_cast<double>(extent / largest), 1.0 / kMostAspect, 1.0);
  return std::max(1, most >> static_cast<int>(std::floor(-std::log2(ratio) + 0.25)));
}

}  // namespace

BodyShape ShapeOf(const scene::Scene& scene, std::span<const scene::DrawItem> items, const BodyItems& body) {
  BodyShape shape;
  Hash hash;
  for (const gbuffer::PreparedDraw* draw : body.draws) {
    const scene::DrawItem& item = items[draw->block];
    AddShape(hash, item);
    for (const glm::vec3& position : scene::GeometryOf(scene, item).positions) {
      const glm::vec3 world(item.world_from_object * glm::vec4(position, 1.0f));
      if (!std::isfinite(world.x + world.y + world.z)) continue;
      shape.bounds.min = glm::min(shape.bounds.min, world);
      shape.bounds.max = glm::max(shape.bounds.max, world);
    }
  }
  shape.key = hash.value();
  return shape;
}

std::uint64_t LightingKey(const gbuffer::TranslucencyInput& input) {
  Hash hash;
  for (const gbuffer::LightRecord& light : input.lights) hash.AddValue(light);
  hash.AddValue(input.environment_strength);
  if (input.lights.empty()) return hash.value();
  for (const gbuffer::PreparedDraw& draw : input.draws->opaque) AddShape(hash, input.frame->items[draw.block]);
  return hash.value();
}

Sphere SphereOf(const scene::Bounds& bounds) {
  return {0.5f * (bounds.min + bounds.max), 0.5f * glm::distance(bounds.min, bounds.max)};
}

BodyBlock MakeBodyBlock(const scene::Bounds& bounds, const Medium& medium, const Quality& quality, double unit_mm,
                        float brightest, int lights) {
  BodyBlock block{};
  const glm::vec3 extent = bounds.max - bounds.min;
  const float largest = std::max({extent.x, extent.y, extent.z, 1e-30f});
  const glm::vec3 padded = glm::max(extent + 2.0f * kPadding * largest, glm::vec3(kThinnest * largest));
  const glm::vec3 low = 0.5f * (bounds.min + bounds.max) - 0.5f * padded;
  block.box_min = glm::vec4(low, static_cast<float>(unit_mm));
  block.box_mm = glm::vec4(padded * static_cast<float>(unit_mm), 0.0f);
  const float longest = std::max({padded.x, padded.y, padded.z});
  for (int axis = 0; axis < 3; ++axis) {
    block.texels[axis] = TexelsAlong(padded[axis], longest, quality.face_texels);
  }
  block.texels.w = quality.face_texels;

  const std::array<Dipole, 3> dipoles = MakeDipoles(medium);
  for (int c = 0; c < 3; ++c) {
    const Dipole& dipole = dipoles[static_cast<std::size_t>(c)];
    block.real_mm[c] = static_cast<float>(dipole.real_mm);
    block.virtual_mm[c] = static_cast<float>(dipole.virtual_mm);
    block.sigma_tr[c] = static_cast<float>(dipole.sigma_tr);
    block.reflectance[c] = static_cast<float>(dipole.Total());
    block.strength[c] = static_cast<float>(dipole.alpha / (4.0 * glm::pi<double>()));
  }
  block.real_mm.w = medium.ior;
  block.virtual_mm.w = brightest;
  const int whole = std::bit_width(static_cast<unsigned>(quality.face_texels)) - 1;
  const int top = whole - kWholeAboveTop;
  const float finest = std::min({block.real_mm.x, block.real_mm.y, block.real_mm.z});
  const double levels = std::floor(std::log2(std::max(static_cast<double>(finest) / TexelSize(block), 1e-3)));
  block.levels = glm::ivec4(std::clamp(static_cast<int>(levels), 0, top - 1), top, quality.receiver_shift, lights);
  return block;
}

float BrightestIrradiance(std::span<const gbuffer::LightRecord> lights, const scene::Bounds& bounds,
                          std::span<const glm::vec3> environment) {
  const float size = std::max(glm::distance(bounds.min, bounds.max), 1e-6f);
  float sum = 0.0f;
  for (const gbuffer::LightRecord& light : lights) {
    const float strength = std::max({light.color.r, light.color.g, light.color.b});
    const glm::vec3 position(light.position);
    const float away = glm::distance(position, glm::clamp(position, bounds.min, bounds.max));
    // Lamps that touch the surface are cut off: half floats hold no more than five decades anyhow.
    const float distance = std::max(away, 0.02f * size);
    sum += light.direction.w < 0.5f ? strength : strength / (distance * distance);
  }
  for (const glm::vec3& term : environment)
    sum += 1.1f * std::max({std::abs(term.r), std::abs(term.g), std::abs(term.b)});
  return std::max(sum, 1e-12f);
}

double TexelSize(const BodyBlock& block) {
  double most = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    most = std::max(most, static_cast<double>(block.box_mm[axis]) / block.texels[axis]);
  }
  return most;
}

}  // namespace burin::translucency

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/gbuffer/translucency_stage.h"
#include "core/scene/pose.h"
#include "core/scene/scene.h"
#include "core/translucency/body_block.h"
#include "core/translucency/medium.h"
#include "core/translucency/scattering_quality.h"
#include "core/translucency/shadow_maps.h"

namespace burin::translucency {

/// What light scatters through: the translucent surfaces of one node that are of one medium.
struct BodyItems {
  int node = scene::kNone;
  std::size_t medium = 0;
  std::vector<const gbuffer::PreparedDraw*> draws;
};

/// World-space bounds and a number that changes with any vertex.
struct BodyShape {
  scene::Bounds bounds;
  std::uint64_t key = 0;
};
[[nodiscard]] BodyShape ShapeOf(const scene::Scene& scene, std::span<const scene::DrawItem> items,
                                const BodyItems& body);

/// A number that changes with anything that throws a shadow, and with the lights.
[[nodiscard]] std::uint64_t LightingKey(const gbuffer::TranslucencyInput& input);

[[nodiscard]] Sphere SphereOf(const scene::Bounds& bounds);

/// Everything of the block but the environment. `brightest`: the largest irradiance. The box is never flat: an extent
/// is at least a thousandth of the largest.
[[nodiscard]] BodyBlock MakeBodyBlock(const scene::Bounds& bounds, const Medium& medium, const Quality& quality,
                                      double unit_mm, float brightest, int lights);

/// No light gives a surface within the bounds more; above 0.
[[nodiscard]] float BrightestIrradiance(std::span<const gbuffer::LightRecord> lights, const scene::Bounds& bounds,
                                        std::span<const glm::vec3> environment);

/// A texel's largest side, mm.
[[nodiscard]] double TexelSize(const BodyBlock& block);

}  // namespace burin::translucency

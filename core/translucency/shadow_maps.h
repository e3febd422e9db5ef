// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <map>
#include <span>

#include "core/base/error.h"
#include "core/gbuffer/geometry_pass.h"
#include "core/gbuffer/gpu_blocks.h"
#include "core/gbuffer/material_store.h"
#include "core/gl/handle.h"
#include "core/gl/program.h"
#include "core/translucency/body_block.h"

namespace burin::translucency {

/// Where a body lies, in world space.
struct Sphere {
  glm::vec3 center{0.0f};
  float radius = 0.0f;
};

/// What may throw shadows.
struct Casters {
  const gbuffer::FrameDraws& draws;
  gbuffer::MaterialStore& materials;
};

/// Depth as the lights see it, fitted to one body: one map for a light outside, six for one inside or beside it.
struct ShadowMaps {
  gl::TextureHandle texture;
  int count = 0;
  int texels = 0;  ///< of a map's side
};

/// How many maps that body takes.
[[nodiscard]] int CountShadowMaps(std::span<const gbuffer::LightRecord> lights, const Sphere& body);

/// Draws shadow maps; one for all bodies. Other objects throw their shadows on a body too, but for what is blended or
/// unlit (flames, glows), what a mask cuts out, and the backs of one-sided opaque surfaces: what an eye in the light's
/// place would not see.
class ShadowPass {
 public:
  /// Maps of `texels` a side for as many of the lights as ShadowBlock holds; `block` says which.
  [[nodiscard]] Result<void> Draw(std::span<const gbuffer::LightRecord> lights, const Casters& casters,
                                  const Sphere& body, int texels, ShadowMaps& maps, ShadowBlock& block);
  /// At kShadowUnit.
  void Bind(const ShadowMaps& maps) const;

 private:
  void EnsureTools();
  [[nodiscard]] Result<const gl::Program*> ProgramOf(std::uint32_t features);
  [[nodiscard]] Result<void> DrawCasters(const glm::mat4& clip_from_world, const Casters& casters);

  gl::SamplerHandle sampler_;
  gl::FramebufferHandle framebuffer_;
  std::map<std::uint32_t, gl::Program> programs_;  ///< by what cuts out
};

}  // namespace burin::translucency

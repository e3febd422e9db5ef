// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "core/base/error.h"
#include "core/gbuffer/geometry_pass.h"
#include "core/gbuffer/gpu_blocks.h"
#include "core/gl/handle.h"
#include "core/gl/program.h"
#include "core/translucency/body_block.h"

namespace burin::translucency {

/// Where a body lies, in world space.
struct Sphere {
  glm::vec3 center{0.0f};
  float radius = 0.0f;
};

/// Depth as the lights see it, fitted to one body: one map for a light outside, six for one inside or beside it. Other
/// objects throw their shadows too, but for what is blended or unlit (flames, glows).
class ShadowMaps {
 public:
  /// Maps of `texels` a side for as many of the lights as ShadowBlock holds; `block` says which.
  [[nodiscard]] Result<void> Draw(std::span<const gbuffer::LightRecord> lights, const gbuffer::FrameDraws& draws,
                                  const Sphere& body, int texels, ShadowBlock& block);
  /// At kShadowUnit.
  void Bind() const;

 private:
  [[nodiscard]] Result<void> EnsureMaps(int count, int texels);
  void DrawMap(const glm::mat4& clip_from_world, int map, const gbuffer::FrameDraws& draws);

  gl::TextureHandle maps_;
  gl::SamplerHandle sampler_;
  gl::FramebufferHandle framebuffer_;
  gl::Program program_;
  int count_ = 0;
  int texels_ = 0;
};

}  // namespace burin::translucency

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/gbuffer/attribute_renderer.h"
#include "core/gbuffer/gpu_blocks.h"
#include "core/gl/handle.h"
#include "core/gl/texture.h"
#include "core/scene/scene.h"

namespace burin::gbuffer {

/// Materials' numbers in one buffer; their textures, uploaded when a draw first looks at them.
class MaterialStore {
 public:
  explicit MaterialStore(const scene::Scene& scene);

  /// scene::kNone: glTF's default material.
  [[nodiscard]] const scene::Material& Get(int material) const;
  /// DrawFeature bits of its textures, alpha mode (kIsMasked) and unlit.
  [[nodiscard]] std::uint32_t Features(int material) const;
  /// Binds its numbers and those of its textures that `features` name.
  [[nodiscard]] Result<void> Bind(int material, std::uint32_t features);
  /// As SceneRenderer::TextureOf().
  [[nodiscard]] Result<const gl::Texture*> TextureOf(int material, MaterialTextureKind kind, bool is_decoded);

 private:
  [[nodiscard]] Result<const gl::Texture*> TextureOfImage(int image, bool is_color);
  [[nodiscard]] std::uint32_t SamplerOf(const scene::TextureSampler& sampler);

  const scene::Scene* scene_;
  scene::Material default_;
  gl::BufferHandle blocks_;
  std::map<std::pair<int, bool>, gl::Texture> textures_;
  std::map<std::uint32_t, gl::SamplerHandle> samplers_;
  float anisotropy_ = 1.0f;
};

/// What the shaders read of a material.
[[nodiscard]] MaterialBlock MakeMaterialBlock(const scene::Material& material);

}  // namespace burin::gbuffer

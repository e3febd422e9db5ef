// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/base/error.h"
#include "core/gl/handle.h"
#include "core/image/image.h"

namespace burin::gbuffer {

/// What is all around as effects look it up: a cube map of display-encoded colours, light above white cut off, faces in
/// GL's and Direct3D's order, directions in world space. Context's thread only.
class EnvironmentCube {
 public:
  /// `environment`: as SceneRenderer::Create takes it; it outlives this.
  explicit EnvironmentCube(const image::Image* environment) : environment_(environment) {}

  /// The texture's GL name, with mipmaps; made on the first call. 0 when the environment is empty.
  [[nodiscard]] std::uint32_t id();

 private:
  const image::Image* environment_;
  gl::TextureHandle texture_;
};

}  // namespace burin::gbuffer

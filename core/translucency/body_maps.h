// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "core/base/error.h"
#include "core/gl/handle.h"
#include "core/gl/texture.h"
#include "core/translucency/scattering_quality.h"

namespace burin::translucency {

/// A body's textures. Six faces side by side, S texels each way; sources have two rows of them a level.
struct BodyMaps {
  gl::Texture face_depth;      ///< 6 S x S: what is nearest to each face
  gl::Texture face_deepest;    ///< the same of what is farthest; not in the paper's way
  gl::Texture sources;         ///< 6 S x 4 S: the pyramid
  gl::Texture receivers;       ///< radiosity and depth, 6 R x 2 R
  gl::Texture near_receivers;  ///< made when asked for
  gl::FramebufferHandle depth_target;
  gl::FramebufferHandle deepest_target;
  gl::FramebufferHandle pyramid_target;

  [[nodiscard]] Result<void> Ensure(const Quality& quality, bool has_parts);
};

/// What a body's textures take on the device, its shadow maps (`shadow_maps` of them) included.
[[nodiscard]] std::size_t BytesOfMaps(const Quality& quality, bool has_parts, int shadow_maps);

/// Sums of what a texel's surfaces take in, before they are packed; any body's, one after the other.
struct SourceSums {
  gl::Texture light;
  gl::Texture place;
  gl::FramebufferHandle target;

  [[nodiscard]] Result<void> Ensure(int face_texels);
};

}  // namespace burin::translucency

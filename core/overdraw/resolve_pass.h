// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "core/base/error.h"
#include "core/gbuffer/storage.h"
#include "core/gl/fullscreen_quad.h"
#include "core/gl/program.h"
#include "core/gl/texture.h"
#include "core/overdraw/edge_quad_buffer.h"

namespace burin::overdraw {

/// Antialiases the discontinuity edges of a finished picture: each pixel that a visible edge crosses is mixed, in
/// linear light, with the pixel across the edge by the exact area that lies there. Nothing grows, and nothing but those
/// pixels is touched. After Persson, "Geometric Post-process Anti-Aliasing" (2011), with areas instead of distances.
class ResolvePass {
 public:
  /// Works on `color` in place. `storage`: how it is kept; CanLoadColor(storage). `depth`: reversed, of the same size.
  /// `quads`: with no reach. Errors: kFailed when memory is short.
  [[nodiscard]] Result<void> Draw(const gl::Texture& color, const gbuffer::Storage& storage, const gl::Texture& depth,
                                  const EdgeQuadBuffer& quads);

 private:
  struct Blend {
    gbuffer::Storage storage;
    gl::Program program;
  };
  /// Scratch of one size and format, clean between calls.
  struct Scratch {
    gl::Texture copy;
    std::array<gl::Texture, 3> areas;  ///< covered, exposed, across (resolve_pass.cpp)
  };
  [[nodiscard]] Result<Scratch*> ScratchFor(const gl::Texture& color);
  [[nodiscard]] Result<const gl::Program*> BlendProgram(const gbuffer::Storage& storage);

  gl::Program area_program_;
  gl::Program clean_program_;
  std::vector<Blend> blends_;
  std::vector<Scratch> scratches_;
};

}  // namespace burin::overdraw

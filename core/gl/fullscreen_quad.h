// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/error.h"
#include "core/gl/handle.h"

namespace burin::gl {

/// The quadrilateral of an effect pass: covers clip space exactly at z = 0, clockwise as Direct3D sees it. Attributes
/// at VertexLocation: POSITION is (x, y, 0, 1); TEXCOORD0..7 all hold the same (u, v, 0, 1) with (0,0) at the top left.
class FullscreenQuad {
 public:
  FullscreenQuad() = default;
  [[nodiscard]] static Result<FullscreenQuad> Create();
  /// Draws with whatever program, framebuffer and states are bound.
  void Draw() const;

 private:
  VertexArrayHandle vertex_array_;
  BufferHandle vertices_;
};

}  // namespace burin::gl

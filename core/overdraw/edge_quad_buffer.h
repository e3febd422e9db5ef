// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "core/gl/handle.h"
#include "core/overdraw/edge_quads.h"

namespace burin::overdraw {

/// Edge quads on the device. Vertex shaders that draw them begin with EdgeQuadVertexText().
class EdgeQuadBuffer {
 public:
  EdgeQuadBuffer();
  /// Replaces what there was.
  void Upload(std::span<const EdgeVertex> vertices);
  [[nodiscard]] bool empty() const { return quads_ == 0; }
  /// With whatever program, framebuffer and states are bound.
  void Draw() const;

 private:
  void ReserveIndices(std::size_t quads);

  gl::VertexArrayHandle vertex_array_;
  gl::BufferHandle vertices_;
  gl::BufferHandle indices_;
  std::size_t quads_ = 0;
  std::size_t indexed_quads_ = 0;
};

/// A whole vertex shader: flat v_segment and v_depth, as in EdgeVertex.
[[nodiscard]] std::string_view EdgeQuadVertexText();
}  // namespace burin::overdraw

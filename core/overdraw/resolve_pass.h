// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/gbuffer/storage.h"
#include "core/gl/program.h"
#include "core/gl/texture.h"
#include "core/overdraw/edge_lines.h"
#include "core/overdraw/edge_quad_buffer.h"

namespace burin::overdraw {

/// Antialiases the discontinuity edges of a finished picture: each pixel that a visible edge crosses is mixed, in
/// linear light, with what lies across the edge by the exact area that it has. Nothing grows, and nothing but those
/// pixels is touched. After Persson, "Geometric Post-process Anti-Aliasing" (2011), with areas instead of distances.
class ResolvePass {
 public:
  /// Works on `color` in place. `storage`: how it is kept; CanLoadColor(storage). `depth`: reversed, of the same size.
  /// `quads`: with QuadOptions::sums_folds; `lines`: the shading of the same edges. Errors: kFailed when memory is
  /// short.
  [[nodiscard]] Result<void> Draw(const gl::Texture& color, const gbuffer::Storage& storage, const gl::Texture& depth,
                                  const EdgeQuadBuffer& quads, const AreaLines& lines,
                                  const gbuffer::LineDrawer& draw_lines);

  /// Of the first picture that had edges: see ShareNearEdges.
  [[nodiscard]] std::optional<float> share() const { return share_; }

 private:
  struct Blend {
    gbuffer::Storage storage;
    gl::Program program;
  };
  enum Sum : std::size_t { kCovered, kExposed, kOthers, kInner, kOutline, kSums };
  /// Scratch of one size and format, clean between calls.
  struct Scratch {
    gl::Texture copy;
    std::array<gl::Texture, kSums> sums;  ///< resolve_pass.cpp
  };
  [[nodiscard]] Result<Scratch*> ScratchFor(const gl::Texture& color);
  [[nodiscard]] Result<const gl::Program*> BlendProgram(const gbuffer::Storage& storage);

  gl::Program area_program_;
  gl::Program clean_program_;
  std::vector<Blend> blends_;
  std::vector<Scratch> scratches_;
  std::optional<float> share_;
};

}  // namespace burin::overdraw

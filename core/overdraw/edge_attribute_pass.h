// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <list>
#include <optional>
#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/gbuffer/attribute_renderer.h"
#include "core/gbuffer/storage.h"
#include "core/gl/framebuffer.h"
#include "core/gl/fullscreen_quad.h"
#include "core/gl/program.h"
#include "core/gl/texture.h"
#include "core/overdraw/edge_quad_buffer.h"

namespace burin::overdraw {

/// Fills targets of `edges` and `edgedist` from a frame's edges: what the edges make of each pixel is gathered once, by
/// maximum or minimum, so that their order does not matter, and then stored into every target.
class EdgeAttributePass {
 public:
  /// `requests`: attributes of edges, all of the size of `depth` (reversed). `quads`: of any reach, without seams.
  /// Errors: kFailed when memory is short.
  [[nodiscard]] Result<void> Draw(std::span<const gbuffer::Request> requests, const gl::Texture& depth,
                                  const EdgeQuadBuffer& quads);

 private:
  /// What is gathered for one attribute at one size; kept from frame to frame.
  struct Scratch {
    gbuffer::Attribute attribute;
    gl::Texture texture;
    gl::Framebuffer framebuffer;
  };
  struct Store {
    gbuffer::Storage storage;
    gl::Program program;
  };
  [[nodiscard]] Result<const gl::Texture*> Gather(gbuffer::Attribute attribute, const gl::Texture& depth,
                                                  const EdgeQuadBuffer& quads);
  [[nodiscard]] Result<void> StoreInto(const gbuffer::Request& request, const gl::Texture& gathered);
  [[nodiscard]] Result<Scratch*> ScratchFor(gbuffer::Attribute attribute, int width, int height);
  [[nodiscard]] Result<const gl::Program*> StoreProgram(const gbuffer::Storage& storage);

  gl::Program coverage_program_;
  gl::Program distance_program_;
  std::list<Scratch> scratches_;
  std::list<Store> stores_;
  std::optional<gl::FullscreenQuad> quad_;
};

}  // namespace burin::overdraw

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <utility>

#include "core/base/error.h"
#include "core/gbuffer/attribute_renderer.h"
#include "core/gl/framebuffer.h"
#include "core/gl/fullscreen_quad.h"
#include "core/gl/program.h"

namespace burin::gbuffer {

/// Ordered-grid supersampling of a scene's colour: each pixel is the mean of k x k samples, in linear light and with
/// associated alpha. Only colour may be averaged; ids and data are rendered at their own size. Context's thread only.
class Supersampler {
 public:
  /// `samples` a pixel: 4 (k = 2) or 16 (k = 4).
  [[nodiscard]] static Result<std::unique_ptr<Supersampler>> Create(int samples);

  /// The frame's colour at this size: scene-linear RGBA32F, associated alpha. Valid until the next call of that size;
  /// the textures of every size are kept for the next frame. Errors: kFailed, naming the size that is rendered, when it
  /// is over the device's limit or memory is short; those of `renderer`.
  [[nodiscard]] Result<const gl::Texture*> Render(SceneRenderer& renderer, const FrameInput& frame, int width,
                                                  int height);

 private:
  /// One size's textures: what is rendered and its mean.
  struct Buffers {
    gl::Texture samples;
    gl::Texture mean;
    gl::Framebuffer framebuffer;  ///< on `mean`
  };

  Supersampler(int per_axis, gl::FullscreenQuad quad, gl::Program program)
      : per_axis_(per_axis), quad_(std::move(quad)), program_(std::move(program)) {}
  [[nodiscard]] Result<Buffers*> BuffersOf(int width, int height);
  void Average(const Buffers& buffers) const;

  int per_axis_;
  gl::FullscreenQuad quad_;
  gl::Program program_;
  std::map<std::pair<int, int>, Buffers> buffers_;
};

}  // namespace burin::gbuffer

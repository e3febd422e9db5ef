// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/effect/parameter_values.h"
#include "core/effect/pass_step.h"
#include "core/effect/schedule.h"
#include "core/effect/texture_store.h"
#include "core/gl/handle.h"

namespace burin::effect {

/// A step of a script that runs no shader: a clear of targets, or a copy of the source's colour into one.
class TargetStep {
 public:
  [[nodiscard]] static Result<TargetStep> Create(const fx::Effect& effect, const Step& step, const FrameTexture& frame,
                                                 TextureStore& textures);
  /// `source`: what a Kind::kSource copies, in whatever size.
  void Run(const ParameterValues& values, const gl::Texture& source);

 private:
  TargetStep() = default;
  void Clear(const ParameterValues& values) const;
  void Copy(const gl::Texture& source);

  Step step_;
  std::vector<bool> has_alpha_;         ///< of the colour targets
  gl::FramebufferHandle framebuffer_;
  gl::FramebufferHandle source_framebuffer_;
};

}  // namespace burin::effect

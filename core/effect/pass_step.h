// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/effect/parameter_values.h"
#include "core/effect/pass_program.h"
#include "core/effect/render_states.h"
#include "core/effect/sampler_states.h"
#include "core/effect/schedule.h"
#include "core/effect/texture_store.h"
#include "core/gl/handle.h"
#include "fx_parser/effect/effect.h"
#include "fx_parser/fx_parser.h"

namespace burin::effect {

/// The frame as a target. `srgb` is made when the first pass asks for it.
struct FrameTexture {
  const gl::Texture* texture = nullptr;
  gl::TextureHandle* srgb = nullptr;
};

/// One step of the schedule with everything that GL needs for it: program, framebuffer, states, samplers.
class PassStep {
 public:
  [[nodiscard]] static Result<PassStep> Create(const fx::Effect& effect, const Step& step, PassProgram program,
                                               const FrameTexture& frame, TextureStore& textures,
                                               const fx::ParameterLookup& lookup, std::vector<std::string>& warnings);

  /// Binds all of it and clears what the schedule says; the caller then draws.
  [[nodiscard]] Result<void> Begin(const fx::Effect& effect, const TextureStore& textures, const ParameterValues& values,
                                   const fx::ParameterLookup& lookup, std::vector<std::string>& warnings);
  /// Binds what the host gives to samplers without a file: `texture` is SceneDraw's; 0 leaves the stand-in.
  void BindHostTextures(const std::function<std::uint32_t(TextureMeaning, bool)>& texture) const;
  /// Whether any sampler shows this.
  [[nodiscard]] bool Shows(TextureMeaning meaning) const;
  void UpdateParameters(const ParameterValues& values) { program_.UpdateParameters(values); }
  /// For the scene's draws: `clockwise` is the winding that counts as front.
  void SetFrontFace(bool clockwise) const;
  /// Unbinds textures and samplers.
  void End() const;

  [[nodiscard]] std::size_t technique() const { return step_.technique; }
  [[nodiscard]] bool draws_scene() const { return step_.draws_scene; }
  [[nodiscard]] bool shows_source() const { return step_.shows_source && Shows(TextureMeaning::kBaseColor); }

 private:
  struct BoundSampler {
    std::size_t index = 0;       ///< in Effect::samplers
    gl::SamplerHandle sampler;
    SamplerStates states;
    bool is_dynamic = false;     ///< some state is an expression
    std::uint32_t texture = 0;
    std::optional<TextureMeaning> meaning;   ///< TextureStore::HostMeaning()
  };
  PassStep() = default;
  Result<void> CreateTargets(const fx::Effect& effect, const FrameTexture& frame, TextureStore& textures,
                             std::vector<std::string>& warnings);
  Result<gl::FramebufferHandle> CreateSrgbFramebuffer(const fx::Effect& effect, const FrameTexture& frame,
                                                      TextureStore& textures, std::uint32_t depth_stencil,
                                                      std::vector<std::string>& warnings);
  void CreateSamplers(const fx::Effect& effect, TextureStore& textures, const fx::ParameterLookup& lookup,
                      std::vector<std::string>& warnings);
  void Clear() const;
  void BindSamplers(const fx::Effect& effect, const TextureStore& textures, const fx::ParameterLookup& lookup);
  [[nodiscard]] HostUniforms MakeHostUniforms(const fx::Effect& effect, const RenderStates& states) const;

  Step step_;
  std::string label_;                ///< "toon.fx: pass P0", for messages
  PassProgram program_;
  RenderStates states_;              ///< from the states that are constant
  std::vector<const fx::PassState*> dynamic_states_;
  std::vector<BoundSampler> samplers_;
  gl::FramebufferHandle framebuffer_;
  gl::FramebufferHandle srgb_framebuffer_;
  std::vector<int> writable_;        ///< DrawTargets::writable
  std::vector<std::array<float, 4>> clear_colors_;
  bool said_bad_state_ = false;
};

}  // namespace burin::effect

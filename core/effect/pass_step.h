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
  std::array<float, 4> clear_color{};
};

/// One step of the schedule with everything that GL needs for it: program, framebuffer, states, samplers.
class PassStep {
 public:
  /// `programs`: the pass's own and those of fx::Pass::choices, where a text is there.
  [[nodiscard]] static Result<PassStep> Create(const fx::Effect& effect, const Step& step,
                                               std::vector<PassProgram> programs, const FrameTexture& frame,
                                               TextureStore& textures, const fx::ParameterLookup& lookup,
                                               std::vector<std::string>& warnings);

  /// Binds all of it and clears what the schedule says; the caller then draws.
  [[nodiscard]] Result<void> Begin(const fx::Effect& effect, const TextureStore& textures,
                                   const ParameterValues& values, const fx::ParameterLookup& lookup,
                                   std::vector<std::string>& warnings);
  /// Binds what the host gives to samplers without a file: `texture` is SceneDraw's; 0 leaves the stand-in.
  void BindHostTextures(const std::function<std::uint32_t(TextureMeaning, bool)>& texture) const;
  /// Whether any sampler shows this.
  [[nodiscard]] bool Shows(TextureMeaning meaning) const;
  /// Before each of the draws, with what is drawn in `context`.
  void UpdateObject(const fx::Effect& effect, const ParameterValues& values, const FrameContext& context,
                    const fx::ParameterLookup& lookup);
  /// For the scene's draws: `clockwise` is the winding that counts as front.
  void SetFrontFace(bool clockwise) const;
  /// Unbinds textures and samplers.
  void End() const;

  /// The fixed pipeline lights it, with the colours of the object's material.
  [[nodiscard]] bool lights_material() const { return lights_material_; }
  [[nodiscard]] std::size_t technique() const { return step_.technique; }
  [[nodiscard]] bool draws_scene() const { return step_.draws_scene; }
  [[nodiscard]] bool shows_source() const { return step_.shows_source && Shows(TextureMeaning::kBaseColor); }

 private:
  struct BoundSampler {
    std::size_t index = 0;  ///< in Effect::samplers
    gl::SamplerHandle sampler;
    SamplerStates states;
    bool is_dynamic = false;  ///< some state is an expression
    std::uint32_t texture = 0;
    std::optional<TextureMeaning> meaning;  ///< TextureStore::HostMeaning()
  };
  /// The shaders of the pass, or of one choice among several.
  struct Variant {
    PassProgram program;
    std::vector<BoundSampler> samplers;
  };
  PassStep() = default;
  [[nodiscard]] std::size_t Choose(const fx::Effect& effect, const fx::ParameterLookup& lookup) const;
  Result<void> CreateTargets(const fx::Effect& effect, const FrameTexture& frame, TextureStore& textures,
                             std::vector<std::string>& warnings);
  Result<gl::FramebufferHandle> CreateSrgbFramebuffer(const fx::Effect& effect, const FrameTexture& frame,
                                                      TextureStore& textures, std::uint32_t depth_stencil,
                                                      std::vector<std::string>& warnings);
  void CreateSamplers(const fx::Effect& effect, const std::vector<std::size_t>& samplers, TextureStore& textures,
                      const fx::ParameterLookup& lookup, std::vector<BoundSampler>& all,
                      std::vector<std::string>& warnings);
  void Clear() const;
  void BindSamplers(const fx::Effect& effect, const TextureStore& textures, const fx::ParameterLookup& lookup);
  [[nodiscard]] HostUniforms MakeHostUniforms(const fx::Effect& effect, const RenderStates& states) const;

  Step step_;
  std::string label_;                 ///< "toon.fx: pass P0", for messages
  std::vector<Variant> variants_;     ///< the first is the pass's own program
  std::vector<std::size_t> choices_;  ///< of each of fx::Pass::choices its variant; empty: there is no choice
  std::size_t current_ = 0;           ///< of the variants, since Begin()
  RenderStates states_;               ///< from the states that are constant
  std::vector<const fx::PassState*> dynamic_states_;
  gl::FramebufferHandle framebuffer_;
  gl::FramebufferHandle srgb_framebuffer_;
  std::vector<int> writable_;  ///< DrawTargets::writable
  std::vector<std::array<float, 4>> clear_colors_;
  bool lights_material_ = false;
  bool said_bad_state_ = false;
};

}  // namespace burin::effect

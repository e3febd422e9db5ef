// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/effect/effect_runner.h"
#include "core/effect/parameter_override.h"
#include "core/effect/schedule.h"
#include "core/effect/stand_in_textures.h"
#include "core/effect/texture_meaning.h"
#include "core/gl/handle.h"
#include "core/gl/texture.h"
#include "fx_parser/effect/effect.h"

namespace burin::effect {

/// Every texture that one technique touches: targets, files, stand-ins, depth-stencil buffers. A texture without a file
/// shows what MeaningOf() says: what is the object's, the source's and the surroundings' the caller binds, see
/// HostMeaning().
class TextureStore {
 public:
  /// Creates the targets and loads the files of `schedule`, and writes the files' sizes back into it. Errors: the
  /// loader's, with the texture's name; kInput for a file of `overrides` that is not there; kFailed over the device's
  /// limits.
  [[nodiscard]] static Result<TextureStore> Create(const fx::Effect& effect, Schedule& schedule,
                                                   const Overrides& overrides, const RunnerOptions& options,
                                                   std::vector<std::string>& warnings);

  /// A 2D texture; null for those that the technique doesn't touch.
  [[nodiscard]] const gl::Texture* texture(std::size_t index) const;
  /// What a sampler looks up: the texture's GL name, its sRGB view's when `srgb` and it has one, or a stand-in of the
  /// sampler's dimension when it has none.
  [[nodiscard]] std::uint32_t ForSampler(const fx::Sampler& sampler, bool srgb) const;
  /// What a sampler shows that has no texture with a file, so that ForSampler() gives a stand-in; empty: it has one.
  [[nodiscard]] std::optional<TextureMeaning> HostMeaning(const fx::Sampler& sampler) const;
  [[nodiscard]] const StandInTextures& stand_ins() const { return stand_ins_; }
  /// Makes the views that `ForSampler(..., true)` and sRGB writes need; false when the format has none.
  bool AddSrgbView(std::size_t index);
  [[nodiscard]] std::uint32_t srgb_view(std::size_t index) const;
  /// Of a texture that a function has filled.
  void SetProcedural(std::size_t index, gl::TextureHandle texture) { slots_[index].other = std::move(texture); }
  /// One for every size and, where a script has buffers of its own, for each of its textures.
  [[nodiscard]] Result<const gl::Texture*> DepthStencil(glm::ivec2 size, std::optional<std::size_t> owner);

 private:
  struct Slot {
    gl::Texture texture;
    gl::TextureHandle srgb;
    gl::TextureHandle other;                              ///< of any dimension: filled by a function, or a cube's file
    TextureMeaning meaning = TextureMeaning::kBaseColor;  ///< of one without a file
    bool is_file = false;                                 ///< of the role, whether or not there is one
  };
  [[nodiscard]] Result<void> AddTarget(const fx::Effect& effect, std::size_t index, glm::ivec2 size);
  [[nodiscard]] Result<void> AddFile(const fx::Effect& effect, std::size_t index, const Overrides& overrides,
                                     const RunnerOptions& options, bool is_given_by_host,
                                     std::vector<std::string>& warnings);

  std::vector<Slot> slots_;
  StandInTextures stand_ins_;
  std::map<std::tuple<int, int, std::optional<std::size_t>>, gl::Texture> depth_stencils_;
};

}  // namespace burin::effect

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "fx_parser/effect/effect.h"

namespace burin::effect {

/// What a texture without a file of its own shows.
enum class TextureMeaning {
  kBaseColor,  ///< of the object's material; over a whole target the source's picture
  kNormal,
  kSpecular,
  kEmissive,
  kOcclusion,    ///< of the object's material
  kEnvironment,  ///< cubes: what is all around
  kNoise,
  kRamp,  ///< black at u = 0 to white at u = 1
  kWhite
};

[[nodiscard]] constexpr bool IsOfMaterial(TextureMeaning meaning) { return meaning <= TextureMeaning::kOcclusion; }

/// By semantic, by the annotation textureState, by the file that it names, else by its name.
[[nodiscard]] TextureMeaning MeaningOf(const fx::Texture& texture);
/// Of a sampler that no texture is bound to, such as those of register(s0): by its name.
[[nodiscard]] TextureMeaning MeaningOf(const fx::Sampler& sampler);

/// A name that FX Composer's library gives to textures that the user is to replace; none comes with the effects.
[[nodiscard]] bool IsDefaultFile(std::string_view file);

}  // namespace burin::effect

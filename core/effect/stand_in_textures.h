// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <utility>

#include "core/effect/texture_meaning.h"
#include "core/gl/handle.h"
#include "fx_parser/effect/effect.h"

namespace burin::effect {

/// Textures for samplers that have none: white, a flat normal map, noise, a ramp, a grey cube. Made when first asked
/// for; the same bits in every run. Context's thread only.
class StandInTextures {
 public:
  /// The texture's GL name. `dimension`: kUnknown is k2D.
  [[nodiscard]] std::uint32_t Get(TextureMeaning meaning, fx::Dimension dimension) const;
  /// One 2D texel of this colour, 8 bits each.
  [[nodiscard]] std::uint32_t Plain(const std::array<std::uint8_t, 4>& color) const;

 private:
  mutable std::map<std::pair<TextureMeaning, fx::Dimension>, gl::TextureHandle> textures_;
  mutable std::map<std::array<std::uint8_t, 4>, gl::TextureHandle> plain_;
};

}  // namespace burin::effect

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace burin::gl {

/// How a target's numbers are held: kUnorm clamps to 0..1, kFloat holds any value.
enum class Numeric : std::uint8_t { kUnorm, kFloat };

/// One texture format as GL has it, with the swizzle that gives Direct3D 9's reading of missing components
/// (e.g. R32F reads as (r,1,1,1), L8 as (l,l,l,1), A8 as (0,0,0,a)). Formats whose written components GL cannot
/// place (A8, A8L8, X8R8G8B8) are held in four components.
struct Format {
  std::uint32_t internal = 0;             ///< GLenum, sized: GL_RGBA8, GL_R32F ...
  std::array<std::int32_t, 4> swizzle{};  ///< GL_RED .. GL_ZERO, for GL_TEXTURE_SWIZZLE_RGBA
  Numeric numeric = Numeric::kUnorm;
  int bits = 8;        ///< of the widest component
  int components = 4;  ///< that the format's name declares: 1 to 4
  bool operator==(const Format&) const = default;
};

/// Bits of r, g, b and a as they are stored; 0 where the format has none.
[[nodiscard]] std::array<int, 4> ComponentBits(const Format& format);

/// True for A8: the one component is read from alpha, (0,0,0,a).
[[nodiscard]] bool IsAlphaOnly(const Format& format);
/// True for L8, L16 and A8L8: red is read as r, g and b.
[[nodiscard]] bool IsLuminance(const Format& format);

}  // namespace burin::gl

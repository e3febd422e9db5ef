// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "fx_parser/effect/state.h"
#include "fx_parser/effect/value.h"

namespace burin::effect {

/// Direct3D 9's render states with its numbers, at the defaults that every pass starts from (D3DRENDERSTATETYPE).
struct RenderStates {
  struct Stencil {
    int func = 8;    ///< D3DCMPFUNC: 1 never .. 8 always
    int fail = 1;    ///< D3DSTENCILOP: 1 keep .. 8 decr
    int zfail = 1;
    int pass = 1;
    bool operator==(const Stencil&) const = default;
  };
  bool z_enable = true;
  bool z_write = true;
  int z_func = 4;
  int cull = 3;      ///< D3DCULL: 1 none, 2 clockwise, 3 counter-clockwise
  int fill = 3;      ///< D3DFILLMODE: 1 point, 2 wireframe, 3 solid
  bool alpha_test = false;
  int alpha_func = 8;
  int alpha_ref = 0; ///< 0..255
  bool blend = false;
  int src_blend = 2; ///< D3DBLEND: 1 zero .. 15 inverse blend factor
  int dest_blend = 1;
  int blend_op = 1;  ///< D3DBLENDOP: 1 add .. 5 max
  bool separate_alpha = false;
  int src_blend_alpha = 2;
  int dest_blend_alpha = 1;
  int blend_op_alpha = 1;
  std::array<float, 4> blend_factor{1, 1, 1, 1};
  bool stencil = false;
  bool two_sided_stencil = false;
  Stencil front;     ///< of clockwise faces, and of all when not two-sided
  Stencil ccw;
  int stencil_ref = 0;
  std::uint32_t stencil_mask = 0xFFFFFFFFu;
  std::uint32_t stencil_write_mask = 0xFFFFFFFFu;
  std::array<int, 4> color_write{15, 15, 15, 15};   ///< of targets 0..3: red 1, green 2, blue 4, alpha 8
  bool scissor_test = false;
  float depth_bias = 0;
  float slope_scale_depth_bias = 0;
  bool srgb_write = false;
  bool operator==(const RenderStates&) const = default;
};

/// Sets one state. On a value that the state cannot have nothing changes and the result says what is wrong
/// ("ZFunc is 12, not one of 1 to 8"); otherwise it is empty.
[[nodiscard]] std::string SetState(RenderStates& states, fx::RenderState name, const fx::Value& value);

/// As Direct3D spells it: "AlphaBlendEnable".
[[nodiscard]] std::string_view StateName(fx::RenderState name);

/// A D3DCOLOR (0xAARRGGBB), or one to four floats, as red, green, blue, alpha.
[[nodiscard]] std::array<float, 4> ColorFromState(const fx::Value& value);

}  // namespace burin::effect

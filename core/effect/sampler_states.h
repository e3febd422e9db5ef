// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/gl/handle.h"
#include "fx_parser/effect/state.h"
#include "fx_parser/effect/value.h"

namespace burin::effect {

/// Direct3D 9's sampler states with its numbers and defaults (D3DSAMPLERSTATETYPE).
struct SamplerStates {
  std::array<int, 3> address{1, 1, 1};   ///< 1 wrap, 2 mirror, 3 clamp, 4 border, 5 mirror once
  std::array<float, 4> border{0, 0, 0, 0};
  int mag_filter = 1;                    ///< 0 none (as point), 1 point, 2 linear, 3 anisotropic
  int min_filter = 1;
  int mip_filter = 0;                    ///< 0 none, 1 point, 2 linear
  float lod_bias = 0;
  int max_mip_level = 0;                 ///< the largest level that is looked up, 0 being the whole chain
  int max_anisotropy = 1;
  bool srgb = false;
  bool operator==(const SamplerStates&) const = default;
  [[nodiscard]] bool uses_mipmaps() const { return mip_filter != 0 || max_mip_level != 0; }
};

/// As SetState() of render_states.h.
[[nodiscard]] std::string SetState(SamplerStates& states, fx::SamplerStateName name, const fx::Value& value);
[[nodiscard]] std::string_view StateName(fx::SamplerStateName name);

[[nodiscard]] gl::SamplerHandle CreateSampler();
/// SRGBTexture is not among what a GL sampler holds: the view of the texture that is bound does it.
void UpdateSampler(const gl::SamplerHandle& sampler, const SamplerStates& states);

}  // namespace burin::effect

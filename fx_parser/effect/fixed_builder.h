// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a pass's states say of the fixed pipeline, gathered until it is known which stages it stands in for.

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "fx_parser/effect/fixed_function.h"
#include "fx_parser/effect/state.h"

namespace burin::fx {

struct TextureStageStates {
  std::optional<int> color_op, alpha_op, result, texcoord, transform_flags;
  std::array<std::optional<int>, 3> color_args, alpha_args;
  std::optional<std::size_t> texture;        ///< Texture[i], in Effect::textures
  std::optional<std::size_t> sampler;        ///< Sampler[i], in Effect::samplers
  bool has_no_texture = false;               ///< Texture[i] = NULL
  std::vector<SamplerState> sampler_states;  ///< MinFilter[i] and the like
};

struct FixedPassStates {
  std::map<int, TextureStageStates> stages;
  std::vector<FixedState> states;
  std::optional<bool> lighting, specular_enable, local_viewer;
  std::array<std::optional<int>, 4> sources;  ///< of diffuse, specular, ambient, emissive
};

}  // namespace burin::fx

// SPDX-License-Identifier: Apache-2.0
#pragma once
// The names of states and of their values, with Direct3D 9's numbers.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fx_parser/effect/state.h"

namespace burin::fx {

struct Enumerant {
  std::string_view name;
  int value;
};

enum class StateKind { kInteger, kFloat, kColor };

template <class NameType>
struct StateInfo {
  std::string_view name;
  NameType state;
  StateKind kind;
  std::span<const Enumerant> values;  ///< besides true and false
};

[[nodiscard]] std::span<const StateInfo<RenderState>> RenderStates();
[[nodiscard]] std::span<const StateInfo<SamplerStateName>> SamplerStates();

template <class NameType>
[[nodiscard]] const StateInfo<NameType>* FindState(std::span<const StateInfo<NameType>> table, std::string_view name);

[[nodiscard]] std::optional<int> FindEnumerant(std::span<const Enumerant> values, std::string_view name);

/// What a state that this table does not know means for the pass that sets it.
enum class OtherState {
  kUnknown,      ///< of no host that we know: a warning
  kHarmless,     ///< Direct3D 9's, without an effect on shaders here
  kFixedVertex,  ///< lights, materials, transforms: matters without a vertex shader
  kFixedPixel,   ///< texture stages: matters without a pixel shader
  kOtherStage    ///< geometry and tessellation shaders
};
[[nodiscard]] OtherState Classify(std::string_view name);

/// For suggestions: all names of render states, and VertexShader and PixelShader.
[[nodiscard]] std::vector<std::string> KnownPassStates();
[[nodiscard]] std::vector<std::string> KnownSamplerStates();
[[nodiscard]] bool IsHarmlessSamplerState(std::string_view name);

}  // namespace burin::fx

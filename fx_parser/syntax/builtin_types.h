// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fx_parser/semantics/type.h"

namespace burin::fx {

/// The built-in type of a type keyword. Numeric ones ("half3", "float4x4", "dword") are matched as written, the effect
/// framework's own ("texture", "Sampler2D", "PixelShader", "string") without case, as D3DX does. `vector` and `matrix`
/// are float4 and float4x4.
[[nodiscard]] std::optional<Type> FindBuiltinType(std::string_view name);

/// "float", "half", "int" ...: what vector<T,n> takes.
[[nodiscard]] std::optional<Scalar> FindScalar(std::string_view name);

/// Type keywords for near-name suggestions.
[[nodiscard]] std::vector<std::string> BuiltinTypeNames();

}  // namespace burin::fx

// SPDX-License-Identifier: Apache-2.0
#pragma once
// Look-ups as Direct3D 10 writes them, `texture.Sample(sampler, place)`: those that a sampler of Direct3D 9 can do are
// rows as of the intrinsics table; the others only have types.

#include <optional>
#include <span>
#include <string_view>

#include "fx_parser/semantics/intrinsics.h"

namespace burin::fx {

/// Their first parameter is the sampler.
[[nodiscard]] std::span<const Intrinsic> Methods();

/// Index in Methods() of the one of `texture` that takes these arguments; -1 when none does.
[[nodiscard]] int FindMethod(const Type& texture, std::string_view name, std::span<const Type> arguments);

/// What a method of later shader models gives, with any arguments; empty for names that no texture or buffer has.
[[nodiscard]] std::optional<Type> ForeignMethod(const Type& object, std::string_view name);

/// The element that a texture's look-ups give: float4 where none is written.
[[nodiscard]] Type TextureElement(const Type& texture);

}  // namespace burin::fx

// SPDX-License-Identifier: Apache-2.0
#pragma once
// The intrinsics of shader models 1 to 3 as a table: names, signatures, and how the GLSL writer renders each.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fx_parser/semantics/type.h"

namespace burin::fx {

/// What an intrinsic needs beyond its arguments.
enum IntrinsicTrait : unsigned {
  kPure = 0,
  kFragmentOnly = 1u << 0,         ///< ddx, clip: no vertex stage has them
  kImplicitDerivatives = 1u << 1,  ///< tex2D and ddx: undefined where neighbours do not run
  kHasEffect = 1u << 2,            ///< clip, sincos: not only a value
};

/// `signature`: result, ':', parameters. F float of any shape, N numeric of any shape, B/I/U/R bool/int/uint/float of
/// that shape, V float scalar or vector, M float matrix, m its transpose, Q square matrix, f float, b bool, i int4, 2 3
/// 4 float2 to float4, v void, p q r c samplers of one, two, three dimensions and of a cube, * the product's shape of
/// mul;
/// '>' marks an out parameter. All F, N or V of one call have one shape, that of the smallest operand.
/// `glsl`: the GLSL function ("burin_..." are of the prelude), or a form in which $0, $1 are the arguments.
struct Intrinsic {
  std::string_view name;
  std::string_view signature;
  std::string_view glsl;
  unsigned traits = kPure;
};

struct IntrinsicCall {
  Type result;
  std::vector<Type> parameters;
  std::vector<bool> is_out;
};

[[nodiscard]] std::span<const Intrinsic> Intrinsics();
[[nodiscard]] bool IsIntrinsic(std::string_view name);

/// The types that a call with these arguments has; empty when the arguments do not fit.
[[nodiscard]] std::optional<IntrinsicCall> ResolveIntrinsic(const Intrinsic& intrinsic,
                                                            std::span<const Type> arguments);

/// Index in Intrinsics() of the form of `name` that takes these arguments; -1 when none does.
[[nodiscard]] int FindIntrinsic(std::string_view name, std::span<const Type> arguments);

/// The sampler dimension that a texture look-up takes; kUnknown for other intrinsics.
[[nodiscard]] Dimension LookupDimension(const Intrinsic& intrinsic);

/// "float4 tex2D(sampler2D, float2)", for notes.
[[nodiscard]] std::string DescribeIntrinsic(const Intrinsic& intrinsic);

}  // namespace burin::fx

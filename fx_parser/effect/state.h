// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include "fx_parser/effect/value.h"
#include "fx_parser/source/source.h"

namespace burin::fx {

namespace ast {
struct Expression;
}

/// The render states that a pass can set and this host honours, under their D3D9 names (D3DRENDERSTATETYPE).
enum class RenderState : std::uint8_t {
  kZEnable, kZWriteEnable, kZFunc, kCullMode, kFillMode,
  kAlphaTestEnable, kAlphaFunc, kAlphaRef,
  kAlphaBlendEnable, kSrcBlend, kDestBlend, kBlendOp,
  kSeparateAlphaBlendEnable, kSrcBlendAlpha, kDestBlendAlpha, kBlendOpAlpha, kBlendFactor,
  kStencilEnable, kStencilFunc, kStencilRef, kStencilMask, kStencilWriteMask, kStencilFail, kStencilZFail, kStencilPass,
  kTwoSidedStencilMode, kCcwStencilFail, kCcwStencilZFail, kCcwStencilPass, kCcwStencilFunc,
  kColorWriteEnable, kColorWriteEnable1, kColorWriteEnable2, kColorWriteEnable3,
  kScissorTestEnable, kDepthBias, kSlopeScaleDepthBias, kSrgbWriteEnable,
  kCount
};

/// Sampler states (D3DSAMPLERSTATETYPE), with D3D9's numbers as values: filters none 0, point 1, linear 2, anisotropic 3;
/// addresses wrap 1, mirror 2, clamp 3, border 4, mirroronce 5.
enum class SamplerStateName : std::uint8_t {
  kAddressU, kAddressV, kAddressW, kBorderColor, kMagFilter, kMinFilter, kMipFilter, kMipMapLodBias, kMaxMipLevel,
  kMaxAnisotropy, kSrgbTexture, kCount
};

/// The right side of a state: a constant, or an expression over parameters that the host evaluates before each pass
/// with EvaluateExpression. Enumerants are resolved to D3D9's numbers (D3DBLEND_ONE = 2, D3DCULL_CCW = 3 ...).
using StateValue = std::variant<Value, const ast::Expression*>;

template <class NameType>
struct State {
  NameType name{};
  StateValue value;
  Range range;
};
using PassState = State<RenderState>;
using SamplerState = State<SamplerStateName>;

}  // namespace burin::fx

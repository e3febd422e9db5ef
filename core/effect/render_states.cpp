// SPDX-License-Identifier: Apache-2.0
#include "core/effect/render_states.h"

#include <cmath>

#include <fmt/format.h>

namespace burin::effect {
namespace {

constexpr std::array<std::string_view, static_cast<std::size_t>(fx::RenderState::kCount)> kNames = {
    "ZEnable", "ZWriteEnable", "ZFunc", "CullMode", "FillMode",
    "AlphaTestEnable", "AlphaFunc", "AlphaRef",
    "AlphaBlendEnable", "SrcBlend", "DestBlend", "BlendOp",
    "SeparateAlphaBlendEnable", "SrcBlendAlpha", "DestBlendAlpha", "BlendOpAlpha", "BlendFactor",
    "StencilEnable", "StencilFunc", "StencilRef", "StencilMask", "StencilWriteMask", "StencilFail", "StencilZFail",
    "StencilPass", "TwoSidedStencilMode", "CCW_StencilFail", "CCW_StencilZFail", "CCW_StencilPass", "CCW_StencilFunc",
    "ColorWriteEnable", "ColorWriteEnable1", "ColorWriteEnable2", "ColorWriteEnable3",
    "ScissorTestEnable", "DepthBias", "SlopeScaleDepthBias", "SRGBWriteEnable"};

constexpr int kMaxCompare = 8;
constexpr int kMaxStencilOp = 8;
constexpr int kMaxBlend = 15;
constexpr int kMaxBlendOp = 5;

// An integer of any sign as the DWORD that Direct3D holds; -1 is 0xFFFFFFFF.
std::uint32_t Dword(double number) {
  if (!std::isfinite(number)) return 0;
  return static_cast<std::uint32_t>(static_cast<std::int64_t>(std::fmod(number, 4294967296.0)) & 0xFFFFFFFF);
}

}  // namespace

std::string_view StateName(fx::RenderState name) { return kNames[static_cast<std::size_t>(name)]; }

std::array<float, 4> ColorFromState(const fx::Value& value) {
  std::array<float, 4> color{0, 0, 0, 0};
  if (value.numbers.size() == 1) {
    const std::uint32_t argb = Dword(value.numbers[0]);
    constexpr std::array<int, 4> kShift = {16, 8, 0, 24};
    for (std::size_t i = 0; i < 4; ++i) color[i] = static_cast<float>((argb >> kShift[i]) & 0xFFu) / 255.0f;
    return color;
  }
  for (std::size_t i = 0; i < 4 && i < value.numbers.size(); ++i) color[i] = static_cast<float>(value.numbers[i]);
  return color;
}

std::string SetState(RenderStates& states, fx::RenderState name, const fx::Value& value) {
  if (value.numbers.empty()) return fmt::format("{} has no number for a value", StateName(name));
  const double number = value.numbers[0];
  std::string fault;

  const auto boolean = [&](bool& target) { target = number != 0; };
  const auto enumerant = [&](int& target, int last) {
    if (number >= 1 && number <= last) {
      target = static_cast<int>(number);
    } else {
      fault = fmt::format("{} is {}, not one of 1 to {}", StateName(name), number, last);
    }
  };
  const auto mask = [&](std::size_t index) { states.color_write[index] = static_cast<int>(Dword(number) & 15u); };

  switch (name) {
    case fx::RenderState::kZEnable: boolean(states.z_enable); break;
    case fx::RenderState::kZWriteEnable: boolean(states.z_write); break;
    case fx::RenderState::kZFunc: enumerant(states.z_func, kMaxCompare); break;
    case fx::RenderState::kCullMode: enumerant(states.cull, 3); break;
    case fx::RenderState::kFillMode: enumerant(states.fill, 3); break;
    case fx::RenderState::kAlphaTestEnable: boolean(states.alpha_test); break;
    case fx::RenderState::kAlphaFunc: enumerant(states.alpha_func, kMaxCompare); break;
    case fx::RenderState::kAlphaRef: states.alpha_ref = static_cast<int>(Dword(number) & 0xFFu); break;
    case fx::RenderState::kAlphaBlendEnable: boolean(states.blend); break;
    case fx::RenderState::kSrcBlend: enumerant(states.src_blend, kMaxBlend); break;
    case fx::RenderState::kDestBlend: enumerant(states.dest_blend, kMaxBlend); break;
    case fx::RenderState::kBlendOp: enumerant(states.blend_op, kMaxBlendOp); break;
    case fx::RenderState::kSeparateAlphaBlendEnable: boolean(states.separate_alpha); break;
    case fx::RenderState::kSrcBlendAlpha: enumerant(states.src_blend_alpha, kMaxBlend); break;
    case fx::RenderState::kDestBlendAlpha: enumerant(states.dest_blend_alpha, kMaxBlend); break;
    case fx::RenderState::kBlendOpAlpha: enumerant(states.blend_op_alpha, kMaxBlendOp); break;
    case fx::RenderState::kBlendFactor: states.blend_factor = ColorFromState(value); break;
    case fx::RenderState::kStencilEnable: boolean(states.stencil); break;
    case fx::RenderState::kStencilFunc: enumerant(states.front.func, kMaxCompare); break;
    case fx::RenderState::kStencilRef: states.stencil_ref = static_cast<int>(Dword(number) & 0xFFu); break;
    case fx::RenderState::kStencilMask: states.stencil_mask = Dword(number); break;
    case fx::RenderState::kStencilWriteMask: states.stencil_write_mask = Dword(number); break;
    case fx::RenderState::kStencilFail: enumerant(states.front.fail, kMaxStencilOp); break;
    case fx::RenderState::kStencilZFail: enumerant(states.front.zfail, kMaxStencilOp); break;
    case fx::RenderState::kStencilPass: enumerant(states.front.pass, kMaxStencilOp); break;
    case fx::RenderState::kTwoSidedStencilMode: boolean(states.two_sided_stencil); break;
    case fx::RenderState::kCcwStencilFail: enumerant(states.ccw.fail, kMaxStencilOp); break;
    case fx::RenderState::kCcwStencilZFail: enumerant(states.ccw.zfail, kMaxStencilOp); break;
    case fx::RenderState::kCcwStencilPass: enumerant(states.ccw.pass, kMaxStencilOp); break;
    case fx::RenderState::kCcwStencilFunc: enumerant(states.ccw.func, kMaxCompare); break;
    case fx::RenderState::kColorWriteEnable: mask(0); break;
    case fx::RenderState::kColorWriteEnable1: mask(1); break;
    case fx::RenderState::kColorWriteEnable2: mask(2); break;
    case fx::RenderState::kColorWriteEnable3: mask(3); break;
    case fx::RenderState::kScissorTestEnable: boolean(states.scissor_test); break;
    case fx::RenderState::kDepthBias: states.depth_bias = static_cast<float>(number); break;
    case fx::RenderState::kSlopeScaleDepthBias: states.slope_scale_depth_bias = static_cast<float>(number); break;
    case fx::RenderState::kSrgbWriteEnable: boolean(states.srgb_write); break;
    case fx::RenderState::kCount: break;
  }
  return fault;
}

}  // namespace burin::effect

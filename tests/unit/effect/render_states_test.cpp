// SPDX-License-Identifier: Apache-2.0
#include "core/effect/render_states.h"

#include <gtest/gtest.h>

#include "core/effect/sampler_states.h"

namespace burin::effect {
namespace {

fx::Value Number(double number) {
  fx::Value value;
  value.numbers = {number};
  return value;
}

TEST(RenderStates, BadEnumerantsChangeNothingAndSayWhy) {
  RenderStates states;
  EXPECT_EQ(SetState(states, fx::RenderState::kZFunc, Number(12)), "ZFunc is 12, not one of 1 to 8");
  EXPECT_EQ(SetState(states, fx::RenderState::kSrcBlend, Number(0)), "SrcBlend is 0, not one of 1 to 15");
  EXPECT_EQ(SetState(states, fx::RenderState::kCullMode, fx::Value{}), "CullMode has no number for a value");
  EXPECT_EQ(states, RenderStates());
}

TEST(RenderStates, ColoursAreArgbOrFloats) {
  EXPECT_EQ(ColorFromState(Number(0x80FF0033)), (std::array<float, 4>{1, 0, 0.2f, 128.0f / 255}));
  EXPECT_EQ(ColorFromState(Number(-1)), (std::array<float, 4>{1, 1, 1, 1}));
  fx::Value floats;
  floats.numbers = {0.25, 0.5, 0.75, 2};
  EXPECT_EQ(ColorFromState(floats), (std::array<float, 4>{0.25f, 0.5f, 0.75f, 2}));
}

TEST(RenderStates, MasksAreDwords) {
  RenderStates states;
  EXPECT_EQ(SetState(states, fx::RenderState::kStencilMask, Number(-1)), "");
  EXPECT_EQ(states.stencil_mask, 0xFFFFFFFFu);
  EXPECT_EQ(SetState(states, fx::RenderState::kStencilWriteMask, Number(0xFFFFFFF0)), "");
  EXPECT_EQ(states.stencil_write_mask, 0xFFFFFFF0u);
  EXPECT_EQ(SetState(states, fx::RenderState::kColorWriteEnable, Number(0xFF)), "");
  EXPECT_EQ(states.color_write[0], 15);
}

TEST(RenderStates, EveryStateHasItsName) {
  EXPECT_EQ(StateName(fx::RenderState::kZEnable), "ZEnable");
  EXPECT_EQ(StateName(fx::RenderState::kBlendFactor), "BlendFactor");
  EXPECT_EQ(StateName(fx::RenderState::kCcwStencilFunc), "CCW_StencilFunc");
  EXPECT_EQ(StateName(fx::RenderState::kColorWriteEnable3), "ColorWriteEnable3");
  EXPECT_EQ(StateName(fx::RenderState::kSrgbWriteEnable), "SRGBWriteEnable");
  EXPECT_EQ(StateName(fx::SamplerStateName::kSrgbTexture), "SRGBTexture");
  EXPECT_EQ(StateName(fx::SamplerStateName::kMaxAnisotropy), "MaxAnisotropy");
}

TEST(SamplerStates, BadEnumerantsChangeNothingAndSayWhy) {
  SamplerStates states;
  EXPECT_EQ(SetState(states, fx::SamplerStateName::kAddressU, Number(0)), "AddressU is 0, not one of 1 to 5");
  EXPECT_EQ(SetState(states, fx::SamplerStateName::kMinFilter, Number(9)), "MinFilter is 9, not one of 0 to 3");
  EXPECT_EQ(states, SamplerStates());
}

}  // namespace
}  // namespace burin::effect

// SPDX-License-Identifier: Apache-2.0
// CgFX's states as Direct3D's: name, number, in the order in which they are set.
#include <gtest/gtest.h>

#include "tests/unit/fx_parser/compile_effect.h"

namespace burin::fx {
namespace {

using enum RenderState;
using States = std::vector<std::pair<RenderState, double>>;

States StatesOf(const std::string& states, const std::string& path = "test.cgfx") {
  InMemoryFileSystem files;
  files.files[path] =
      "float4 PS() : COLOR { return 0; } technique { pass { FragmentProgram = compile fp40 PS(); " + states + " } }";
  const CompileResult result = CompileEffect(path, files, {});
  EXPECT_EQ(test::Messages(result), "") << states;
  States list;
  if (!result.effect) return list;
  for (const PassState& state : result.effect->techniques[0].passes[0].states)
    list.emplace_back(state.name, std::get<Value>(state.value).numbers[0]);
  return list;
}

TEST(CgStates, OfSeveralValuesBecomeSeveral) {
  const auto off = std::pair(kCullMode, 1.0);
  EXPECT_EQ(StatesOf("BlendFunc = int2(SrcAlpha, OneMinusSrcAlpha);"), (States{{kSrcBlend, 5}, {kDestBlend, 6}, off}));
  EXPECT_EQ(StatesOf("BlendFuncSeparate = int4(One, Zero, DstColor, SrcAlphaSaturate);"),
            (States{{kSrcBlend, 2},
                    {kDestBlend, 1},
                    {kSrcBlendAlpha, 9},
                    {kDestBlendAlpha, 11},
                    {kSeparateAlphaBlendEnable, 1},
                    off}));
  EXPECT_EQ(StatesOf("BlendEquation = FuncReverseSubtract;"), (States{{kBlendOp, 3}, off}));
  EXPECT_EQ(StatesOf("AlphaFunc = float2(Greater, 0.5);"), (States{{kAlphaFunc, 5}, {kAlphaRef, 128}, off}));
  EXPECT_EQ(StatesOf("ColorMask = bool4(true, false, true, false);"), (States{{kColorWriteEnable, 5}, off}));
  EXPECT_EQ(StatesOf("PolygonMode = int2(FrontAndBack, Line);"), (States{{kFillMode, 2}, off}));
  EXPECT_EQ(StatesOf("PolygonOffset = float2(2, 16777216);"),
            (States{{kSlopeScaleDepthBias, 2}, {kDepthBias, 1}, off}));
  EXPECT_EQ(
      StatesOf("StencilFunc = int3(NotEqual, 3, 0xff); StencilOp = int3(Keep, Incr, IncrWrap); StencilMask = 15;"),
      (States{{kStencilFunc, 6},
              {kStencilRef, 3},
              {kStencilMask, 255},
              {kStencilFail, 1},
              {kStencilZFail, 4},
              {kStencilPass, 7},
              {kStencilWriteMask, 15},
              off}));
  EXPECT_EQ(StatesOf("DepthTestEnable = true; DepthMask = false; DepthFunc = GEqual; BlendEnable = true;"),
            (States{{kZEnable, 1}, {kZWriteEnable, 0}, {kZFunc, 7}, {kAlphaBlendEnable, 1}, off}));
}

TEST(CgStates, CullingIsOffUnlessEnabled) {
  EXPECT_EQ(StatesOf(""), (States{{kCullMode, 1}}));
  EXPECT_EQ(StatesOf("CullFace = Front;"), (States{{kCullMode, 1}}));
  EXPECT_EQ(StatesOf("CullFaceEnable = true;"), (States{{kCullMode, 3}}));
  EXPECT_EQ(StatesOf("CullFaceEnable = true; CullFace = Front;"), (States{{kCullMode, 2}}));
  EXPECT_EQ(StatesOf("CullFace = Front; FrontFace = CW; CullFaceEnable = true;"), (States{{kCullMode, 3}}));
  EXPECT_EQ(StatesOf("CullMode = CW;"), (States{{kCullMode, 2}}));
  EXPECT_EQ(StatesOf("", "test.fx"), States{});
}

TEST(CgStates, OfOpenGlThatMeanNothingToShadersAreTaken) {
  EXPECT_EQ(StatesOf("ClearColor = float4(0, 0, 0, 1); ClearDepth = 1; LineWidth = 2; LightingEnable = false; "
                     "Texture2DEnable[0] = true; DepthRange = float2(0, 1);"),
            (States{{kCullMode, 1}}));
}

TEST(CgStates, SayWhatTheyExpect) {
  EXPECT_EQ(test::Messages("float4 PS() : COLOR { return 0; } technique { pass { PixelShader = compile ps_2_0 PS();\n"
                           "BlendFunc = int2(SrcAlpa, One); } }"),
            "2:18: error: undeclared identifier 'SrcAlpa' as value of SrcBlend; did you mean 'srcalpha'? [X3004]\n");
}

}  // namespace
}  // namespace burin::fx

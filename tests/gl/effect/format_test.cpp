// SPDX-License-Identifier: Apache-2.0
// Targets of every format read as Direct3D 9 reads them: what a format lacks is 1, only A8's colour is 0.
#include <string>

#include "tests/gl/effect/effect_fixture.h"

namespace burin::effect {
namespace {

// Writes a constant into a target of the format and reads it back through a sampler.
Rgba ThroughFormat(const std::string& format, const std::string& written, const std::string& states = {}) {
  const std::string texture = "PASS0_" + format;
  const std::string text = "texture " + texture + ";\nsampler s = sampler_state { Texture = <" + texture +
                           ">; };\n"
                           "float4 Write() : COLOR { return " +
                           written +
                           "; }\nfloat4 Read(float2 uv : TEXCOORD0) : COLOR { return tex2D(s, uv); }\n"
                           "technique T < string ColorSpace = \"linear\"; > { pass A { " +
                           states +
                           " PixelShader = compile ps_2_0 Write(); }"
                           " pass B { PixelShader = compile ps_2_0 Read(); } }";
  return RunText(text, 1, 1).at(0, 0);
}

struct Case {
  const char* format;
  Rgba expected;   ///< of (0.25, 0.5, 0.75, 0.125)
  float tolerance; ///< half a step of the format
};

class TargetFormats : public ::testing::TestWithParam<Case> {};

TEST_P(TargetFormats, ReadAsDirect3D) {
  const Case& tested = GetParam();
  EXPECT_TRUE(Near(ThroughFormat(tested.format, "float4(0.25, 0.5, 0.75, 0.125)"), tested.expected, tested.tolerance))
      << tested.format;
}

constexpr float kHalfStep8 = 0.51f / 255;
constexpr float kHalfStep16 = 0.51f / 65535;
INSTANTIATE_TEST_SUITE_P(
    All, TargetFormats,
    ::testing::Values(Case{"A8R8G8B8", {0.25f, 0.5f, 0.75f, 0.125f}, kHalfStep8},
                      Case{"X8R8G8B8", {0.25f, 0.5f, 0.75f, 1}, kHalfStep8}, Case{"A8", {0, 0, 0, 0.125f}, kHalfStep8},
                      Case{"L8", {0.25f, 0.25f, 0.25f, 1}, kHalfStep8},
                      Case{"L16", {0.25f, 0.25f, 0.25f, 1}, kHalfStep16},
                      Case{"A8L8", {0.25f, 0.25f, 0.25f, 0.125f}, kHalfStep8},
                      Case{"R5G6B5", {0.25f, 0.5f, 0.75f, 1}, 0.51f / 31},
                      Case{"A2B10G10R10", {0.25f, 0.5f, 0.75f, 0}, 0.51f / 1023},
                      Case{"G16R16", {0.25f, 0.5f, 1, 1}, kHalfStep16},
                      Case{"A16B16G16R16", {0.25f, 0.5f, 0.75f, 0.125f}, kHalfStep16},
                      Case{"B16G16R16", {0.25f, 0.5f, 0.75f, 1}, kHalfStep16}, Case{"R16F", {0.25f, 1, 1, 1}, 0},
                      Case{"G16R16F", {0.25f, 0.5f, 1, 1}, 0},
                      Case{"A16B16G16R16F", {0.25f, 0.5f, 0.75f, 0.125f}, 0}, Case{"R32F", {0.25f, 1, 1, 1}, 0},
                      Case{"G32R32F", {0.25f, 0.5f, 1, 1}, 0},
                      Case{"A32B32G32R32F", {0.25f, 0.5f, 0.75f, 0.125f}, 0}),
    [](const auto& tested) { return std::string(tested.param.format); });

TEST(TargetFormat, FixedPointClampsAndFloatsDoNot) {
  EXPECT_RGBA(ThroughFormat("A8R8G8B8", "float4(-1, 2, 0, 1)"), 0, 1, 0, 1);
  EXPECT_RGBA(ThroughFormat("A16B16G16R16", "float4(-1, 2, 0, 1)"), 0, 1, 0, 1);
  EXPECT_RGBA(ThroughFormat("A16B16G16R16F", "float4(-1, 2, 1000, -0.5)"), -1, 2, 1000, -0.5f);
  EXPECT_RGBA(ThroughFormat("A32B32G32R32F", "float4(-1, 16777217.0, 1e20, 3)"), -1, 16777216, 1e20f, 3);
}

TEST(TargetFormat, ATargetWithoutAlphaBlendsAsIfItsAlphaWereOne) {
  const std::string states = "AlphaBlendEnable = true; SrcBlend = DestAlpha; DestBlend = InvDestAlpha;";
  EXPECT_TRUE(Near(ThroughFormat("X8R8G8B8", "float4(0.2, 0.4, 0.6, 0)", states), {0.2f, 0.4f, 0.6f, 1}, kHalfStep8));
  // With an alpha of its own, cleared to 0, nothing arrives.
  EXPECT_RGBA(ThroughFormat("A8R8G8B8", "float4(0.2, 0.4, 0.6, 0)", states), 0, 0, 0, 0);
}

}  // namespace
}  // namespace burin::effect

// SPDX-License-Identifier: Apache-2.0
// Runs tests/data/fx/arithmetic.txt: the language's meaning, on the device, case by case.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/gl/effect/effect_fixture.h"

namespace burin::effect {
namespace {

/// Of a result's size: functions such as atan are approximate on devices.
constexpr float kTolerance = 1e-4f;

const char kParameters[] =
    "float4 v = {1,-2,0.5,3}; float z = 0; int three = 3; int two = 2; int mfive = -5; bool yes = true;\n"
    "float4x4 M = {1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16}; float2x3 N = {1,2,3,4,5,6};\n"
    "struct S { float3 a; float b; }; float arr[3] = {10,20,30};\n";

std::string EffectOf(std::string code) {
  std::string declarations;
  if (const std::size_t mark = code.find("@@"); mark != std::string::npos) {
    declarations = code.substr(0, mark);
    code = code.substr(mark + 2);
  }
  if (code.find("return") == std::string::npos) code = "return " + code + ";";
  return kParameters + declarations + "\nfloat4 PS(float4 t : TEXCOORD0) : COLOR { " + code +
         " }\ntechnique T < string ColorSpace = \"linear\"; > { pass P { PixelShader = compile ps_3_0 PS(); } }\n";
}

TEST(Language, CasesHaveTheirValues) {
  std::ifstream file(SourceFolder() + "/tests/data/fx/arithmetic.txt");
  ASSERT_TRUE(file);
  int cases = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    const std::size_t arrow = line.rfind("=>");
    ASSERT_NE(arrow, std::string::npos) << line;
    Rgba expected{};
    std::istringstream numbers(line.substr(arrow + 2));
    for (float& number : expected) numbers >> number;
    const PixelMap pixels = RunText(EffectOf(line.substr(0, arrow)), 2, 2);
    ASSERT_EQ(pixels.pixels.size(), 4u) << line;
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_NEAR(pixels.at(0, 0)[i], expected[i], kTolerance * std::max(1.0f, std::abs(expected[i]))) << line;
    }
    ++cases;
  }
  EXPECT_GT(cases, 90);
}

}  // namespace
}  // namespace burin::effect

// SPDX-License-Identifier: Apache-2.0
// Random expressions over scalars, vectors and matrices of floats, ints and bools: what the device makes of their GLSL
// is what the front end's own evaluator makes of them. Both know nothing of each other but the syntax tree. Operands
// are small multiples of a quarter, so that sums and products are exact in single precision.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "tests/gl/effect/effect_fixture.h"

namespace burin::effect {
namespace {

constexpr int kPrograms = 4;
constexpr int kExpressions = 24;  // of a program, one a row
constexpr int kDepth = 4;
constexpr float kTolerance = 1e-5f;

const char* const kDeclarations[] = {
    "float f1 = 1.5;",
    "float2 f2 = { -0.5, 2 };",
    "float3 f3 = { 0.25, -1, 3 };",
    "float4 f4 = { 2, 0, -2.5, 0.75 };",
    "int i1 = 3;",
    "int2 i2 = { -2, 5 };",
    "int3 i3 = { 0, 7, -1 };",
    "int4 i4 = { 1, 2, -3, 4 };",
    "bool b1 = true;",
    "bool2 b2 = { false, true };",
    "bool3 b3 = { true, false, true };",
    "bool4 b4 = { false, true, true, false };",
    "float2x2 m2 = { 1, -0.5, 2, 3 };",
    "float3x3 m3 = { 1, 2, 0, 0.5, -1, 2, 3, 0, 1 };",
    "float4x4 m4 = { 1, 0, 2, 0, 0, -1, 0.5, 0, 1, 1, 0, 2, 0, 0.5, 0, 1 };",
};

/// Text of a random expression of a type: 'f', 'i' or 'b' with a number of lanes.
class Generator {
 public:
  explicit Generator(unsigned seed) : random_(seed) {}

  std::string Make(char scalar, int lanes, int depth) {
    if (depth == 0 || Pick(8) == 0) return Leaf(scalar, lanes);
    switch (scalar) {
      case 'i':
        return Int(lanes, depth - 1);
      case 'b':
        return Bool(lanes, depth - 1);
      default:
        return Float(lanes, depth - 1);
    }
  }

 private:
  int Pick(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
  static std::string Name(char scalar, int lanes) { return scalar + std::to_string(lanes); }
  static std::string Type(char scalar, int lanes) {
    return (scalar == 'f' ? "float" : scalar == 'i' ? "int" : "bool") + (lanes > 1 ? std::to_string(lanes) : "");
  }

  std::string Swizzle(int from, int lanes) {
    std::string text = ".";
    for (int i = 0; i < lanes; ++i) text += "xyzw"[Pick(from)];
    return text;
  }

  std::string Leaf(char scalar, int lanes) {
    if (Pick(3) == 0) {
      const int from = Pick(4) + 1;
      return Name(scalar, from) + Swizzle(from, lanes);
    }
    if (lanes > 1 && Pick(4) == 0) {
      std::string list;
      for (int i = 0; i < lanes; ++i) list += (i > 0 ? ", " : "") + Leaf(scalar, 1);
      return Type(scalar, lanes) + "(" + list + ")";
    }
    if (lanes == 1 && scalar != 'b' && Pick(2) == 0) return std::to_string(Pick(5));
    return Name(scalar, lanes);
  }

  /// Kept small, so that nothing overflows or loses bits.
  std::string Small(const std::string& text) { return "clamp(" + text + ", -8, 8)"; }

  /// A scalar operand stands for all lanes now and then.
  std::string Operand(char scalar, int lanes, int depth) { return Make(scalar, Pick(5) == 0 ? 1 : lanes, depth); }

  std::string Float(int n, int d) {
    switch (Pick(13)) {
      case 0:
      case 1:
        return Small("(" + Make('f', n, d) + (Pick(2) == 0 ? " + " : " - ") + Operand('f', n, d) + ")");
      case 2:
        return Small("(" + Operand('f', n, d) + " * " + Make('f', n, d) + ")");
      case 3:
        return (Pick(2) == 0 ? "min(" : "max(") + Make('f', n, d) + ", " + Operand('f', n, d) + ")";
      case 4:
        return (Pick(2) == 0 ? "abs(" : Pick(2) == 0 ? "saturate(" : "-(") + Make('f', n, d) + ")";
      case 5:
        return "((" + Operand('b', n, d) + ") ? " + Make('f', n, d) + " : " + Make('f', n, d) + ")";
      case 6:
        return "(" + Type('f', n) + ")(" + Make(Pick(2) == 0 ? 'i' : 'b', n, d) + ")";
      case 7:
        return "(" + Make('f', n, d) + " + " + Make(Pick(2) == 0 ? 'i' : 'b', n, d) + ") / 2";
      case 8:
        return "step(" + Operand('f', n, d) + ", " + Make('f', n, d) + ")";
      case 9:
        return n == 1 ? Small("dot(" + Make('f', 3, d) + ", " + Make('f', 3, d) + ")")
                      : "sign(" + Make('f', n, d) + ")";
      case 10:
        return n == 1 ? "m3[" + std::to_string(Pick(3)) + "][" + std::to_string(Pick(3)) + "]"
                      : Small("mul(" + Make('f', n, d) + ", m" + std::to_string(n) + ")");
      case 11:
        return n == 1 ? "m4._m0" + std::to_string(Pick(4))
                      : Small("mul(m" + std::to_string(n) + " * 2 - transpose(m" + std::to_string(n) + "), " +
                              Make('f', n, d) + ")");
      default: {
        const int from = Pick(4) + 1;
        return "(" + Make('f', from, d) + ")" + Swizzle(from, n);
      }
    }
  }

  std::string Int(int n, int d) {
    switch (Pick(8)) {
      case 0:
        return Small("(" + Make('i', n, d) + (Pick(2) == 0 ? " + " : " - ") + Operand('i', n, d) + ")");
      case 1:
        return Small("(" + Make('i', n, d) + " * " + Operand('i', n, d) + ")");
      case 2:
        return "(" + Make('i', n, d) + (Pick(2) == 0 ? " / " : " % ") + std::to_string(Pick(4) + 1) + ")";
      case 3:
        return "((" + Make('i', n, d) + " & 7)" + (Pick(2) == 0 ? " | " : " ^ ") + std::to_string(Pick(8)) + ")";
      case 4:
        return "(" + Type('i', n) + ")(" + Make(Pick(2) == 0 ? 'f' : 'b', n, d) + ")";
      case 5:
        return (Pick(2) == 0 ? "min(" : "max(") + Make('i', n, d) + ", " + Operand('i', n, d) + ")";
      case 6:
        return "(" + Operand('b', n, d) + " ? " + Make('i', n, d) + " : " + Make('i', n, d) + ")";
      default:
        return (Pick(2) == 0 ? "abs(" : "-(") + Make('i', n, d) + ")";
    }
  }

  std::string Bool(int n, int d) {
    const char operand = Pick(2) == 0 ? 'f' : 'i';
    switch (Pick(6)) {
      case 0:
        return "(" + Make(operand, n, d) + (Pick(2) == 0 ? " < " : " >= ") + Operand('f', n, d) + ")";
      case 1:
        return "(" + Make(operand, n, d) + (Pick(2) == 0 ? " == " : " != ") + Operand(operand, n, d) + ")";
      case 2:
        return "(" + Make('b', n, d) + (Pick(2) == 0 ? " && " : " || ") + Operand(operand, n, d) + ")";
      case 3:
        return "(!" + Make('b', n, d) + ")";
      case 4:
        return n == 1 ? (Pick(2) == 0 ? "any(" : "all(") + Make('b', 3, d) + ")"
                      : "(" + Type('b', n) + ")(" + Make(operand, n, d) + ")";
      default:
        return "(" + Make('b', n, d) + " == " + Make('b', n, d) + ")";
    }
  }

  std::mt19937 random_;
};

/// The values as constants of the file, or as parameters that only the device knows.
std::string Declarations(bool constant) {
  std::string text;
  for (const char* declaration : kDeclarations)
    text += (constant ? "static const " : "") + std::string(declaration) + "\n";
  return text;
}

TEST(RandomExpressions, MeanOnTheDeviceWhatTheEvaluatorSays) {
  for (int program = 0; program < kPrograms; ++program) {
    const unsigned seed = 4711u + static_cast<unsigned>(program);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Generator generator(seed);
    std::vector<std::string> expressions;
    for (int i = 0; i < kExpressions; ++i) expressions.push_back(generator.Make("fib"[i % 3], i % 4 + 1, kDepth));
    std::string constants = Declarations(true);
    std::string shader = Declarations(false) + "float4 PS(float2 p : VPOS) : COLOR {\n  int row = p.y; float4 r = 0;\n";
    for (int i = 0; i < kExpressions; ++i) {
      const std::string lanes = std::string("xyzw").substr(0, static_cast<std::size_t>(i % 4 + 1));
      const std::string& text = expressions[static_cast<std::size_t>(i)];
      constants += "float" + std::to_string(i % 4 + 1) + " e" + std::to_string(i) + " = " + text + ";\n";
      shader += "  if (row == " + std::to_string(i) + ") r." + lanes + " = " + text + ";\n";
    }
    shader +=
        "  return r;\n}\ntechnique T < string ColorSpace = \"linear\"; > { pass P { PixelShader = compile ps_3_0 PS(); "
        "} }\n";
    const auto evaluated = CompileText(constants);
    ASSERT_NE(evaluated, nullptr);
    ASSERT_EQ(evaluated->parameters.size(), static_cast<std::size_t>(kExpressions)) << "an expression is no constant";
    const PixelMap pixels = RunText(shader, 1, kExpressions);
    for (std::size_t i = 0; i < static_cast<std::size_t>(kExpressions); ++i) {
      const std::vector<double>& numbers = evaluated->parameters[i].default_value.numbers;
      Rgba expected{};
      for (std::size_t lane = 0; lane < numbers.size(); ++lane) expected[lane] = static_cast<float>(numbers[lane]);
      EXPECT_TRUE(Near(pixels.at(0, static_cast<int>(i)), expected, kTolerance)) << expressions[i];
    }
  }
}

}  // namespace
}  // namespace burin::effect

// SPDX-License-Identifier: Apache-2.0
// Whatever a text looks like, the parser ends, reports, and stays within its limits. Texts are effects with random
// damage; the seed of each is printed when something fails.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "fx_parser/syntax/lexer.h"
#include "fx_parser/syntax/parse.h"

namespace burin::fx {
namespace {

constexpr int kRounds = 2500;  // of each kind of damage, over all texts

const std::vector<std::string>& Texts() {
  static const std::vector<std::string> texts{
      R"(#include "inner.fxh"
texture GBAnormal_A16B16G16R16F; texture PASS0_A8R8G8B8_S0_5;
sampler2D n = sampler_state { Texture = <GBAnormal_A16B16G16R16F>; MinFilter = LINEAR; AddressU = CLAMP; };
float4 TexelSize; static const float kernel[3] = { 0.25, 0.5, .25 };
float4 ps(float2 uv : TEXCOORD0, uniform bool wide = true) : COLOR0 {
  float4 sum = 0;
  [unroll] for (int i = -1; i <= 1; ++i) sum += kernel[i + 1] * tex2D(n, uv + i * TexelSize.xy);
  return wide ? sum : (float4)sum.x;
}
technique T < string ColorSpace = "linear"; > {
  pass P0 { PixelShader = compile ps_3_0 ps(true); ZEnable = false; CullMode = None; }
  pass P1 { AlphaBlendEnable = true; SrcBlend = One; ColorWriteEnable = RED | GREEN; PixelShader = compile ps_3_0 ps(1 > 0); }
})",
      R"(#define TWEAK(name, lo, hi, value) float name < string UIWidget = "slider"; float UIMin = lo; float UIMax = hi; > = value;
#define CAT(a, b) a ## b
#if DIRECT3D_VERSION >= 0xa00 && defined(FOO) || !BURIN
TWEAK(x, 0, 1, 2)
#elif 1 + 2 * 3 == 7
TWEAK(CAT(y, 1), 0.0, 1.0h, 0x3F)
#else
#error no
#endif
struct V { float4 p : POSITION; row_major float3x3 m[2] : TEXCOORD0; };
V main(float3 p : POSITION, uniform float4x4 w) {
  V o = (V)0; o.p = mul(float4(p, 1), w); o.m[0]._m00_m11 = p.xy;
  if (p.x > 0) { o.p.x = -p.x; } else if (p.y) discard; else return o;
  do { p.x--; } while (p.x > 0 && !(p.y < 1));
  switch (2) { case 0: case 1: p.y = 1.xxx.y; break; default: p = p; }
  struct L { float q; } l; l.q = 1; typedef float2 uv; uv t = (uv)1;
  return o;
}
VertexShader vs = compile vs_2_0 main(y1);
PixelShader a = asm { ps_1_1 tex t0 mul r0, t0, c0 };
technique10 M { pass { SetVertexShader(CompileShader(vs_4_0, main())); Texture[0] = <t>; } };)",
      R"(matrix m : WorldViewProjection; vector<half, 3> v = { 1, 2, { 3 } };
string s = "a" ("b") "\x41\n" /* comment */ ; // end
#pragma pack_matrix(row_major)
cbuffer B : register(b0) { float4 c : packoffset(c0); };
void f(inout float x[3], out sampler2D t) { x[0] = 1, x[1] <<= 2; for (;;) break; while (false) continue; }
texture2D q : COLOR { Width = 4; }; sampler z[2] = { sampler_state { Texture = <q>; }, sampler_state { } };
#line 40 "other.fx"
static float g = __LINE__ + 010;)"};
  return texts;
}

// The highest initialiser among the globals, as recorded.
int HighestInitializer(const ast::Module& module) {
  int highest = 0;
  for (const auto& declaration : module.declarations) {
    const auto* variable = std::get_if<std::unique_ptr<ast::Variable>>(&declaration);
    if (variable && (*variable)->initializer) highest = std::max(highest, (*variable)->initializer->height);
  }
  return highest;
}

// Runs the whole front half and checks what must hold for any text.
void Check(const std::string& text) {
  InMemoryFileSystem files;
  files.files = {{"main.fx", text}, {"inner.fxh", "#ifndef I\n#define I\nfloat inner = 1;\n#endif\n"}};
  SourceSet sources;
  Diagnostics diagnostics;
  const ast::Module module = Parse("main.fx", files, {}, sources, diagnostics);
  EXPECT_LE(diagnostics.error_count(), Diagnostics::kMaxErrors);
  EXPECT_LE(HighestInitializer(module), kMaxExpressionHeight);
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    const std::string formatted = FormatDiagnostic(diagnostic, sources);
    EXPECT_TRUE(formatted.ends_with('\n'));
    EXPECT_TRUE(formatted.contains("error: ") || formatted.contains("warning: "));
    for (const char c : formatted) EXPECT_TRUE(c == '\n' || c == '\t' || static_cast<unsigned char>(c) >= 0x20);
    const Location& at = diagnostic.range.begin;
    EXPECT_TRUE(at.file == kNoFile || at.file < sources.files.size());
    EXPECT_LE(at.macro, sources.expansions.size());
  }
}

class Damage {
 public:
  explicit Damage(unsigned seed) : random_(seed) {}

  std::size_t Below(std::size_t limit) { return std::uniform_int_distribution<std::size_t>(0, limit - 1)(random_); }

  const std::string& Text() { return Texts()[Below(Texts().size())]; }

  std::string Bytes() {
    std::string text = Text();
    for (std::size_t i = 1 + Below(8); i > 0; --i) {
      const std::size_t at = Below(text.size());
      switch (Below(3)) {
        case 0:
          text[at] = static_cast<char>(Below(256));
          break;
        case 1:
          text.erase(at, 1 + Below(4));
          break;
        default:
          text.insert(at, 1, static_cast<char>(Below(256)));
          break;
      }
      if (text.empty()) text = "x";
    }
    return text;
  }

  std::string Tokens() {
    const std::string text = Text();
    Diagnostics ignored;
    Lexer lexer(text, 0, ignored);
    std::vector<std::string> tokens;
    for (Token token = lexer.Next(); token.kind != TokenKind::kEnd; token = lexer.Next()) {
      tokens.push_back((token.starts_line ? "\n" : " ") + std::string(token.text));
    }
    for (std::size_t i = 1 + Below(6); i > 0 && tokens.size() > 1; --i) {
      const std::size_t at = Below(tokens.size());
      const std::size_t other = Below(tokens.size());
      switch (Below(4)) {
        case 0:
          tokens.erase(tokens.begin() + static_cast<std::ptrdiff_t>(at));
          break;
        case 1:
          tokens.insert(tokens.begin() + static_cast<std::ptrdiff_t>(at), std::string(tokens[other]));
          break;
        case 2:
          std::swap(tokens[at], tokens[other]);
          break;
        default:
          tokens[at] = tokens[other];
          break;
      }
    }
    std::string damaged;
    for (const std::string& token : tokens) damaged += token;
    return damaged;
  }

  std::string Truncated() {
    const std::string& text = Text();
    return text.substr(0, Below(text.size()));
  }

  // No effect at all, only its words.
  std::string Soup() {
    constexpr const char* kWords[] = {"float4",
                                      "x",
                                      "(",
                                      ")",
                                      "{",
                                      "}",
                                      "[",
                                      "]",
                                      "<",
                                      ">",
                                      ";",
                                      ",",
                                      ":",
                                      "=",
                                      "technique",
                                      "pass",
                                      "struct",
                                      "if",
                                      "else",
                                      "for",
                                      "compile",
                                      "sampler",
                                      "sampler_state",
                                      "asm",
                                      "return",
                                      "1",
                                      "0.5",
                                      "\"s\"",
                                      ".",
                                      "?",
                                      "+",
                                      "-",
                                      "\n#define M(a) a a\n",
                                      "M",
                                      "\n#if 1\n",
                                      "\n#endif\n",
                                      "\n#else\n",
                                      "::",
                                      "namespace",
                                      "typedef",
                                      "switch",
                                      "case",
                                      "\n#include \"inner.fxh\"\n",
                                      "##"};
    std::string text;
    for (std::size_t i = Below(200); i > 0; --i) text += std::string(kWords[Below(std::size(kWords))]) + " ";
    return text;
  }

 private:
  std::mt19937 random_;
};

template <class Make>
void CheckMany(unsigned first_seed, Make make) {
  for (unsigned seed = first_seed; seed < first_seed + kRounds; ++seed) {
    Damage damage(seed);
    const std::string text = make(damage);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", text:\n" + text);
    Check(text);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(ParserMutation, TheTextsAreFineUndamaged) {
  for (const std::string& text : Texts()) {
    InMemoryFileSystem files;
    files.files = {{"main.fx", text}, {"inner.fxh", ""}};
    SourceSet sources;
    Diagnostics diagnostics;
    EXPECT_FALSE(Parse("main.fx", files, {}, sources, diagnostics).declarations.empty());
    for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << FormatDiagnostic(diagnostic, sources);
  }
}

TEST(ParserMutation, SurvivesChangedBytes) {
  CheckMany(10000, [](Damage& damage) { return damage.Bytes(); });
}

TEST(ParserMutation, SurvivesChangedTokens) {
  CheckMany(20000, [](Damage& damage) { return damage.Tokens(); });
}

TEST(ParserMutation, SurvivesTruncation) {
  CheckMany(30000, [](Damage& damage) { return damage.Truncated(); });
}

TEST(ParserMutation, SurvivesWordSoup) {
  CheckMany(40000, [](Damage& damage) { return damage.Soup(); });
}

}  // namespace
}  // namespace burin::fx

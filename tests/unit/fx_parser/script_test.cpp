// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/effect/script.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/fx_parser/compile_effect.h"

namespace burin::fx {
namespace {

using test::Messages;
using ::testing::ElementsAre;
using Action = ScriptStep::Action;

TEST(Script, IsCommandsWithoutCaseOrSpace) {
  const auto commands = ParseScript(" rendercolortarget1 = Half ;;\tClear=Color;LoopEnd=;Pass = p 0");
  ASSERT_EQ(commands.size(), 4u);
  EXPECT_EQ(commands[0].verb, ScriptVerb::kColorTarget);
  EXPECT_EQ(commands[0].index, 1);
  EXPECT_EQ(commands[0].value, "Half");
  EXPECT_EQ(commands[1].verb, ScriptVerb::kClear);
  EXPECT_EQ(commands[2].verb, ScriptVerb::kLoopEnd);
  EXPECT_EQ(commands[2].value, "");
  EXPECT_EQ(commands[3].verb, ScriptVerb::kPass);
  EXPECT_EQ(commands[3].value, "p 0");
  EXPECT_EQ(ParseScript("RenderColorTarget9=a;")[0].verb, ScriptVerb::kUnknown);
  EXPECT_TRUE(ParseScript(" ; ;").empty());
}

TEST(Script, TechniqueMayNameSeveralChoices) {
  EXPECT_THAT(ScriptChoices("Technique?Main: Main10"), ElementsAre("Main", "Main10"));
  EXPECT_THAT(ScriptChoices("Main"), ElementsAre("Main"));
  EXPECT_TRUE(ScriptChoices("").empty());
}

std::string Global(const std::string& annotations) {
  return "float Script : STANDARDSGLOBAL < " + annotations + " > = 0.8;\n";
}

const std::string kTargets =
    "texture Half : RenderColorTarget < float2 ViewportRatio = {0.5, 0.25}; string Format = \"a16b16g16r16f\"; >;\n"
    "texture Fixed : RENDERCOLORTARGET < float2 Dimensions = {64, 32}; >; texture Depth : RENDERDEPTHSTENCILTARGET;\n"
    "float4 PS() : COLOR { return 1; } float4 Black; float Turns = 2; float Turn;\n";

std::string TwoPasses(const std::string& script, const std::string& first = "", const std::string& second = "") {
  const auto pass = [](const std::string& name, const std::string& text) {
    return "pass " + name + (text.empty() ? "" : " < string Script = \"" + text + "\"; >") +
           " { PixelShader = compile ps_2_0 PS(); } ";
  };
  return "technique T < string Script = \"" + script + "\"; > { " + pass("A", first) + pass("B", second) + "}\n";
}

std::vector<Action> Actions(const std::string& text) {
  const CompileResult result = test::Compile(text);
  EXPECT_EQ(Messages(result), "");
  std::vector<Action> actions;
  if (!result.effect) return actions;
  for (const ScriptStep& step : result.effect->techniques[0].script) actions.push_back(step.action);
  return actions;
}

TEST(Script, PutsThePassesScriptsWhereItRunsThem) {
  EXPECT_THAT(Actions(kTargets + TwoPasses("RenderColorTarget0=Half;ClearSetColor=Black;Clear=Color;Clear=Depth;"
                                           "ScriptExternal=color;Pass=B;Pass=A;",
                                           "Draw=Geometry;",
                                           "RenderColorTarget0=;RenderDepthStencilTarget=Depth;Draw=Buffer;")),
              ElementsAre(Action::kColorTarget, Action::kSetClearColor, Action::kClearColor, Action::kClearDepth,
                          Action::kDrawSource, Action::kColorTarget, Action::kDepthStencilTarget, Action::kDrawBuffer,
                          Action::kDrawGeometry));
  EXPECT_THAT(Actions(kTargets + TwoPasses("LoopByCount=Turns;LoopGetIndex=Turn;Pass=A;LoopEnd=;", "Draw=Buffer;")),
              ElementsAre(Action::kLoop, Action::kLoopIndex, Action::kDrawBuffer, Action::kLoopEnd));
}

TEST(Script, PassesWithoutAScriptDrawWhatTheClassOfTheFileSays) {
  EXPECT_THAT(Actions(Global("string ScriptClass = \"scene\";") + kTargets + TwoPasses("")),
              ElementsAre(Action::kDrawBuffer, Action::kDrawBuffer));
  EXPECT_THAT(Actions(Global("string ScriptClass = \"object\";") + kTargets + TwoPasses("Pass=B;")),
              ElementsAre(Action::kDrawGeometry));
  EXPECT_TRUE(Actions(kTargets + "technique T { pass { PixelShader = compile ps_2_0 PS(); } }").empty());
}

TEST(Script, TargetsHaveTheirSizesAndFormats) {
  const CompileResult result = test::Compile(kTargets + TwoPasses(""));
  ASSERT_TRUE(result.effect);
  const auto& half = std::get<ScriptTargetRole>(result.effect->textures[0].role);
  EXPECT_EQ(half.width_ratio, 0.5);
  EXPECT_EQ(half.height_ratio, 0.25);
  EXPECT_EQ(half.width, 0);
  EXPECT_EQ(result.effect->textures[0].format, Format::kA16B16G16R16F);
  const auto& fixed = std::get<ScriptTargetRole>(result.effect->textures[1].role);
  EXPECT_EQ(fixed.width, 64);
  EXPECT_EQ(fixed.height, 32);
  EXPECT_TRUE(std::get<ScriptTargetRole>(result.effect->textures[2].role).is_depth_stencil);
  EXPECT_FALSE(result.effect->uses_extension);
}

TEST(Script, TheFilesOwnChooseTheTechnique) {
  const CompileResult result = test::Compile(
      Global("string Script = \"Technique=Technique?Second:First;\";") +
      "float4 PS() : COLOR { return 1; } technique First { pass { PixelShader = compile ps_2_0 PS(); } }\n"
      "technique Second { pass { PixelShader = compile ps_2_0 PS(); } }");
  EXPECT_EQ(Messages(result), "");
  ASSERT_TRUE(result.effect);
  EXPECT_THAT(result.effect->preferred_techniques, ElementsAre(1u, 0u));
}

TEST(Script, WarnsOfWhatItNamesInVain) {
  EXPECT_EQ(Messages(kTargets + TwoPasses("Pass=C;RenderColorTarget0=Depth;ClearSetColor=White;Pas=A;RenderPort=Window;"
                                          "Draw=Buffer;Pass=A;",
                                          "Pass=B;Draw=Buffer;")),
            "4:31: warning: script: technique 'T' has no pass 'C' [B1020]\n"
            "4:31: warning: script: RenderColorTarget0 names 'Depth', which is no texture of the semantic "
            "RENDERCOLORTARGET [B1020]\n"
            "4:31: warning: script: ClearSetColor names 'White', which is no parameter [B1020]\n"
            "4:31: warning: script: unknown command 'Pas' is ignored; did you mean 'Pass'? [B1020]\n"
            "4:31: warning: script: RenderPort names 'Window', which is no light: the camera sees the scene [B1020]\n"
            "4:31: warning: script: 'Draw' stands in the script of a pass [B1020]\n"
            "4:159: warning: script: a pass cannot run passes: 'Pass=B' is ignored [B1020]\n");
  EXPECT_EQ(Messages("texture t : RENDERCOLORTARGET < string Format = \"Q8W8V8U8\"; >;"),
            "1:9: warning: texture 't': no render target has the format 'Q8W8V8U8' here; A8R8G8B8 stands in for it "
            "[B1019]\n");
  EXPECT_EQ(Messages(Global("string Script = \"Technique=Gone;\";") + kTargets + TwoPasses("")),
            "1:50: warning: script: there is no technique 'Gone' [B1020]\n");
}

TEST(Script, PassesThatRunEachOtherOverAndOverAreAnError) {
  std::string script;
  for (int i = 0; i < 4200; ++i) script += "Pass=A;";
  EXPECT_EQ(Messages(kTargets + TwoPasses(script, "Draw=Buffer;")),
            "4:31: error: script: technique 'T' runs more than 4096 steps [B1021]\n");
}

TEST(Script, PassesThatProjectMeanTheScene) {
  const std::string text =
      "float4x4 wvp : WorldViewProjection; float4x4 back : ViewProjectionInverse;\n"
      "float4 A(float4 p : POSITION) : POSITION { return mul(p, wvp); }\n"
      "float4 B(float4 p : POSITION) : POSITION { return p + back[0].x * 0; } float4 PS() : COLOR { return 1; }\n"
      "technique T { pass { VertexShader = compile vs_2_0 A(); PixelShader = compile ps_2_0 PS(); }\n"
      "pass { VertexShader = compile vs_2_0 B(); PixelShader = compile ps_2_0 PS(); } }";
  const CompileResult result = test::Compile(text);
  ASSERT_TRUE(result.effect);
  EXPECT_TRUE(result.effect->techniques[0].passes[0].projects);
  EXPECT_FALSE(result.effect->techniques[0].passes[1].projects);
  const CompileResult extended = test::Compile("texture GBAcolor_A8R8G8B8;" + text);
  ASSERT_TRUE(extended.effect);
  EXPECT_FALSE(extended.effect->techniques[0].passes[0].projects);
}

}  // namespace
}  // namespace burin::fx

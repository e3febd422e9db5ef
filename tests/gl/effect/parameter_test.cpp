// SPDX-License-Identifier: Apache-2.0
// What the host gives to parameters, and custom attributes that draw the scene.
#include <string>

#include <glm/gtc/matrix_transform.hpp>

#include "core/gl/fullscreen_quad.h"
#include "tests/gl/effect/effect_fixture.h"

namespace burin::effect {
namespace {

const std::string kLinear = "technique T < string ColorSpace = \"linear\"; > ";

std::string Show(const std::string& globals, const std::string& expression) {
  return globals + "\nfloat4 P() : COLOR { return " + expression + "; }\n" + kLinear +
         "{ pass A { PixelShader = compile ps_3_0 P(); } }";
}

FrameContext Scene() {
  FrameContext context;
  context.width = context.height = 1;
  context.view_from_world = glm::lookAt(glm::vec3(1, 2, 3), glm::vec3(0, 0.5f, 0), glm::vec3(0, 1, 0));
  context.clip_from_view = glm::perspectiveRH_ZO(0.8f, 1.5f, 0.1f, 50.0f);
  context.eye_world = {1, 2, 3};
  context.light_direction_world = {0, -1, 0};
  context.light_color = {1, 0.5f, 0.25f, 1};
  return context;
}

Rgba ShowScene(const std::string& globals, const std::string& expression, const std::string& path = "test.fx") {
  Bench bench(CompileText(Show(globals, expression), path), 1, 1);
  bench.context = Scene();
  return bench.RunPixels().at(0, 0);
}

Rgba FromGlm(const glm::vec4& v) { return {v.x, v.y, v.z, v.w}; }

TEST(HostValue, MatricesTransformRowVectors) {
  const FrameContext scene = Scene();
  const glm::vec4 point(0.3f, -0.2f, 0.5f, 1);
  const std::string expression = "mul(float4(0.3, -0.2, 0.5, 1), m)";
  EXPECT_TRUE(Near(ShowScene("float4x4 m : WorldViewProjection;", expression),
                   FromGlm(scene.clip_from_view * scene.view_from_world * point), 1e-5f));
  EXPECT_TRUE(Near(ShowScene("float4x4 m : WORLDVIEW;", expression), FromGlm(scene.view_from_world * point), 1e-5f));
  EXPECT_TRUE(Near(ShowScene("float4x4 m : viewinverse;", expression),
                   FromGlm(glm::inverse(scene.view_from_world) * point), 1e-5f));
  EXPECT_TRUE(Near(ShowScene("float4x4 m : ViewInverseTranspose;", expression),
                   FromGlm(glm::transpose(glm::inverse(scene.view_from_world)) * point), 1e-5f));
  EXPECT_TRUE(Near(ShowScene("float4x4 m : ProjectionTranspose;", expression),
                   FromGlm(glm::transpose(scene.clip_from_view) * point), 1e-5f));
  EXPECT_TRUE(Near(ShowScene("float4x3 m : WorldView;", "float4(mul(float4(0.3, -0.2, 0.5, 1), m), 1)"),
                   FromGlm(scene.view_from_world * point), 1e-5f));
}

TEST(HostValue, CgfxMatricesTransformColumnVectors) {
  const FrameContext scene = Scene();
  EXPECT_TRUE(Near(ShowScene("float4x4 m : ViewProjection;", "mul(m, float4(0.3, -0.2, 0.5, 1))", "test.cgfx"),
                   FromGlm(scene.clip_from_view * scene.view_from_world * glm::vec4(0.3f, -0.2f, 0.5f, 1)), 1e-5f));
}

TEST(HostValue, CameraAndLight) {
  EXPECT_RGBA(ShowScene("float3 e : CAMERAPOSITION;", "float4(e, 7)"), 1, 2, 3, 7);
  EXPECT_RGBA(ShowScene("float4 e : Position < string Object = \"Camera\"; >;", "e"), 1, 2, 3, 1);
  EXPECT_RGBA(ShowScene("float3 d : Direction < string Object = \"DirectionalLight0\"; > = {1, 0, 0};", "float4(d, 0)"), 0,
              -1, 0, 0);
  EXPECT_RGBA(ShowScene("float3 d : DIRECTION < string Object = \"SpotLight1\"; > = {1, 0, 0};", "float4(d, 0)"), 1, 0, 0, 0);
  EXPECT_RGBA(ShowScene("float4 c : Diffuse < string Object = \"pointlight\"; >;", "c"), 1, 0.5f, 0.25f, 1);
  EXPECT_RGBA(ShowScene("float4 c : Diffuse = {0.1, 0.2, 0.3, 0.4};", "c"), 0.1f, 0.2f, 0.3f, 0.4f);
}

TEST(HostValue, TimeAndFrame) {
  Bench bench(CompileText(Show("float Time; int Frame; float2 FrameSize; float e : ELAPSEDTIME;",
                               "float4(Time, Frame, FrameSize.x, e)")),
              7, 3);
  bench.context.time_s = 1.5;
  bench.context.frame = 37;
  bench.context.elapsed_s = 0.25;
  EXPECT_RGBA(bench.RunPixels().at(6, 2), 1.5f, 37, 7, 0.25f);
  bench.context.frame = -4;
  EXPECT_RGBA(bench.RunPixels().at(0, 0), 1.5f, -4, 7, 0.25f);
}

TEST(HostValue, AnOverrideWinsOverTheHost) {
  Bench bench(CompileText(Show("float Time;", "Time")), 1, 1, {{"Time", "9"}});
  bench.context.time_s = 1.5;
  EXPECT_RGBA(bench.RunPixels().at(0, 0), 9, 9, 9, 9);
}

// Scenes of planes that fill the view, each the full-screen quadrilateral.
class CustomAttribute : public ::testing::Test {
 protected:
  void SetUp() override {
    auto quad = gl::FullscreenQuad::Create();
    ASSERT_TRUE(quad.has_value());
    quad_ = std::make_unique<gl::FullscreenQuad>(std::move(*quad));
  }
  SceneDraw Plane(float depth, float width) const {
    const glm::mat4 world = glm::translate(glm::mat4(1.0f), glm::vec3(0, 0, depth)) *
                      glm::scale(glm::mat4(1.0f), glm::vec3(width, 1, 1));
    return {world, [this] { quad_->Draw(); }};
  }
  std::unique_ptr<gl::FullscreenQuad> quad_;
};

const std::string kCustom = R"(
float4x4 M : WorldViewProjection;
texture GBAtint_A32B32G32R32F < float4 ClearColor = {0.5, 0, 0, 0}; >;
sampler tint = sampler_state { Texture = <GBAtint_A32B32G32R32F>; };
struct V { float4 p : POSITION; float z : TEXCOORD0; };
V Vs(float4 p : POSITION) { V v; v.p = mul(p, M); v.z = v.p.z; return v; }
float4 Ps(V v, float face : VFACE) : COLOR { return float4(0, v.z, face > 0, 1); }
technique GBAtint { pass P { CullMode = @CULL@; VertexShader = compile vs_3_0 Vs(); PixelShader = compile ps_3_0 Ps(); } }
float4 Show(float2 uv : TEXCOORD0) : COLOR { return tex2D(tint, uv); }
technique T < string ColorSpace = "linear"; > { pass P { PixelShader = compile ps_3_0 Show(); } }
)";

std::string Custom(const std::string& cull) {
  std::string text = kCustom;
  return text.replace(text.find("@CULL@"), 6, cull);
}

TEST_F(CustomAttribute, DrawsTheSceneWithDepthAndObjectMatrices) {
  Bench bench(CompileText(Custom("None")), 2, 1);
  ASSERT_TRUE(bench.runner);
  EXPECT_TRUE(bench.runner->needs_scene());
  EXPECT_TRUE(bench.runner->attributes().empty());
  const SceneDraws draws = [&]() -> Result<std::vector<SceneDraw>> { return std::vector{Plane(0.25f, 1), Plane(0.75f, 1)}; };
  const PixelMap frame = bench.RunPixels(draws);
  EXPECT_EQ(frame.at(0, 0)[1], 0.25f);
  EXPECT_EQ(frame.at(1, 0)[1], 0.25f);
  // The other way round, and again: depth starts afresh.
  const SceneDraws reversed = [&]() -> Result<std::vector<SceneDraw>> {
    return std::vector{Plane(0.75f, 1), Plane(0.5f, 1)};
  };
  EXPECT_EQ(bench.RunPixels(reversed).at(0, 0)[1], 0.5f);
}

TEST_F(CustomAttribute, TheBackgroundIsTheClearColor) {
  Bench bench(CompileText(Custom("None")), 2, 1);
  const SceneDraws none = []() -> Result<std::vector<SceneDraw>> { return std::vector<SceneDraw>{}; };
  EXPECT_RGBA(bench.RunPixels(none).at(1, 0), 0.5f, 0, 0, 0);
}

TEST_F(CustomAttribute, FrontFacesOfModelsAreFrontFaces) {
  // The quadrilateral's own winding is clockwise: a back face of a model, culled by Direct3D's default; mirrored by its
  // matrix it is counter-clockwise on the screen, yet still the back face that the model made it.
  Bench bench(CompileText(Custom("CCW")), 2, 1);
  const SceneDraws back = [&]() -> Result<std::vector<SceneDraw>> { return std::vector{Plane(0.25f, 1)}; };
  EXPECT_RGBA(bench.RunPixels(back).at(0, 0), 0.5f, 0, 0, 0);
  const SceneDraws mirrored = [&]() -> Result<std::vector<SceneDraw>> { return std::vector{Plane(0.25f, -1)}; };
  EXPECT_RGBA(bench.RunPixels(mirrored).at(0, 0), 0.5f, 0, 0, 0);
  Bench other(CompileText(Custom("CW")), 2, 1);
  EXPECT_RGBA(other.RunPixels(back).at(0, 0), 0, 0.25f, 0, 1);
  EXPECT_RGBA(other.RunPixels(mirrored).at(0, 0), 0, 0.25f, 0, 1);
  // Seen from behind (a camera that mirrors), it is a front face.
  other.context.view_from_world = glm::scale(glm::mat4(1.0f), glm::vec3(-1, 1, 1));
  bench.context.view_from_world = other.context.view_from_world;
  EXPECT_RGBA(bench.RunPixels(back).at(0, 0), 0, 0.25f, 1, 1);
}

TEST_F(CustomAttribute, ErrorsOfTheSceneComeThrough) {
  Bench bench(CompileText(Custom("None")), 2, 1);
  ASSERT_TRUE(bench.runner);
  const auto frame = bench.runner->Run(bench.context, []() -> Result<std::vector<SceneDraw>> {
    return Fail(ErrorKind::kInput, "broken scene");
  });
  ASSERT_FALSE(frame.has_value());
  EXPECT_EQ(frame.error().message, "broken scene");
}

}  // namespace
}  // namespace burin::effect

// SPDX-License-Identifier: Apache-2.0
// Textures without files, and values of objects, lights and controllers.
#include <epoxy/gl.h>

#include <glm/gtc/matrix_transform.hpp>
#include <memory>
#include <string>

#include "core/gl/fullscreen_quad.h"
#include "tests/gl/effect/effect_fixture.h"

namespace burin::effect {
namespace {

class HostTexture : public ::testing::Test {
 protected:
  void SetUp() override {
    auto quad = gl::FullscreenQuad::Create();
    ASSERT_TRUE(quad.has_value());
    quad_ = std::make_unique<gl::FullscreenQuad>(std::move(*quad));
    const image::Image picture = MakeImage(1, 1, image::SampleType::kU8, [](int, int) {
      return Rgba{0.2f, 0.4f, 0.6f, 1};
    });
    auto texture = gl::Texture::Create(gl::FormatFor(picture), 1, 1, 1, "picture");
    ASSERT_TRUE(texture.has_value());
    texture_ = std::move(*texture);
    texture_.Upload(picture);
  }
  RunnerOptions Options(int size = 1) const {
    RunnerOptions options;
    options.width = options.height = size;
    options.display_frame_format = options.linear_frame_format = gl::PlainFormat(gl::Numeric::kUnorm, 8, 4);
    return options;
  }
  Rgba Run(const std::string& text, RunnerOptions options, const SceneDraws& scene = {},
           const FrameContext& context = {}) {
    auto runner = EffectRunner::Create(CompileText(text), options);
    if (!runner) {
      ADD_FAILURE() << runner.error().message;
      return {};
    }
    for (const AttributeTarget& target : (*runner)->attributes()) {
      if (target.attribute == "color") {
        const_cast<gl::Texture*>(target.texture)->Upload(MakeImage(1, 1, image::SampleType::kU8, [](int, int) {
          return Rgba{0.8f, 0, 0.2f, 1};
        }));
      }
    }
    warnings_ = (*runner)->warnings();
    FrameContext own = context;
    own.width = own.height = options.width;
    const auto frame = (*runner)->Run(own, scene);
    return frame ? ReadPixels(**frame).at(0, 0) : Rgba{-9, -9, -9, -9};
  }
  SceneDraws Scene(const MaterialContext& material, std::uint32_t base_color, std::uint32_t normal = 0) const {
    return [=, this]() -> Result<std::vector<SceneDraw>> {
      SceneDraw draw;
      draw.draw = [this] { quad_->Draw(); };
      draw.material = material;
      draw.texture = [=](TextureMeaning meaning, bool) {
        return meaning == TextureMeaning::kBaseColor ? base_color : meaning == TextureMeaning::kNormal ? normal : 0u;
      };
      return std::vector{draw};
    };
  }
  std::unique_ptr<gl::FullscreenQuad> quad_;
  gl::Texture texture_;
  std::vector<std::string> warnings_;
};

const std::string kObject =
    "float4x4 WVP : WORLDVIEWPROJECTION;\n"
    "void VS(float4 p : POSITION, float2 t : TEXCOORD0, out float4 q : POSITION, out float2 u : TEXCOORD0) { q = "
    "mul(p, "
    "WVP); u = t; }\n";
const std::string kTechnique =
    "technique T { pass P { CullMode = None; VertexShader = compile vs_2_0 VS(); PixelShader = compile ps_2_0 PS(); } "
    "}";

TEST_F(HostTexture, ObjectsGiveTheirOwn) {
  const std::string text =
      kObject +
      "texture t : DIFFUSE < string ResourceName = \"default_color.dds\"; >; sampler s = "
      "sampler_state { Texture = <t>; };\nfloat4 PS(float2 u : TEXCOORD0) : COLOR { return tex2D(s, "
      "u); }\n" +
      kTechnique;
  RunnerOptions options = Options();
  options.has_scene = options.has_source = true;
  options.load_texture = [](const std::string&) -> Result<std::optional<image::Image>> { return std::nullopt; };
  EXPECT_RGBA8(Run(text, options, Scene({}, texture_.id())), 0.2f, 0.4f, 0.6f, 1);
  EXPECT_TRUE(warnings_.empty());
  MaterialContext painted;
  painted.diffuse = {0.4f, 0.2f, 0.8f, 1};
  EXPECT_RGBA8(Run(text, options, Scene(painted, 0)), 0.4f, 0.2f, 0.8f, 1) << "a texel of the object's colour";
  // Not where the shader gets the colour as well.
  std::string both = text;
  both.replace(both.find("return tex2D"), 6, "return Paint *");
  EXPECT_RGBA8(Run("float4 Paint : DIFFUSE < string Object = \"Geometry\"; >;\n" + both, options, Scene(painted, 0)),
               0.4f, 0.2f, 0.8f, 1);
}

TEST_F(HostTexture, AFileGoesBeforeTheObjectsAndIsMissedWithAWarning) {
  const std::string text = kObject +
                           "texture t : DIFFUSE < string ResourceName = \"stone.png\"; >; sampler s = sampler_state { "
                           "Texture = <t>; };\nfloat4 PS(float2 u : TEXCOORD0) : COLOR { return tex2D(s, u); }\n" +
                           kTechnique;
  RunnerOptions options = Options();
  options.has_scene = options.has_source = true;
  options.texture_folders = "., textures";
  options.load_texture = [](const std::string& path) -> Result<std::optional<image::Image>> {
    if (path == "gone.png") return std::nullopt;
    return MakeImage(1, 1, image::SampleType::kU8, [](int, int) { return Rgba{1, 0, 0, 1}; });
  };
  EXPECT_RGBA8(Run(text, options, Scene({}, texture_.id())), 1, 0, 0, 1);
  options.load_texture = [](const std::string&) -> Result<std::optional<image::Image>> { return std::nullopt; };
  EXPECT_RGBA8(Run(text, options, Scene({}, texture_.id())), 0.2f, 0.4f, 0.6f, 1);
  EXPECT_EQ(warnings_, (std::vector<std::string>{
                           "test.fx: texture 't' names a file that is not there ('stone.png' not found; searched: ., "
                           "textures): what is drawn gives its own"}));
  options.parameters = {{"t", "gone.png"}};
  const auto asked_for = EffectRunner::Create(CompileText(text), options);
  ASSERT_FALSE(asked_for.has_value());
  EXPECT_EQ(asked_for.error().message, "texture 't' of test.fx: 'gone.png' not found; searched: ., textures");
}

TEST_F(HostTexture, CubesAreReadFromTheirFaces) {
  // +x -x +y -y +z -z as tenths of red.
  const auto text = [](const std::string& direction) {
    return "textureCUBE t : ENVIRONMENT < string ResourceName = \"sky.dds\"; >; samplerCUBE s = sampler_state { "
           "Texture "
           "= <t>; };\nfloat4 PS(float2 u : TEXCOORD0) : COLOR { return texCUBE(s, float3(" +
           direction + ")); }\ntechnique T { pass P { PixelShader = compile ps_2_0 PS(); } }";
  };
  struct Case {
    int width, height;
    int faces[6][2];
  };
  const Case cases[] = {{2, 12, {{0, 0}, {0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}}},
                        {12, 2, {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}}},
                        {8, 6, {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}}},
                        {6, 8, {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {1, 3}}}};
  const char* const directions[] = {"1, 0, 0", "-1, 0, 0", "0, 1, 0", "0, -1, 0", "0, 0, 1", "0, 0, -1"};
  for (const Case& c : cases) {
    RunnerOptions options = Options();
    options.load_texture = [&](const std::string&) -> Result<std::optional<image::Image>> {
      return MakeImage(c.width, c.height, image::SampleType::kU8, [&](int x, int y) {
        for (int face = 0; face < 6; ++face) {
          if (x / 2 == c.faces[face][0] && y / 2 == c.faces[face][1]) return Rgba{0.2f * float(face), 0, 1, 1};
        }
        return Rgba{0, 1, 0, 1};
      });
    };
    for (int face = 0; face < 6; ++face)
      EXPECT_RGBA8(Run(text(directions[face]), options), 0.2f * float(face), 0, 1, 1) << c.width << "x" << c.height;
    EXPECT_TRUE(warnings_.empty());
  }
  // In a vertical cross the back is upside down: its top is at the bottom of the picture.
  RunnerOptions options = Options();
  options.load_texture = [](const std::string&) -> Result<std::optional<image::Image>> {
    return MakeImage(6, 8, image::SampleType::kU8, [](int x, int y) {
      return Rgba{x == 2 && y == 7 ? 1.0f : 0.0f, x == 3 && y == 6 ? 1.0f : 0.0f, 0, 1};
    });
  };
  EXPECT_RGBA8(Run(text("-0.5, 0.5, -1"), options), 1, 0, 0, 1) << "towards +y and -x: on the face, above and right";
  EXPECT_RGBA8(Run(text("0.5, -0.5, -1"), options), 0, 1, 0, 1);
  options.load_texture = [](const std::string&) -> Result<std::optional<image::Image>> {
    return MakeImage(5, 2, image::SampleType::kU8, [](int, int) { return Rgba{1, 0, 0, 1}; });
  };
  const auto flat = EffectRunner::Create(CompileText(text("1, 0, 0")), options);
  ASSERT_FALSE(flat.has_value());
  EXPECT_EQ(
      flat.error().message,
      "texture 't' of test.fx: sky.dds: 5x2 pixels are no cube: its faces may lie in a cross (4:3, 3:4), a row or a "
      "column");
}

TEST_F(HostTexture, DepthStencilTargetsAreWhiteWithAWarning) {
  const std::string text =
      "texture d : RENDERDEPTHSTENCILTARGET; sampler s = sampler_state { Texture = <d>; };\n"
      "float4 PS(float2 u : TEXCOORD0) : COLOR { return tex2D(s, u); }\n"
      "technique T { pass P { PixelShader = compile ps_2_0 PS(); } }";
  EXPECT_RGBA8(Run(text, Options()), 1, 1, 1, 1);
  EXPECT_EQ(warnings_,
            (std::vector<std::string>{"test.fx: texture 'd' is a depth-stencil target: looked up, it is white"}));
}

TEST_F(HostTexture, NormalMapsAreTheObjectsOrFlat) {
  const std::string text = kObject +
                           "texture n : NORMAL; sampler s = sampler_state { Texture = <n>; };\nfloat4 PS(float2 u : "
                           "TEXCOORD0) : COLOR { return tex2D(s, u); }\n" +
                           kTechnique;
  RunnerOptions options = Options();
  options.has_scene = options.has_source = true;
  EXPECT_RGBA8(Run(text, options, Scene({}, 0, texture_.id())), 0.2f, 0.4f, 0.6f, 1);
  EXPECT_RGBA8(Run(text, options, Scene({}, texture_.id())), 128 / 255.0f, 128 / 255.0f, 1, 1);
}

// As XNA's SpriteBatch binds what it draws.
TEST_F(HostTexture, APictureIsWhatARegisterWithoutATextureShows) {
  const std::string text =
      "sampler s : register(s0); float4 PS(float2 u : TEXCOORD0, float4 c : COLOR0) : COLOR { return tex2D(s, u) * c; "
      "}\n"
      "technique T { pass P { PixelShader = compile ps_2_0 PS(); } }";
  RunnerOptions options = Options();
  options.has_source = true;
  EXPECT_RGBA8(Run(text, options), 0.8f, 0, 0.2f, 1);
  EXPECT_TRUE(warnings_.empty());
  options.has_source = false;
  EXPECT_RGBA8(Run(text, options), 1, 1, 1, 1);
  EXPECT_EQ(warnings_, (std::vector<std::string>{"test.fx: sampler 's' has no texture: a stand-in is used"}));
}

TEST_F(HostTexture, APictureStandsInForObjects) {
  const std::string text =
      "float Script : STANDARDSGLOBAL = 0.8; texture t : DIFFUSE; sampler s = sampler_state { Texture = <t>; };\n" +
      kObject +
      "float4 PS(float2 u : TEXCOORD0) : COLOR { return tex2D(s, u); }\n"
      "technique T < string Script = \"Pass=P;\"; > { pass P < string Script = \"Draw=Geometry;\"; > { VertexShader = "
      "compile vs_2_0 VS(); PixelShader = compile ps_2_0 PS(); } }";
  RunnerOptions options = Options();
  options.has_source = true;
  EXPECT_RGBA8(Run(text, options), 0.8f, 0, 0.2f, 1);
  EXPECT_EQ(warnings_, (std::vector<std::string>{
                           "test.fx: it draws the geometry of a scene; the source is none, so the picture stands in"}));
}

TEST_F(HostTexture, CubesShowTheSurroundings) {
  const std::string text =
      "texture e : ENVIRONMENT < string ResourceName = \"default_reflection.dds\"; string ResourceType = \"Cube\"; >; "
      "samplerCUBE s = sampler_state { Texture = <e>; };\n"
      "float4 PS() : COLOR { return texCUBE(s, float3(0, 1, 0)); }\n"
      "technique T { pass P { PixelShader = compile ps_2_0 PS(); } }";
  GLuint cube = 0;
  glCreateTextures(GL_TEXTURE_CUBE_MAP, 1, &cube);
  const gl::TextureHandle handle(cube);
  glTextureStorage2D(cube, 1, GL_RGBA8, 1, 1);
  for (int face = 0; face < 6; ++face) {
    const std::uint8_t texel[] = {static_cast<std::uint8_t>(face * 51), 255, 0, 255};
    glTextureSubImage3D(cube, 0, 0, 0, face, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, texel);
  }
  RunnerOptions options = Options();
  options.environment = [cube] { return cube; };
  EXPECT_RGBA8(Run(text, options), 0.4f, 1, 0, 1);
  EXPECT_TRUE(warnings_.empty());
}

TEST_F(HostTexture, TechniquesAreChosenObjectByObject) {
  const auto technique = [](const std::string& name, const std::string& flags, const std::string& color) {
    return "technique " + name + " < string MMDPass = \"object\"; " + flags +
           " > { pass P { CullMode = None; VertexShader = compile vs_2_0 VS(); PixelShader = compile ps_2_0 PS(" +
           color + "); } }\n";
  };
  const std::string text = kObject + "float4 PS(uniform float4 c) : COLOR { return c; }\n" +
                           technique("A", "bool UseTexture = false;", "float4(1, 0, 0, 1)") +
                           technique("B", "bool UseTexture = true;", "float4(0, 1, 0, 1)");
  RunnerOptions options = Options();
  options.has_scene = options.has_source = true;
  MaterialContext textured;
  textured.has_texture = true;
  EXPECT_RGBA8(Run(text, options, Scene({}, 0)), 1, 0, 0, 1);
  EXPECT_RGBA8(Run(text, options, Scene(textured, texture_.id())), 0, 1, 0, 1);
  options.has_scene = false;
  EXPECT_RGBA8(Run(text, options), 0, 1, 0, 1) << "a picture is a texture";
}

// The light looks down from above at the scene's middle, which is then the middle of its picture.
TEST_F(HostTexture, MatricesAndPortsOfLights) {
  const std::string text =
      "float4x4 V : VIEW < string Object = \"SpotLight0\"; >; float4x4 P : PROJECTION < string frustum = \"light0\"; "
      ">;\n"
      "float4 PS() : COLOR { float4 m = mul(mul(float4(1, 2, 3, 1), V), P); return float4(m.xy / m.w + 0.5, m.z / m.w, "
      "1); }\ntechnique T { pass P { PixelShader = compile ps_2_0 PS(); } }";
  FrameContext context;
  context.scene_center_world = {1, 2, 3};
  context.scene_radius = 2;
  context.light_direction_world = {0, -1, 0};
  const Rgba middle = Run(text, Options(), {}, context);
  EXPECT_NEAR(middle[0], 0.5f, 0.01f);
  EXPECT_NEAR(middle[1], 0.5f, 0.01f);
  EXPECT_GT(middle[2], 0.1f);
  EXPECT_LT(middle[2], 0.99f);
  const std::string port =
      "float Script : STANDARDSGLOBAL = 0.8; float4x4 VI : VIEWINVERSE;\n"
      "float4 VS(float4 p : POSITION) : POSITION { return p; } float4 PS() : COLOR { return float4(VI[3].xyz / 10, 1); "
      "}\n"
      "technique T < string Script = \"Pass=P;\"; > { pass P < string Script = \"RenderPort=light0;Draw=Buffer;\"; > { "
      "VertexShader = compile vs_2_0 VS(); PixelShader = compile ps_2_0 PS(); } }";
  // Four radii above the middle.
  EXPECT_RGBA8(Run(port, Options(), {}, context), 0.1f, 1, 0.3f, 1);
}

TEST_F(HostTexture, ValuesOfObjectsLightsAndControllers) {
  const auto value = [&](const std::string& globals, const std::string& expression, const FrameContext& context) {
    return Run(globals + "\nfloat4 PS() : COLOR { return " + expression +
                   "; }\ntechnique T { pass P { PixelShader = compile ps_2_0 PS(); } }",
               Options(), {}, context);
  };
  FrameContext context;
  context.light_color = {0.2f, 0.4f, 0.6f, 1};
  context.lights.resize(2);
  context.lights[1].color = {1, 0, 0.5f, 1};
  EXPECT_RGBA8(value("float3 c : DIFFUSE < string Object = \"PointLight1\"; >;", "float4(c, 1)", context), 1, 0, 0.5f,
               1);
  EXPECT_RGBA8(value("float3 c : DIFFUSE < string Object = \"PointLight7\"; > = {0, 1, 0};", "float4(c, 1)", context),
               0, 1, 0, 1);
  EXPECT_RGBA8(value("float4 g_LightDiffuse[3];", "float4(g_LightDiffuse[1].rgb + g_LightDiffuse[2].rgb, 1)", context),
               1, 0, 0.5f, 1);
  EXPECT_RGBA8(value("struct L { float3 Color; float3 Direction; }; L l[2] < string SasBindAddress = "
                     "\"Sas.DirectionalLight[*]\"; >;",
                     "float4(l[0].Color.b, l[1].Color.r, -l[1].Direction.y, 1)", context),
               0.6f, 1, 1, 1);
  EXPECT_RGBA8(value("float a : CONTROLOBJECT < string name = \"(self)\"; >; float b : CONTROLOBJECT < string name = "
                     "\"(self)\"; string item = \"Tr\"; >; bool c : CONTROLOBJECT < string name = \"Other.x\"; >;",
                     "float4(a / 20, b, c, 1)", context),
               0.5f, 1, 0, 1);
  EXPECT_EQ(warnings_, (std::vector<std::string>{
                           "test.fx: the model 'Other.x' that controls the effect is not here: what it gives is 0"}));
  // The direction towards the light, unless the shader turns it round itself.
  context.light_direction_world = {0, -1, 0};
  EXPECT_RGBA8(value("float3 g_LightDir;", "float4(g_LightDir.y, 0, 0, 1)", context), 1, 0, 0, 1);
  EXPECT_RGBA8(value("float3 g_LightDir;", "float4(dot(float3(0, 1, 0), -normalize(g_LightDir)), 0, 0, 1)", context), 1,
               0, 0, 1);
  context.has_scene = false;
  EXPECT_RGBA8(value("float3 d : DIRECTION < string Object = \"Light\"; > = {0, 0.4, 0};", "float4(d, 1)", context), 0,
               0.4f, 0, 1);
  EXPECT_RGBA8(value("float3 d : DIRECTION < string Object = \"Light\"; > = {0, 0.4, 1};", "float4(-d, 1)", context), 0,
               1, 0, 1)
      << "one from behind leaves a picture dark";
}

}  // namespace
}  // namespace burin::effect

// SPDX-License-Identifier: Apache-2.0
// The conventions that every renderer relies on: rows top first, clip z 0..w, which winding is the front.
#include <epoxy/gl.h>
#include <gmock/gmock.h>

#include "core/gl/framebuffer.h"
#include "core/gl/fullscreen_quad.h"
#include "core/gl/program.h"
#include "core/gl/readback.h"
#include "core/gl/state.h"
#include "tests/gl/gl/context_fixture.h"

namespace burin::gl {
namespace {

class ConventionTest : public ContextTest {
 protected:
  ConventionTest()
      : target_(Must(Texture::Create(PlainFormat(Numeric::kFloat, 32, 4), 5, 3, 1, "target"))),
        depth_(Must(CreateDepthStencil(5, 3, "depth"))) {
    const Texture* color = &target_;
    framebuffer_ = Must(Framebuffer::Create(std::span(&color, 1), &depth_, "test"));
    quad_ = Must(FullscreenQuad::Create());
    ResetState();
    framebuffer_.Bind();
    glClearColor(-1.0f, -1.0f, -1.0f, -1.0f);
    glClearDepthf(1.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  }

  void Draw(const char* fragment, const char* z = "0.0") {
    const std::string vertex = std::string(R"(#version 450 core
layout(location = 0) in vec4 position;
layout(location = 8) in vec4 texcoord;
layout(location = 15) in vec4 texcoord7;
out vec4 uv;
out vec4 uv7;
void main() { gl_Position = vec4(position.xy, )") +
                               z + R"(, 1.0); uv = texcoord; uv7 = texcoord7; })";
    const std::string text = std::string(
                                 "#version 450 core\nin vec4 uv;\nin vec4 uv7;\nlayout(location = 0) out vec4 result;\n"
                                 "void main() { result = ") +
                             fragment + "; }";
    const Program program = Must(Program::Create(vertex, text, "test"));
    glUseProgram(program.id());
    quad_.Draw();
  }

  std::vector<float> Pixel(int x, int y) const {
    const image::Image image = Read(target_, image::SampleType::kF32, 4, image::Encoding::kData);
    const auto at = static_cast<std::size_t>(y * 5 + x) * 4;
    const auto all = image.As<float>();
    return {all.begin() + at, all.begin() + at + 4};
  }

  Texture target_;
  Texture depth_;
  Framebuffer framebuffer_;
  FullscreenQuad quad_;
};

TEST_F(ConventionTest, TheFirstRowIsTheTopAndTexcoordsStartThere) {
  Draw("vec4(uv.xy, gl_FragCoord.xy)");
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 5; ++x) {
      const float cx = static_cast<float>(x) + 0.5f, cy = static_cast<float>(y) + 0.5f;
      EXPECT_THAT(Pixel(x, y),
                  testing::ElementsAre(testing::FloatNear(cx / 5, 1e-6f), testing::FloatNear(cy / 3, 1e-6f), cx, cy));
    }
  }
}

TEST_F(ConventionTest, EveryTexcoordIsTheSame) {
  Draw("uv - uv7");
  for (int x = 0; x < 5; ++x) EXPECT_THAT(Pixel(x, 1), testing::Each(0.0f));
}

TEST_F(ConventionTest, ClipZIsWindowDepth) {
  glEnable(GL_DEPTH_TEST);
  Draw("vec4(gl_FragCoord.z)", "0.25");
  EXPECT_THAT(Pixel(2, 1), testing::Each(0.25f));
  Draw("vec4(2.0)", "-0.01");  // before the near plane: clipped
  EXPECT_THAT(Pixel(2, 1), testing::Each(0.25f));
  Draw("vec4(3.0)", "0.3");  // behind
  EXPECT_THAT(Pixel(2, 1), testing::Each(0.25f));
  Draw("vec4(4.0)", "0.0");
  EXPECT_THAT(Pixel(2, 1), testing::Each(4.0f));
}

// The quadrilateral is clockwise on the screen: culled as a back face where counter-clockwise is the front, as glTF has
// it, and kept by Direct3D's CullMode CCW.
TEST_F(ConventionTest, CounterClockwiseOnTheScreenIsTheFront) {
  glEnable(GL_CULL_FACE);
  glCullFace(GL_BACK);
  Draw("vec4(1.0)");
  EXPECT_THAT(Pixel(2, 1), testing::Each(-1.0f));
  glCullFace(GL_FRONT);
  Draw("vec4(gl_FrontFacing ? 1.0 : 0.0)");
  EXPECT_THAT(Pixel(2, 1), testing::Each(0.0f));
}

}  // namespace
}  // namespace burin::gl

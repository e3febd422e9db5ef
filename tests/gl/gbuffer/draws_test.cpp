// SPDX-License-Identifier: Apache-2.0
// The draws that a custom attribute's own shaders are run over.
#include <epoxy/gl.h>
#include <gmock/gmock.h>

#include "core/gl/framebuffer.h"
#include "core/gl/program.h"
#include "core/gl/state.h"
#include "tests/gl/gbuffer/scene_fixture.h"

namespace burin::gbuffer {
namespace {

class DrawsTest : public GbufferTest {};

TEST_F(DrawsTest, EveryItemDrawsWithItsAttributesAndMatrix) {
  TestScene test;
  scene::Primitive square = Square();
  square.colors.assign(4, {0.25f, 0.5f, 0.75f, 1});
  test.AddNode(test.AddMesh(square), Translate(-0.5f, 0, 0) * glm::scale(glm::mat4(1.0f), glm::vec3(0.5f, 1.0f, 1.0f)));
  test.AddNode(test.AddMesh(Square()),
               Translate(0.5f, 0, 0) * glm::scale(glm::mat4(1.0f), glm::vec3(0.5f, 1.0f, 1.0f)));
  const std::unique_ptr<SceneRenderer> renderer = Must(SceneRenderer::Create(test.scene, nullptr));
  const scene::Pose pose = scene::EvaluatePose(test.scene, {}, 0.0);
  const std::vector<scene::DrawItem> items = scene::BuildDrawItems(test.scene, pose, pose);
  FrameInput frame;
  frame.pose = &pose;
  frame.items = items;
  const std::vector<GeometryDraw> draws = Must(renderer->Draws(frame));
  ASSERT_EQ(draws.size(), 2u);

  const gl::Program program = Must(gl::Program::Create(R"(#version 450 core
layout(location = 0) in vec4 position;
layout(location = 4) in vec4 color;
layout(location = 8) in vec4 texcoord;
layout(location = 15) in vec4 texcoord7;
uniform mat4 world;
out vec4 value;
void main() { gl_Position = world * position; value = vec4(color.xy, texcoord.x, texcoord7.x); })",
                                                       R"(#version 450 core
in vec4 value;
layout(location = 0) out vec4 result;
void main() { result = value; })",
                                                       "test"));
  const gl::Texture target = Must(gl::Texture::Create(Float(), 4, 2, 1, "target"));
  const gl::Texture* color = &target;
  const gl::Framebuffer framebuffer = Must(gl::Framebuffer::Create(std::span(&color, 1), nullptr, "test"));
  gl::ResetState();
  framebuffer.Bind();
  glUseProgram(program.id());
  for (const GeometryDraw& draw : draws) {
    glUniformMatrix4fv(program.UniformLocation("world"), 1, GL_FALSE, &draw.world_from_object[0][0]);
    glBindVertexArray(draw.vertex_array);
    glDrawElements(draw.mode, draw.index_count, GL_UNSIGNED_INT, nullptr);
  }
  const Picture picture = ReadPicture(target);
  EXPECT_THAT(picture.At(0, 0), testing::ElementsAre(0.25f, 0.5f, testing::FloatNear(0.25f, 1e-4f), 0));
  EXPECT_THAT(picture.At(3, 1), testing::ElementsAre(1, 1, testing::FloatNear(0.75f, 1e-4f), 0));
}

}  // namespace
}  // namespace burin::gbuffer

// SPDX-License-Identifier: Apache-2.0
// Tessellated surfaces on the device: attributes, watertightness as rasterised, no pops.
#include <epoxy/gl.h>
#include <gmock/gmock.h>

#include <bit>
#include <map>

#include "core/gbuffer/frame_blocks.h"
#include "core/gbuffer/geometry_shader.h"
#include "core/gl/buffer.h"
#include "core/gl/framebuffer.h"
#include "core/gl/program.h"
#include "core/gl/state.h"
#include "core/scene/item_tessellator.h"
#include "tests/gl/gbuffer/scene_fixture.h"
#include "tests/support/patch_models.h"

namespace burin::gbuffer {
namespace {

using scene::TessellationMode;
using testing::ElementsAre;
using testing::FloatNear;

/// The square -1..1 at z = 0 as one bilinear patch, u to the right and v up.
scene::Primitive PatchSquare(std::uint32_t face = 0) {
  geometry::BezierPatches patches;
  patches.positions = {{-1, -1, 0, 1}, {1, -1, 0, 1}, {-1, 1, 0, 1}, {1, 1, 0, 1}};
  geometry::BezierPatch patch;
  patch.position = {.first = 0, .u_order = 2, .v_order = 2};
  patch.face = face;
  patches.patches = {patch};
  scene::Primitive primitive;
  primitive.patches = std::make_shared<const geometry::BezierPatches>(std::move(patches));
  return primitive;
}

class Tessellated : public GbufferTest {
 protected:
  /// Tessellates what the fixture renders.
  void Tessellate(const TestScene& test, const scene::TessellationOptions& options, const scene::View& view = {},
                  int size = 64) {
    change_items_ = [&test, options, view, size](std::vector<scene::DrawItem>& items) {
      scene::ItemTessellator tessellator(test.scene, options);
      ASSERT_TRUE(tessellator.Tessellate(view, size, size, items));
    };
  }
};

TEST_F(Tessellated, PatchesHaveTheirParametersAndIds) {
  TestScene test;
  test.AddNode(test.AddMesh(PatchSquare(4)), Translate(0, 0, -3));
  test.AddNode(test.AddMesh(PatchSquare(1)),
               Translate(0.5f, 0, -2) * glm::scale(glm::mat4(1.0f), glm::vec3(0.5f, 1.0f, 1.0f)));
  Tessellate(test, {.mode = TessellationMode::kAuto, .edge_length_px = {}, .factor = 5.0f});
  const Picture uv = Render(test, Orthographic(), Attribute::kPatchUv, Float(), 8, 8);
  EXPECT_THAT(uv.At(1, 0), ElementsAre(FloatNear(1.5f / 8, 1e-5f), FloatNear(7.5f / 8, 1e-5f), 0, 1));
  EXPECT_THAT(uv.At(7, 7), ElementsAre(FloatNear(7.0f / 8, 1e-5f), FloatNear(0.5f / 8, 1e-5f), 0, 1));
  const Picture id = Render(test, Orthographic(), Attribute::kPatchId, Float(), 8, 8);
  EXPECT_EQ(id.At(1, 4)[0], 5.0f) << "face 4, counted from 1";
  EXPECT_EQ(id.At(6, 4)[0], 7.0f) << "face 1 of the second item, after the first one's five";
}

TEST_F(Tessellated, WhatIsNoPatchHasNone) {
  TestScene test;
  test.AddNode(test.AddMesh(Square()), Translate(0, 0, -3));
  EXPECT_THAT(Render(test, Orthographic(), Attribute::kPatchUv, Float(), 4, 4).At(1, 1), ElementsAre(0, 0, 0, 1));
  EXPECT_EQ(Render(test, Orthographic(), Attribute::kPatchId, Float(), 4, 4).At(1, 1)[0], 0.0f);
}

TEST_F(Tessellated, PrimitiveIdsRunOnOverSurfaces) {
  TestScene test;
  test.AddNode(test.AddMesh(PatchSquare()), Translate(0, 0, -3));
  test.AddNode(test.AddMesh(Square()),
               Translate(0.5f, 0, -2) * glm::scale(glm::mat4(1.0f), glm::vec3(0.5f, 1.0f, 1.0f)));
  Tessellate(test, {}, Orthographic(), 16);  // two pieces of 8 pixels a side
  const Picture id = Render(test, Orthographic(), Attribute::kPrimitiveId, Float(), 8, 8);
  EXPECT_LE(id.At(0, 7)[0], 8.0f);
  EXPECT_GE(id.At(0, 7)[0], 1.0f);
  EXPECT_THAT(id.At(7, 7)[0], testing::AnyOf(9.0f, 10.0f)) << "after the surface's 8";
}

TEST_F(Tessellated, VelocityFollowsTheSurfaceOfThePoseBefore) {
  TestScene test;
  scene::Primitive sphere = Sphere(scene::kNone, 16);
  test.AddNode(test.AddMesh(sphere), Translate(0, 0, -3));
  change_items_ = [&](std::vector<scene::DrawItem>& items) {
    items[0].is_deformed = true;
    items[0].deformed.positions = sphere.positions;
    items[0].deformed.normals = sphere.normals;
    items[0].deformed.previous_positions = sphere.positions;
    items[0].deformed.previous_normals = sphere.normals;
    for (glm::vec3& p : items[0].deformed.previous_positions) p *= 0.9f;
    scene::ItemTessellator tessellator(test.scene,
                                       {.mode = TessellationMode::kFractional, .edge_length_px = {}, .factor = 4.0f});
    ASSERT_TRUE(tessellator.TessellateEvenly(4.0f, items));
    ASSERT_TRUE(items[0].surface);
  };
  const Picture v = Render(test, Orthographic(), Attribute::kVelocity, Float(), 64, 64);
  // A point at x was at 0.9 x: 32 pixels a unit.
  const float x = (48.5f - 32) / 32, y = (40.5f - 32) / 32;
  EXPECT_NEAR(v.At(48, 40)[0], 0.1f * x * 32, 0.02f);
  EXPECT_NEAR(v.At(48, 40)[1], 0.1f * y * 32, 0.02f);
}

// ---- watertight as rasterised

/// Signed overlap: +1 a front face, -1 a back face, none culled, no depth test. A closed surface gives 0 in every
/// pixel; a hole or a double hit on an edge gives something else.
class Overlap {
 public:
  explicit Overlap(int size)
      : size_(size),
        target_(Must(gl::Texture::Create(Float(), size, size, 1, "overlap"))),
        program_(Must(gl::Program::Create(R"(#version 450 core
layout(location = 0) in vec3 position;
uniform mat4 clip;
invariant gl_Position;
void main() { gl_Position = clip * vec4(position, 1.0); })",
                                          R"(#version 450 core
layout(location = 0) out vec4 sum;
void main() { sum = gl_FrontFacing ? vec4(1.0, 1.0, 0.0, 1.0) : vec4(-1.0, 0.0, 1.0, 1.0); })",
                                          "overlap"))) {}

  /// The pixels' sums (r), fronts (g) and backs (b).
  std::vector<float> Count(std::span<const GeometryDraw> draws, const glm::mat4& clip_from_world) {
    const gl::Texture* const color = &target_;
    const gl::Framebuffer framebuffer = Must(gl::Framebuffer::Create(std::span(&color, 1), nullptr, "overlap"));
    gl::ResetState();
    framebuffer.Bind();
    const float zero[4] = {};
    glClearBufferfv(GL_COLOR, 0, zero);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glUseProgram(program_.id());
    for (const GeometryDraw& draw : draws) {
      const glm::mat4 clip = clip_from_world * draw.world_from_object;
      glUniformMatrix4fv(program_.UniformLocation("clip"), 1, GL_FALSE, &clip[0][0]);
      glBindVertexArray(draw.vertex_array);
      glDrawElements(draw.mode, draw.index_count, GL_UNSIGNED_INT, nullptr);
    }
    glDisable(GL_BLEND);
    const image::Image image = gl::Read(target_, image::SampleType::kF32, 4, image::Encoding::kData);
    const auto values = image.As<float>();
    return {values.begin(), values.end()};
  }

 private:
  int size_;
  gl::Texture target_;
  gl::Program program_;
};

glm::mat4 Look(int view, float distance) {
  // Directions by the golden angle, all over the sphere.
  const float height = 1.0f - 2.0f * (static_cast<float>(view) + 0.5f) / 100.0f;
  const float angle = 2.399963f * static_cast<float>(view);
  const float radius = std::sqrt(1.0f - height * height);
  const glm::vec3 eye = distance * glm::vec3(radius * std::cos(angle), height, radius * std::sin(angle));
  return glm::lookAt(eye, glm::vec3(0.0f), glm::vec3(0.0f, 1.0f, 0.0f));
}

TEST_F(Tessellated, AClosedModelHasNoHoleAndNoDoubleHitFromAHundredViews) {
  constexpr int kSize = 72;
  TestScene test;
  test.AddNode(test.AddMesh(test::Pot()), glm::mat4(1.0f));
  Overlap overlap(kSize);
  const std::unique_ptr<SceneRenderer> renderer = Must(SceneRenderer::Create(test.scene, nullptr));
  const scene::Pose pose = scene::EvaluatePose(test.scene, {}, 0.0);
  std::vector<scene::DrawItem> items = scene::BuildDrawItems(test.scene, pose, pose);
  for (const TessellationMode mode : {TessellationMode::kInteger, TessellationMode::kFractional}) {
    scene::ItemTessellator tessellator(test.scene, {.mode = mode, .edge_length_px = 5.0f, .factor = {}});
    for (int view = 0; view < 100; ++view) {
      scene::View seen = Perspective(0.8f, 1.0f, 0.1f);
      seen.view_from_world = Look(view, 3.0f + 0.03f * static_cast<float>(view));
      ASSERT_TRUE(tessellator.Tessellate(seen, kSize, kSize, items));
      FrameInput frame;
      frame.pose = &pose;
      frame.items = items;
      const std::vector<float> sums =
          overlap.Count(Must(renderer->Draws(frame)), seen.clip_from_view * seen.view_from_world);
      int faulty = 0, covered = 0;
      for (std::size_t i = 0; i < sums.size(); i += 4) {
        faulty += sums[i] != 0.0f ? 1 : 0;
        covered += sums[i + 1] > 0.0f ? 1 : 0;
      }
      ASSERT_EQ(faulty, 0) << "view " << view << ", integer " << (mode == TessellationMode::kInteger);
      ASSERT_GT(covered, kSize * kSize / 20);
    }
  }
}

/// The program of the geometry pass's vertex stage alone, its positions captured.
GLuint CapturingProgram() {
  const std::string text = GeometryVertexText(kHasPatches);
  const char* const source = text.c_str();
  const GLuint shader = glCreateShader(GL_VERTEX_SHADER);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  const GLuint program = glCreateProgram();
  glAttachShader(program, shader);
  const char* const varyings[] = {"gl_Position"};
  glTransformFeedbackVaryings(program, 1, varyings, GL_INTERLEAVED_ATTRIBS);
  glLinkProgram(program);
  glDeleteShader(shader);
  GLint linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  EXPECT_EQ(linked, GL_TRUE);
  return program;
}

TEST_F(Tessellated, SharedPositionsAreTheSameBitsBehindTheVertexStage) {
  TestScene test;
  test.AddNode(test.AddMesh(test::Pot()),
               glm::rotate(Translate(0.3f, -0.1f, -4.7f), 0.9f, glm::normalize(glm::vec3(1, 2, 3))));
  const scene::Pose pose = scene::EvaluatePose(test.scene, {}, 0.0);
  std::vector<scene::DrawItem> items = scene::BuildDrawItems(test.scene, pose, pose);
  const scene::View view = Perspective(0.7f, 1.3f);
  scene::ItemTessellator tessellator(test.scene,
                                     {.mode = TessellationMode::kAuto, .edge_length_px = 9.0f, .factor = {}});
  ASSERT_TRUE(tessellator.Tessellate(view, 700, 500, items));
  const std::unique_ptr<SceneRenderer> renderer = Must(SceneRenderer::Create(test.scene, nullptr));
  FrameInput frame;
  frame.view = frame.previous_view = view;
  frame.pose = &pose;
  frame.items = items;
  const std::vector<GeometryDraw> draws = Must(renderer->Draws(frame));
  ASSERT_EQ(draws.size(), 1u);

  const gl::Texture target = Must(gl::Texture::Create(Float(), 4, 4, 1, "unused"));
  const gl::Texture* const color = &target;
  const gl::Framebuffer framebuffer = Must(gl::Framebuffer::Create(std::span(&color, 1), nullptr, "unused"));
  framebuffer.Bind();
  const GLuint program = CapturingProgram();
  const gl::BufferHandle frame_block = gl::CreateBuffer("frame"), draw_block = gl::CreateBuffer("draw");
  const FrameBlock frame_values = MakeFrameBlock(frame, {}, 700, 500);
  const DrawBlock draw_values = MakeDrawBlock(items[0]);
  gl::StreamInto(frame_block, &frame_values, sizeof(frame_values));
  gl::StreamInto(draw_block, &draw_values, sizeof(draw_values));
  glBindBufferBase(GL_UNIFORM_BUFFER, kFrameBinding, frame_block.id());
  glBindBufferBase(GL_UNIFORM_BUFFER, kDrawBinding, draw_block.id());
  const auto count = static_cast<std::size_t>(draws[0].index_count);
  const gl::BufferHandle captured = gl::CreateBuffer("captured");
  glNamedBufferData(captured.id(), static_cast<GLsizeiptr>(count * sizeof(glm::vec4)), nullptr, GL_STREAM_READ);
  glUseProgram(program);
  glEnable(GL_RASTERIZER_DISCARD);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, captured.id());
  glBindVertexArray(draws[0].vertex_array);
  glBeginTransformFeedback(GL_TRIANGLES);
  glDrawElements(GL_TRIANGLES, draws[0].index_count, GL_UNSIGNED_INT, nullptr);
  glEndTransformFeedback();
  glDisable(GL_RASTERIZER_DISCARD);
  glUseProgram(0);
  glDeleteProgram(program);
  std::vector<glm::vec4> clip(count);
  glGetNamedBufferSubData(captured.id(), 0, static_cast<GLsizeiptr>(count * sizeof(glm::vec4)), clip.data());

  // Every edge of the closed surface comes once each way, by the bits of its clip positions.
  using Bits = std::array<std::uint32_t, 4>;
  const auto bits = [&](std::size_t i) {
    return Bits{std::bit_cast<std::uint32_t>(clip[i].x), std::bit_cast<std::uint32_t>(clip[i].y),
                std::bit_cast<std::uint32_t>(clip[i].z), std::bit_cast<std::uint32_t>(clip[i].w)};
  };
  std::map<std::pair<Bits, Bits>, int> edges;
  for (std::size_t t = 0; t < count; t += 3) {
    for (std::size_t k = 0; k < 3; ++k) ++edges[{bits(t + k), bits(t + (k + 1) % 3)}];
  }
  for (const auto& [edge, uses] : edges) {
    ASSERT_EQ(uses, 1);
    const auto back = edges.find({edge.second, edge.first});
    ASSERT_TRUE(back != edges.end() && back->second == 1);
  }
  EXPECT_GT(count, 3000u);
}

TEST_F(Tessellated, NothingPopsAsAModelComesNearAndTurns) {
  constexpr int kSize = 64, kSteps = 32;
  TestScene test;
  test.AddNode(test.AddMesh(test::Pot()), glm::mat4(1.0f));
  const auto picture = [&](int step, const scene::TessellationOptions& options) {
    scene::View view = Perspective(0.7f, 1.0f, 0.1f);
    const float t = static_cast<float>(step) / kSteps;
    view.view_from_world = glm::lookAt(glm::vec3(0.0f, 1.5f, 9.0f - 4.5f * t), glm::vec3(0.0f), glm::vec3(0, 1, 0)) *
                           glm::rotate(glm::mat4(1.0f), 0.5f * t, glm::vec3(0, 1, 0));
    Tessellate(test, options, view, kSize);
    return Render(test, view, Attribute::kViewNormal, Float(), kSize, kSize);
  };
  // The difference from the surface itself, so that the motion's own is left out: a pop is a jump of it.
  float last = 0.0f, jump = 0.0f, most = 0.0f;
  for (int step = 0; step <= kSteps; ++step) {
    const Picture now = picture(step, {.mode = TessellationMode::kFractional, .edge_length_px = 12.0f, .factor = {}});
    const Picture surface =
        picture(step, {.mode = TessellationMode::kFractional, .edge_length_px = {}, .factor = 16.0f});
    float sum = 0.0f;
    for (std::size_t i = 0; i < now.values.size(); ++i) sum += std::abs(now.values[i] - surface.values[i]);
    sum /= static_cast<float>(now.values.size());
    if (step > 0) jump = std::max(jump, std::abs(sum - last));
    most = std::max(most, sum);
    last = sum;
  }
  EXPECT_LT(most, 0.01f);
  EXPECT_LT(jump, 0.004f) << "of at most " << most;
  RecordProperty("most", std::to_string(most));
  RecordProperty("jump", std::to_string(jump));
}

}  // namespace
}  // namespace burin::gbuffer

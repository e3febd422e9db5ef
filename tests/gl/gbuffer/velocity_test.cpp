// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "tests/gl/gbuffer/scene_fixture.h"

namespace burin::gbuffer {
namespace {

using testing::ElementsAre;
using testing::FloatNear;

class Velocity : public GbufferTest {
 protected:
  static TestScene Wall() {
    TestScene test;
    test.AddNode(test.AddMesh(Square()), Translate(0, 0, -5));
    return test;
  }
};

TEST_F(Velocity, WhatStandsStillHasNoneExactly) {
  TestScene test;
  test.AddNode(test.AddMesh(Sphere()),
               Translate(0.3f, 0.1f, -4) * glm::rotate(glm::mat4(1.0f), 0.7f, glm::vec3(0.6f, 0.8f, 0)));
  const Picture picture = Render(test, Perspective(0.8f, 1.0f), Attribute::kVelocity, Float(), 32, 32);
  for (int i = 0; i < 32 * 32; ++i) {
    EXPECT_EQ(picture.At(i % 32, i / 32)[0], 0.0f);
    EXPECT_EQ(picture.At(i % 32, i / 32)[1], 0.0f);
  }
}

TEST_F(Velocity, IsInPixelsWithYDown) {
  change_items_ = [](std::vector<scene::DrawItem>& items) {
    items[0].previous_world_from_object = Translate(-0.25f, -0.5f, -5);  // it moved right and up
  };
  // 16 x 8 pixels over a width and height of 2.
  const std::vector<float> v = Render(Wall(), Orthographic(), Attribute::kVelocity, Float(), 16, 8).At(8, 4);
  EXPECT_THAT(v, ElementsAre(FloatNear(2.0f, 1e-4f), FloatNear(-2.0f, 1e-4f), 0.0f, 1.0f));
}

TEST_F(Velocity, FollowsThePerspective) {
  change_items_ = [](std::vector<scene::DrawItem>& items) {
    items[0].previous_world_from_object = Translate(0, 0, -6);
  };
  const float yfov = 0.5f;  // the wall covers the frame: 1 > 5 tan(0.25)... only its middle is read
  const std::vector<float> v =
      Render(Wall(), Perspective(yfov, 1.0f), Attribute::kVelocity, Float(), 40, 40).At(25, 12);
  // The centre of pixel (25, 12) sees the point p; p was 1 farther away.
  const float tangent = std::tan(yfov / 2);
  const float px = (2.0f * 25.5f / 40 - 1.0f) * tangent * 5, py = (1.0f - 2.0f * 12.5f / 40) * tangent * 5;
  const float before_x = (px / (6 * tangent) + 1) * 20, before_y = (1 - py / (6 * tangent)) * 20;
  EXPECT_THAT(v[0], FloatNear(25.5f - before_x, 1e-3f));
  EXPECT_THAT(v[1], FloatNear(12.5f - before_y, 1e-3f));
}

TEST_F(Velocity, ContainsTheCamerasMotion) {
  previous_view_ = Orthographic();
  previous_view_->view_from_world = Translate(0.5f, 0, 0);  // the camera moved to the right: things go left
  EXPECT_THAT(Render(Wall(), Orthographic(), Attribute::kVelocity, Float(), 16, 8).At(4, 4)[0],
              FloatNear(-4.0f, 1e-4f));
}

TEST_F(Velocity, ContainsDeformation) {
  TestScene test = Wall();
  change_items_ = [&](std::vector<scene::DrawItem>& items) {
    const scene::Primitive& square = test.scene.meshes[0].primitives[0];
    items[0].is_deformed = true;
    items[0].deformed.positions = square.positions;
    items[0].deformed.normals = square.normals;
    items[0].deformed.previous_positions = square.positions;
    for (glm::vec3& position : items[0].deformed.previous_positions) position.x -= 0.125f * (position.x + 1.0f);
  };
  const std::vector<float> v = Render(test, Orthographic(), Attribute::kVelocity, Float(), 16, 8).At(12, 4);
  const float x = 2.0f * 12.5f / 16 - 1.0f;
  EXPECT_THAT(v[0], FloatNear(0.125f * (x + 1.0f) * 8, 1e-3f));
  EXPECT_THAT(v[1], FloatNear(0.0f, 1e-4f));
}

}  // namespace
}  // namespace burin::gbuffer

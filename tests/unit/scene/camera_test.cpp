// SPDX-License-Identifier: Apache-2.0

#include "core/scene/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "scene_fixture.h"

namespace burin::scene {
namespace {

constexpr float kTolerance = 1e-5f;

/// Clip space to (x, y, z) after the division.
glm::vec3 Project(const View& view, const glm::vec3& world) {
  const glm::vec4 clip = view.clip_from_view * view.view_from_world * glm::vec4(world, 1.0f);
  return glm::vec3(clip) / clip.w;
}

class FileCamera : public ::testing::Test {
 protected:
  Scene scene_ = ReadOrDie(DataPath("everything.gltf"));
  Pose pose_ = EvaluatePose(scene_, {}, 0.0);

  View Look(int node, int width, int height, double orbit_deg = 0.0, const Bounds& bounds = {}) {
    return MakeView(scene_, {node, bounds, {}}, pose_, width, height, orbit_deg);
  }
};

TEST_F(FileCamera, IsSelectedByNameNodeOrIndex) {
  EXPECT_EQ(SelectCamera(scene_, "").value(), 4);
  EXPECT_EQ(SelectCamera(scene_, "auto").value(), kNone);
  EXPECT_EQ(SelectCamera(scene_, "finite").value(), 5);
  EXPECT_EQ(SelectCamera(scene_, "camera node 2").value(), 6);
  EXPECT_EQ(SelectCamera(scene_, "1").value(), 5);
  const auto bad = SelectCamera(scene_, "3");
  ASSERT_FALSE(bad);
  EXPECT_EQ(bad.error().kind, ErrorKind::kUsage);
  EXPECT_EQ(bad.error().message,
            R"(no camera "3": the scene has 0 "infinite", 1 "finite", 2 "camera node 2"; "auto" frames it)");
  EXPECT_EQ(SelectCamera(Scene(), "").value(), kNone);
  EXPECT_EQ(SelectCamera(Scene(), "top").error().message, R"(no camera "top": the scene has none; "auto" frames it)");
}

TEST_F(FileCamera, HasDepthFromZeroToOne) {
  const View view = Look(5, 200, 100);  // at (1, 0, 5), yfov 0.5, near 1, far 11; its node's scale of 3 is ignored
  EXPECT_FALSE(view.orthographic);
  EXPECT_NEAR(Project(view, {1, 0, 4}).z, 0.0f, kTolerance);
  EXPECT_NEAR(Project(view, {1, 0, -6}).z, 1.0f, kTolerance);
  const float top = 2.0f * std::tan(0.25f);
  EXPECT_NEAR(Project(view, {1, top, 3}).y, 1.0f, kTolerance) << "y grows upwards in clip space";
  EXPECT_NEAR(Project(view, {1 + 2 * top, 0, 3}).x, 1.0f, kTolerance) << "the frame is twice as wide as high";
}

TEST_F(FileCamera, KeepsItsVerticalFieldInAnyFrame) {
  const float top = 2.0f * std::tan(0.25f);
  const View tall = Look(5, 100, 400);
  EXPECT_NEAR(Project(tall, {1, top, 3}).y, 1.0f, kTolerance);
  EXPECT_NEAR(Project(tall, {1 + top / 4, 0, 3}).x, 1.0f, kTolerance);
}

TEST_F(FileCamera, MayBeInfinite) {
  const View view = Look(4, 100, 100);
  EXPECT_TRUE(std::isinf(view.zfar));
  EXPECT_NEAR(Project(view, {0, 0, 4.5f}).z, 0.0f, kTolerance);
  EXPECT_NEAR(Project(view, {0, 0, -1e6f}).z, 1.0f, kTolerance);
  EXPECT_LT(Project(view, {0, 0, -100.0f}).z, 1.0f);
}

TEST_F(FileCamera, MayBeOrthographic) {
  const View view = Look(6, 300, 200);  // at (2, 0, 5), ymag 3, near 0, far 10
  EXPECT_TRUE(view.orthographic);
  EXPECT_NEAR(Project(view, {2, 3, 0}).y, 1.0f, kTolerance);
  EXPECT_NEAR(Project(view, {2 + 4.5f, 0, 0}).x, 1.0f, kTolerance);
  EXPECT_NEAR(Project(view, {2, 0, 5}).z, 0.0f, kTolerance);
  EXPECT_NEAR(Project(view, {2, 0, -5}).z, 1.0f, kTolerance);
}

TEST_F(FileCamera, OrbitsTheCentreOfTheBounds) {
  const Bounds bounds{{0, 0, 0}, {2, 2, 2}};
  const View view = Look(5, 100, 100, 90.0, bounds);
  // The eye, at (1, 0, 5), is 4 from the centre's axis; a quarter turn from +z towards +x takes it to (5, 0, 1).
  const glm::vec3 eye(glm::inverse(view.view_from_world)[3]);
  EXPECT_NEAR(eye.x, 5.0f, kTolerance);
  EXPECT_NEAR(eye.y, 0.0f, kTolerance);
  EXPECT_NEAR(eye.z, 1.0f, kTolerance);
  EXPECT_NEAR(Project(view, {1, 0, 1}).x, 0.0f, kTolerance) << "it still looks at the axis";
}

TEST(AutoCamera, ShowsTheWholeBoundsAtEveryAngle) {
  const std::vector<Bounds> boxes = {{{-1, -1, -1}, {1, 1, 1}},
                                     {{0, 0, 0}, {10, 1, 2}},
                                     {{-1, 0, -1}, {1, 30, 1}},
                                     {{1e4f, 0, 0}, {1e4f + 1, 1, 1}},
                                     {{-1e-3f, 0, 0}, {1e-3f, 1e-3f, 0}}};
  for (const Bounds& box : boxes) {
    for (const auto& [width, height] : {std::pair(100, 100), std::pair(1920, 1080), std::pair(100, 700)}) {
      float largest = 0.0f;
      for (int angle = 0; angle < 360; angle += 15) {
        const View view = MakeView(Scene(), {kNone, box, {}}, {}, width, height, angle);
        for (int corner = 0; corner < 8; ++corner) {
          const glm::vec3 p((corner & 1) != 0 ? box.max.x : box.min.x, (corner & 2) != 0 ? box.max.y : box.min.y,
                            (corner & 4) != 0 ? box.max.z : box.min.z);
          const glm::vec3 at = Project(view, p);
          largest = std::max({largest, std::abs(at.x), std::abs(at.y)});
          EXPECT_GT(at.z, 0.0f);
          EXPECT_LT(at.z, 1.0f);
        }
      }
      EXPECT_LT(largest, 1.0f) << "nothing is cut off";
      EXPECT_GT(largest, 0.75f) << "and the picture is used";
    }
  }
}

TEST(AutoCamera, FillsThePictureWithWhatTheSceneReaches) {
  // A slanted rod's box is much larger than the rod: its corners are far outside, the rod's ends touch the margin.
  for (const glm::vec3 end : {glm::vec3(10, -4, 2), glm::vec3(-1, 30, 1), glm::vec3(0.2f, 0.1f, -9)}) {
    for (const auto& [width, height] : {std::pair(100, 100), std::pair(1920, 1080), std::pair(100, 700)}) {
      for (int angle = 0; angle < 360; angle += 45) {
        const std::array<glm::mat4, 2> maps = AutoReach(width, height, angle);
        CameraChoice choice{kNone, {glm::min(end, -end), glm::max(end, -end)}, std::array<Bounds, 2>()};
        for (std::size_t i = 0; i < 2; ++i) {
          for (const glm::vec3& p : {end, -end}) {
            const glm::vec3 mapped(maps[i] * glm::vec4(p, 1.0f));
            (*choice.reach)[i].Extend({mapped, mapped});
          }
        }
        const View view = MakeView(Scene(), choice, {}, width, height, angle);
        const glm::vec3 a = Project(view, end), b = Project(view, -end);
        const float reach = std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)});
        EXPECT_LT(reach, 1.0f);
        const glm::vec3 along = glm::normalize(glm::mat3(view.view_from_world) * end);
        if (std::abs(along.z) < 0.9f) EXPECT_GT(reach, 0.8f) << end.x << ' ' << angle << ' ' << width;
        EXPECT_GT(std::min(a.z, b.z), 0.0f);
        EXPECT_LT(std::max(a.z, b.z), 1.0f);
      }
    }
  }
}

TEST(AutoCamera, KeepsItsDistanceWhileItTurns) {
  const Bounds box{{0, 0, 0}, {10, 1, 2}};
  const glm::vec3 centre(5, 0.5f, 1);
  float distance = 0.0f;
  for (int angle = 0; angle < 360; angle += 30) {
    const View view = MakeView(Scene(), {kNone, box, {}}, {}, 640, 480, angle);
    const glm::vec3 eye(glm::inverse(view.view_from_world)[3]);
    if (angle == 0) {
      distance = glm::length(eye - centre);
      EXPECT_GT(eye.x, centre.x) << "from the right,";
      EXPECT_GT(eye.y, centre.y) << "above";
      EXPECT_GT(eye.z, centre.z) << "and in front";
    }
    EXPECT_NEAR(glm::length(eye - centre), distance, 1e-4f * distance);
    const glm::vec3 middle = Project(view, centre);
    EXPECT_NEAR(middle.x, 0.0f, kTolerance);
    EXPECT_NEAR(middle.y, 0.0f, kTolerance);
  }
}

TEST(AutoCamera, FramesNothingAndPointsWithoutFault) {
  for (const Bounds& box : {Bounds(), Bounds{{3, 3, 3}, {3, 3, 3}}}) {
    const View view = MakeView(Scene(), {kNone, box, {}}, {}, 64, 64, 0.0);
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        EXPECT_TRUE(std::isfinite(view.clip_from_view[i][j]));
        EXPECT_TRUE(std::isfinite(view.view_from_world[i][j]));
      }
    }
    EXPECT_GT(view.znear, 0.0f);
    EXPECT_GT(view.zfar, view.znear);
  }
}

}  // namespace
}  // namespace burin::scene

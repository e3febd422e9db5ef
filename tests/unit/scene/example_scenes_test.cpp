// SPDX-License-Identifier: Apache-2.0
// The committed scenes are what their scripts make, and they hold what the documentation says.

#include <algorithm>
#include <glm/geometric.hpp>

#include "core/scene/camera.h"
#include "core/scene/pose.h"
#include "scene_fixture.h"

namespace burin::scene {
namespace {

std::string Source(const std::string& name) { return Environment("BURIN_SOURCE_DIR", ".") + "/" + name; }

TEST(ExampleScenes, AreWhatTheirScriptsMake) {
  if (std::system("python3 -c pass >/dev/null 2>&1") != 0) GTEST_SKIP() << "no python3 here";
  EXPECT_EQ(std::system(("python3 '" + Source("examples/make_inputs.py") + "' --check").c_str()), 0);
  EXPECT_EQ(std::system(("python3 '" + Source("tests/data/make_scenes.py") + "' --check").c_str()), 0);
}

TEST(ExampleScenes, HoldAStillLife) {
  const Scene scene = ReadOrDie(Source("examples/still_life.glb"));
  EXPECT_TRUE(scene.warnings.empty());
  EXPECT_EQ(scene.lights.size(), 4u);
  EXPECT_NE(SelectCamera(scene, "").value(), kNone);
  const Pose pose = EvaluatePose(scene, {}, 0.0);
  EXPECT_EQ(BuildDrawItems(scene, pose, pose).size(), 10u);
}

TEST(ExampleScenes, FaceOutwards) {
  // Every triangle turns the way that its normals look.
  for (const char* name : {"examples/still_life.glb", "examples/walk.glb"}) {
    for (const Mesh& mesh : ReadOrDie(Source(name)).meshes) {
      const Primitive& p = mesh.primitives[0];
      for (std::size_t i = 0; i < p.indices.size(); i += 3) {
        const glm::vec3 a = p.positions[p.indices[i]];
        const glm::vec3 face = glm::cross(p.positions[p.indices[i + 1]] - a, p.positions[p.indices[i + 2]] - a);
        const glm::vec3 normal = p.normals[p.indices[i]] + p.normals[p.indices[i + 1]] + p.normals[p.indices[i + 2]];
        ASSERT_GT(glm::dot(face, normal), 0.0f) << mesh.name << " triangle " << i / 3;
      }
    }
  }
}

TEST(ExampleScenes, WalkInALoopOfTwoSeconds) {
  const Scene scene = ReadOrDie(Source("examples/walk.glb"));
  EXPECT_TRUE(scene.warnings.empty());
  const AnimationSelection selection = SelectAnimations(scene, "auto").value();
  EXPECT_EQ(Duration(scene, selection), 2.0f);
  const auto positions = [&](double t) {
    const Pose pose = EvaluatePose(scene, selection, t);
    std::vector<glm::vec3> all;
    for (const DrawItem& item : BuildDrawItems(scene, pose, pose)) {
      for (const glm::vec3& p : item.deformed.positions) all.push_back(p);
    }
    return all;
  };
  const std::vector<glm::vec3> start = positions(0.0);
  const std::vector<glm::vec3> quarter = positions(0.25);
  const std::vector<glm::vec3> end = positions(1.9999);
  ASSERT_FALSE(start.empty());
  ASSERT_EQ(start.size(), end.size());
  float gap = 0.0f;
  float moved = 0.0f;
  for (std::size_t i = 0; i < start.size(); ++i) {
    gap = std::max(gap, glm::distance(start[i], end[i]));
    moved = std::max(moved, glm::distance(start[i], quarter[i]));
  }
  EXPECT_LT(gap, 2e-3f) << "the end meets the start";
  EXPECT_GT(moved, 0.1f) << "and a hand or a foot goes somewhere";
}

}  // namespace
}  // namespace burin::scene

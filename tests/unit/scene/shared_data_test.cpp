// SPDX-License-Identifier: Apache-2.0
// Real files of the shared collection, where it is there: what must be read is read, what must be refused is refused.

#include <algorithm>

#include "core/scene/pose.h"
#include "scene_fixture.h"

namespace burin::scene {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> GltfFiles(const std::string& folder, bool negative) {
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    const std::string path = entry.path().string();
    if (!path.ends_with(".gltf") && !path.ends_with(".glb")) continue;
    if ((path.find("/negative/") != std::string::npos) == negative) files.push_back(path);
  }
  std::sort(files.begin(), files.end());
  return files;
}

class SharedData : public ::testing::Test {
 protected:
  void SetUp() override {
    if (SharedData_().empty()) GTEST_SKIP() << "the shared data is not here";
  }
  static std::string SharedData_() { return scene::SharedData(); }
};

TEST_F(SharedData, EveryGoodFileIsReadAndPosed) {
  std::vector<std::string> files = GltfFiles(SharedData_() + "/gltf", false);
  for (const std::string& mesh : GltfFiles(SharedData_() + "/mesh", false)) files.push_back(mesh);
  ASSERT_GE(files.size(), 40u);
  for (const std::string& file : files) {
    SCOPED_TRACE(file);
    const Scene scene = ReadOrDie(file);
    const AnimationSelection selection = SelectAnimations(scene, "auto").value();
    const Pose pose = EvaluatePose(scene, selection, 0.4);
    const Bounds bounds = ComputeBounds(scene, BuildDrawItems(scene, pose, EvaluatePose(scene, selection, 0.3)));
    EXPECT_FALSE(bounds.empty());
    for (int c = 0; c < 3; ++c) {
      EXPECT_GT(bounds.min[c], -1e4f);
      EXPECT_LT(bounds.max[c], 1e4f);
    }
  }
}

TEST_F(SharedData, EveryBadFileIsRefused) {
  const std::vector<std::string> files = GltfFiles(SharedData_() + "/gltf/negative", true);
  ASSERT_GE(files.size(), 16u);
  for (const std::string& file : files) {
    const auto scene = ReadGltf(file, {});
    ASSERT_FALSE(scene) << file;
    EXPECT_EQ(scene.error().kind, ErrorKind::kInput);
    EXPECT_TRUE(scene.error().message.starts_with(file + ": ")) << scene.error().message;
  }
}

TEST_F(SharedData, CompressedFilesAreRefusedByExtension) {
  for (const std::string& file : GltfFiles(SharedData_() + "/draco", false)) {
    const auto scene = ReadGltf(file, {});
    ASSERT_FALSE(scene) << file;
    const bool meshopt = file.find("eshopt") != std::string::npos;
    EXPECT_NE(scene.error().message.find(meshopt ? "EXT_meshopt_compression" : "KHR_draco_mesh_compression"),
              std::string::npos)
        << scene.error().message;
  }
}

TEST_F(SharedData, KnownNumbers) {
  const Scene fox = ReadOrDie(SharedData_() + "/gltf/Fox.glb");
  ASSERT_EQ(fox.animations.size(), 3u);
  EXPECT_EQ(fox.animations[0].name, "Survey");
  EXPECT_EQ(fox.animations[1].name, "Walk");
  EXPECT_EQ(fox.animations[2].name, "Run");
  EXPECT_EQ(SelectAnimations(fox, "auto").value(), AnimationSelection{0}) << "all three move the same joints";
  EXPECT_EQ(fox.skins[0].joints.size(), 24u);
  EXPECT_TRUE(fox.meshes[0].primitives[0].flat_normals) << "the file has no normals";

  const Scene interpolation = ReadOrDie(SharedData_() + "/gltf/InterpolationTest/InterpolationTest.gltf");
  EXPECT_EQ(SelectAnimations(interpolation, "auto").value().size(), 9u) << "nine cubes, each moved by one animation";

  const Scene cubes = ReadOrDie(SharedData_() + "/gltf/many-cubes/many-cubes.gltf");
  const Pose pose = EvaluatePose(cubes, {}, 0.0);
  EXPECT_EQ(BuildDrawItems(cubes, pose, pose).size(), 501u);

  const Scene spot = ReadOrDie(SharedData_() + "/mesh/spot.glb");
  EXPECT_EQ(spot.meshes[0].primitives[0].indices.size() / 3, 5856u);
}

TEST_F(SharedData, TheTextureTransformTestsArrowsPointAtTheirMarks) {
  // The arrow's tip is at (0.7778, 0.7778) of its picture, where the mark "Not Supported" lies on an untransformed
  // square; the rotated arrow's mark "Correct" lies at (-0.0790, -0.5163) of a square whose texture starts at (-0.5,
  // 0.5).
  const Scene scene = ReadOrDie(SharedData_() + "/gltf/TextureTransformTest/TextureTransformTest.gltf");
  const TextureUse& rotated = scene.materials[3].base_color_texture;
  const glm::vec3 tip = rotated.uv_transform * glm::vec3(-0.0790f + 0.5f, 0.5f + 0.5163f, 1.0f);
  EXPECT_NEAR(tip.x, 0.7778f, 1e-3f);
  EXPECT_NEAR(tip.y, 0.7778f, 1e-3f);
}

}  // namespace
}  // namespace burin::scene

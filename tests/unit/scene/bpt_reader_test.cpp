// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "core/scene/read_scene.h"
#include "tests/unit/scene/scene_fixture.h"

namespace burin::scene {
namespace {

using testing::HasSubstr;

constexpr const char* kOneByTwo = "1\n1 2\n0 0 0\n0 1 0\n0 2 0\n1 0 0.5\n1 1 -0.0\n1 2 1e-3\n";

class Bpt : public testing::Test {
 protected:
  std::string ErrorOf(const std::string& text) {
    const std::string path = folder_.Write("m.bpt", text);
    const Result<Scene> scene = ReadScene(path, {});
    if (scene) return "no error";
    EXPECT_EQ(scene.error().kind, ErrorKind::kInput);
    EXPECT_TRUE(scene.error().message.starts_with(path + ": ")) << scene.error().message;
    return scene.error().message.substr(path.size() + 2);
  }
  TempFolder folder_;
};

TEST_F(Bpt, PointsAlongVComeFirst) {
  const auto scene = ReadScene(folder_.Write("m.bpt", kOneByTwo), {});
  ASSERT_TRUE(scene) << scene.error().message;
  const Primitive& primitive = scene->meshes.at(0).primitives.at(0);
  ASSERT_NE(primitive.patches, nullptr);
  const geometry::BezierPatch& patch = primitive.patches->patches.at(0);
  EXPECT_EQ(patch.position.u_order, 2);
  EXPECT_EQ(patch.position.v_order, 3);
  const std::vector<glm::vec4> expected = {{0, 0, 0, 1},    {1, 0, 0.5f, 1}, {0, 1, 0, 1},
                                           {1, 1, 0.0f, 1}, {0, 2, 0, 1},    {1, 2, 1e-3f, 1}};
  EXPECT_EQ(primitive.patches->positions, expected);
  EXPECT_FALSE(std::signbit(primitive.patches->positions[3].z));
  EXPECT_TRUE(scene->materials.at(0).double_sided);
}

TEST_F(Bpt, WithoutTessellationThereAreTwoTrianglesAPatch) {
  const auto scene = ReadScene(folder_.Write("m.bpt", kOneByTwo), {});
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->meshes[0].primitives[0].indices.size(), 6u);
}

TEST_F(Bpt, TakesTheMaterialBesideIt) {
  folder_.Write("m.mtl", "newmtl red\nKd 0.5 0.25 0.125\nnewmtl other\nKd 1 1 1\n");
  const auto scene = ReadScene(folder_.Write("m.bpt", kOneByTwo), {});
  ASSERT_TRUE(scene);
  ASSERT_EQ(scene->materials.size(), 1u);
  EXPECT_EQ(scene->materials[0].name, "red");
  EXPECT_EQ(scene->materials[0].base_color, glm::vec4(0.5f, 0.25f, 0.125f, 1.0f));
}

TEST_F(Bpt, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(ErrorOf(""), "line 0: found nothing, expected the number of patches");
  EXPECT_EQ(ErrorOf("x"), "line 1: found 'x', expected the number of patches");
  EXPECT_EQ(ErrorOf("-3"), "line 1: found '-3', expected the number of patches");
  EXPECT_EQ(ErrorOf("1\n0 3\n"), "line 2: patch 1: found '0' as the degree in u, expected 1 to 7");
  EXPECT_EQ(ErrorOf("1\n3 8\n"), "line 2: patch 1: found '8' as the degree in v, expected 1 to 7");
  EXPECT_EQ(ErrorOf("2\n1 1\n0 0 0 0 1 0 1 0 0 1 1 0\n"), "ends before patch 2; expected 2 patches");
  EXPECT_EQ(ErrorOf("1\n1 1\n0 0 0\n0 1 0\n1 0\n"), "ends in patch 1, point 3 of 4; expected 1 patch");
  EXPECT_EQ(ErrorOf("1\n1 1\n0 0 0\n0 nan 0\n1 0 0\n1 1 0\n"),
            "line 4: patch 1, point 2: found 'nan', expected a finite number");
  EXPECT_EQ(ErrorOf("1\n1 1\n0 0 0\n0 1 0\n1 0 0\n1 inf 0\n"),
            "line 6: patch 1, point 4: found 'inf', expected a finite number");
  EXPECT_EQ(ErrorOf("1\n1 1\n0 0 0\n0 1 0\n1 0 0\n1 1e39 0\n"),
            "line 6: patch 1, point 4: found '1e39', expected a finite number");
  EXPECT_EQ(ErrorOf("1\n1 1\n0 0 0\n0 1 0\n1 0 0\n1 1 0\n7"),
            "line 7: found '7' after the last of 1 patch, expected the end");
}

TEST_F(Bpt, ReadsTrianglesWeightsAndAttributes) {
  const std::string text =
      "2  # a comment\n"
      "rational 1 2\n"
      "0 0 0 1   0 1 0 0.5   0 2 0 1\n"
      "1 0 0 2   1 1 0 1     1 2 0 4\n"
      "texcoords 1 1  0 0  0 1  1 0  1 1\n"
      "colors 0 0  1 0.5 0.25 1\n"
      "triangle 2\n"
      "0 0 0  0 0.5 0  0 1 0  0.5 0 0  0.5 0.5 1  1 0 0\n"
      "normals 1  0 0 1  0 1 1  1 0 1\n";
  const auto scene = ReadScene(folder_.Write("m.bpt", text), {});
  ASSERT_TRUE(scene) << scene.error().message;
  const geometry::BezierPatches& patches = *scene->meshes.at(0).primitives.at(0).patches;
  ASSERT_EQ(patches.patches.size(), 2u);
  const geometry::BezierPatch &quad = patches.patches[0], &triangle = patches.patches[1];
  EXPECT_TRUE(quad.is_rational);
  EXPECT_EQ(patches.positions[4], glm::vec4(0, 2, 0, 1));
  EXPECT_EQ(patches.positions[2], glm::vec4(0, 0.5f, 0, 0.5f)) << "homogeneous";
  EXPECT_EQ(patches.positions[5], glm::vec4(4, 8, 0, 4)) << "homogeneous";
  EXPECT_EQ(patches.texcoords[0].at(quad.texcoord[0].first + 1), glm::vec2(1, 0));
  EXPECT_EQ(patches.colors.at(quad.color.first), glm::vec4(1, 0.5f, 0.25f, 1));
  EXPECT_EQ(triangle.domain, geometry::PatchDomain::kTriangle);
  EXPECT_FALSE(triangle.is_rational);
  // Points along v first: (0,0) (0,1) (0,2) (1,0) (1,1) (2,0), packed by rows of u.
  const std::uint32_t at = triangle.position.first;
  EXPECT_EQ(patches.positions[at + 1], glm::vec4(0.5f, 0, 0, 1));
  EXPECT_EQ(patches.positions[at + 2], glm::vec4(1, 0, 0, 1));
  EXPECT_EQ(patches.positions[at + 3], glm::vec4(0, 0.5f, 0, 1));
  EXPECT_EQ(patches.positions[at + 4], glm::vec4(0.5f, 0.5f, 1, 1));
  EXPECT_EQ(patches.positions[at + 5], glm::vec4(0, 1, 0, 1));
  EXPECT_EQ(patches.normals.at(triangle.normal.first + 1), glm::vec3(1, 0, 1));
}

TEST_F(Bpt, SaysWhatIsWrongWithWeightsAndAttributes) {
  const std::string flat = "1\n1 1\n0 0 0\n0 1 0\n1 0 0\n1 1 0\n";
  EXPECT_EQ(ErrorOf("1\nrational 4 1\n"),
            "line 2: patch 1: found '4' as the degree in u, expected 1 to 3 for a rational patch");
  EXPECT_EQ(ErrorOf("1\nrational 1 1\n0 0 0 1\n0 1 0 0\n1 0 0 1\n1 1 0 1\n"),
            "line 4: patch 1, point 2: the weight is 0, expected more than 0");
  EXPECT_EQ(ErrorOf("1\nrational 1 1\n0 0 0 1\n0 1 0 1\n1e38 0 0 1e3\n1 1 0 1\n"),
            "line 5: patch 1, point 3: its product with the weight 1000 is too large");
  EXPECT_EQ(ErrorOf("1\ntriangle 9\n"), "line 2: patch 1: found '9' as the degree, expected 1 to 7");
  EXPECT_EQ(ErrorOf(flat + "texcoords 1 1\n0 0 0 1 1\n"), "ends in patch 1, texcoords point 3 of 4; expected 1 patch");
  EXPECT_EQ(ErrorOf(flat + "colors 0 0 1 1 1 1\ncolors 0 0 1 1 1 1\n"), "line 8: patch 1: has colors twice");
  EXPECT_EQ(ErrorOf(flat + "colours 0 0 1 1 1 1\n"),
            "line 7: found 'colours' after the last of 1 patch, expected the end");
  EXPECT_EQ(ErrorOf("1\ntriangl 2\n"), "line 2: patch 1: found 'triangl' as the degree in u, expected 1 to 7");
}

TEST_F(Bpt, ACountWithoutPatchesEatsNoMemory) {
  EXPECT_EQ(ErrorOf("2000000000\n3 3\n0 0"), "ends in patch 1, point 1 of 16; expected 2000000000 patches");
}

TEST_F(Bpt, MissingFilesAndFoldersAreNamed) {
  const auto missing = ReadScene(folder_ / "none.bpt", {});
  ASSERT_FALSE(missing);
  EXPECT_THAT(missing.error().message, HasSubstr("none.bpt: cannot be opened: No such file"));
}

TEST(BptShared, TeapotsAndCupAreRead) {
  if (SharedData().empty()) GTEST_SKIP() << "no shared data";
  for (const auto& [name, patches] :
       {std::pair("teapot_28", 28u), std::pair("teapot_32", 32u), std::pair("teacup_26", 26u)}) {
    const auto scene = ReadScene(SharedData() + "/bezier/" + name + ".bpt", {});
    ASSERT_TRUE(scene) << scene.error().message;
    EXPECT_EQ(scene->meshes[0].primitives[0].patches->patches.size(), patches);
  }
}

}  // namespace
}  // namespace burin::scene

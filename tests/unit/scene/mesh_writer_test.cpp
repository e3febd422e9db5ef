// SPDX-License-Identifier: Apache-2.0
// Written meshes, read back by this project's own readers.
#include "core/scene/mesh_writer.h"

#include <gmock/gmock.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "core/scene/item_geometry.h"
#include "core/scene/read_scene.h"
#include "tests/unit/scene/scene_fixture.h"

namespace burin::scene {
namespace {

/// A triangle and a square; the square's node mirrors and moves it.
Scene Source() {
  Scene scene;
  Primitive triangle;
  triangle.positions = {{0.1f, 0, 0}, {1.0f / 3, 0, 1e-20f}, {0, 0.7f, 0}};
  triangle.normals.assign(3, glm::vec3(0, 0, 1));
  triangle.indices = {0, 1, 2};
  triangle.material = 0;
  Primitive square = triangle;
  square.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  square.normals.assign(4, glm::vec3(0, 0, 1));
  square.texcoords[0] = {{0, 0}, {1, 0}, {1, 1}, {0, 0.25f}};
  square.colors.assign(4, glm::vec4(0.5f, 0.25f, 1, 1));
  square.indices = {0, 1, 2, 0, 2, 3};
  Material red;
  red.name = "red paint";
  red.base_color = {1, 0, 0, 1};
  red.double_sided = true;
  scene.materials = {red};
  for (const Primitive& primitive : {triangle, square}) {
    Node node;
    node.name = "part";
    node.mesh = static_cast<int>(scene.meshes.size());
    scene.meshes.push_back({.name = "", .primitives = {primitive}, .weights = {}});
    scene.roots.push_back(static_cast<int>(scene.nodes.size()));
    scene.nodes.push_back(node);
  }
  scene.nodes[1].matrix =
      glm::scale(glm::translate(glm::mat4(1.0f), glm::vec3(2, 0, 0)), glm::vec3(-1.0f, 1.0f, 1.0f));
  return scene;
}

std::vector<DrawItem> ItemsOf(const Scene& scene) {
  const Pose pose = EvaluatePose(scene, {}, 0.0);
  return BuildDrawItems(scene, pose, pose);
}

std::string Written(MeshFormat format, const Scene& scene) {
  std::string bytes;
  const auto result = WriteMesh(format, scene, ItemsOf(scene), [&](std::span<const std::byte> piece) -> Result<void> {
    bytes.append(reinterpret_cast<const char*>(piece.data()), piece.size());
    return {};
  });
  EXPECT_TRUE(result);
  return bytes;
}

TEST(MeshWriter, AGlbIsTheSceneAgain) {
  const Scene source = Source();
  const TempFolder folder;
  const auto read = ReadScene(folder.Write("a.glb", Written(MeshFormat::kGlb, source)), {});
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->meshes.size(), 2u);
  for (std::size_t m = 0; m < 2; ++m) {
    const Primitive &a = source.meshes[m].primitives[0], &b = read->meshes[m].primitives[0];
    EXPECT_EQ(a.positions, b.positions);
    EXPECT_EQ(a.normals, b.normals);
    EXPECT_EQ(a.texcoords, b.texcoords);
    EXPECT_EQ(a.colors, b.colors);
    EXPECT_EQ(a.indices, b.indices);
  }
  EXPECT_EQ(read->nodes[1].matrix, source.nodes[1].matrix);
  EXPECT_EQ(read->materials[0].base_color, glm::vec4(1, 0, 0, 1));
  EXPECT_TRUE(read->materials[0].double_sided);
  EXPECT_THAT(read->warnings, testing::IsEmpty());
}

TEST(MeshWriter, AnObjHasTheWorldsPositionsAndFacesTheSameWay) {
  const Scene source = Source();
  const TempFolder folder;
  const auto read = ReadScene(folder.Write("a.obj", Written(MeshFormat::kObj, source)), {});
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->meshes.size(), 2u);
  EXPECT_EQ(read->meshes[0].primitives[0].positions, source.meshes[0].primitives[0].positions);
  const Primitive& square = read->meshes[1].primitives[0];
  EXPECT_EQ(square.texcoords[0][0], glm::vec2(0, 0));
  EXPECT_EQ(square.colors[0], glm::vec4(0.5f, 0.25f, 1, 1));
  for (std::size_t i = 0; i < square.indices.size(); i += 3) {
    const glm::vec3 a = square.positions[square.indices[i]];
    const glm::vec3 turn =
        glm::cross(square.positions[square.indices[i + 1]] - a, square.positions[square.indices[i + 2]] - a);
    EXPECT_GT(glm::dot(turn, square.normals[square.indices[i]]), 0.0f) << "mirrored, and its front still its front";
    EXPECT_GE(a.x, 1.0f);
  }
}

TEST(MeshWriter, APlyHoldsWhatItsHeaderSays) {
  const std::string bytes = Written(MeshFormat::kPly, Source());
  EXPECT_THAT(bytes, testing::StartsWith("ply\nformat binary_little_endian 1.0\nelement vertex 7\nproperty float x\n"));
  const std::size_t body = bytes.find("end_header\n") + 11;
  EXPECT_EQ(bytes.size() - body, 7u * 12 * 4 + 3 * 13);
  float z = 0.0f;
  std::memcpy(&z, &bytes[body + 12 * 4 + 8], 4);
  EXPECT_EQ(z, 1e-20f);
}

TEST(MeshWriter, TheSinksErrorIsTheResult) {
  const Scene source = Source();
  const auto result = WriteMesh(MeshFormat::kPly, source, ItemsOf(source), [](auto) -> Result<void> {
    return Fail(ErrorKind::kFailed, "disk full");
  });
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().message, "disk full");
}

TEST(MeshWriter, NothingIsAnError) {
  Scene source = Source();
  for (Mesh& mesh : source.meshes) mesh.primitives[0].indices.clear();
  const auto result =
      WriteMesh(MeshFormat::kObj, source, ItemsOf(source), [](auto) -> Result<void> { return {}; });
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().message, "no triangles to write");
}

}  // namespace
}  // namespace burin::scene

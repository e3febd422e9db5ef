// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <glm/geometric.hpp>

#include "core/scene/read_scene.h"
#include "tests/unit/scene/scene_fixture.h"

namespace burin::scene {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

class Obj : public testing::Test {
 protected:
  Scene Read(const std::string& text) {
    auto scene = ReadScene(folder_.Write("m.obj", text), {});
    EXPECT_TRUE(scene) << scene.error().message;
    return scene ? *std::move(scene) : Scene();
  }
  Primitive ReadPrimitive(const std::string& text) {
    const Scene scene = Read(text);
    return scene.meshes.empty() ? Primitive() : scene.meshes[0].primitives.at(0);
  }
  std::string ErrorOf(const std::string& text) {
    const std::string path = folder_.Write("m.obj", text);
    const Result<Scene> scene = ReadScene(path, {});
    if (scene) return "no error";
    EXPECT_EQ(scene.error().kind, ErrorKind::kInput);
    EXPECT_TRUE(scene.error().message.starts_with(path + ": ")) << scene.error().message;
    return scene.error().message.substr(path.size() + 2);
  }
  TempFolder folder_;
};

TEST_F(Obj, TrianglesKeepTheirCornersAndNormals) {
  const Primitive p = ReadPrimitive(std::string(kSquare) +
                                    "vt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 2\nf 1/1/1 2/2/1 3/3/1\nf -4//-1 -2//-1 -1//-1\n");
  EXPECT_EQ(p.indices.size(), 6u);
  EXPECT_EQ(p.positions[p.indices[1]], glm::vec3(1, 0, 0));
  EXPECT_EQ(p.positions[p.indices[5]], glm::vec3(0, 1, 0));
  EXPECT_EQ(p.normals[0], glm::vec3(0, 0, 1));
  EXPECT_EQ(p.texcoords[0][p.indices[2]], glm::vec2(1, 0)) << "v counts downwards in glTF";
  EXPECT_FALSE(p.has_made_normals);
  EXPECT_EQ(p.patches, nullptr);
}

TEST_F(Obj, ConcavePolygonsAreFilledOnce) {
  // An L: its area is 3 of 4.
  const Primitive p = ReadPrimitive("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5 6\n");
  ASSERT_EQ(p.indices.size(), 12u);
  float area = 0.0f;
  for (std::size_t i = 0; i < p.indices.size(); i += 3) {
    const glm::vec3 a = p.positions[p.indices[i]];
    const float z = glm::cross(p.positions[p.indices[i + 1]] - a, p.positions[p.indices[i + 2]] - a).z;
    EXPECT_GT(z, 0.0f);
    area += 0.5f * z;
  }
  EXPECT_FLOAT_EQ(area, 3.0f);
}

TEST_F(Obj, SmoothingGroupsShareNormalsAndFlatFacesDoNot) {
  const std::string roof = "v 0 0 0\nv 0 0 1\nv 1 1 0\nv 1 1 1\nv 2 0 0\nv 2 0 1\n";
  const Primitive smooth = ReadPrimitive(roof + "s 1\nf 1 2 4\nf 1 4 3\nf 3 4 6\nf 3 6 5\n");
  EXPECT_EQ(smooth.positions.size(), 6u);
  const Primitive flat = ReadPrimitive(roof + "s off\nf 1 2 4\nf 1 4 3\nf 3 4 6\nf 3 6 5\n");
  EXPECT_EQ(flat.positions.size(), 12u);
  EXPECT_TRUE(flat.has_made_normals);
  EXPECT_NEAR(glm::length(smooth.normals[2]), 1.0f, 1e-6f);
}

TEST_F(Obj, ObjectsAreNodesAndMaterialsPrimitives) {
  folder_.Write("m.mtl",
                "newmtl a\nKd 0.1 0.2 0.3\nNs 98\nnewmtl b\nKd 1 1 1\nd 0.25\nKe 2 0 0\nNi 1.4\nnewmtl c\nillum 0\n");
  const Scene scene = Read(std::string("mtllib m.mtl\n") + kSquare +
                           "o one\nusemtl a\nf 1 2 3\nusemtl b\nf 1 3 4\no two\nusemtl c\nf 1 2 4\nl 1 2 3\n");
  ASSERT_EQ(scene.nodes.size(), 2u);
  EXPECT_EQ(scene.nodes[0].name, "one");
  ASSERT_EQ(scene.meshes[0].primitives.size(), 2u);
  ASSERT_EQ(scene.meshes[1].primitives.size(), 2u);
  EXPECT_EQ(scene.meshes[1].primitives[1].mode, PrimitiveMode::kLines);
  EXPECT_THAT(scene.meshes[1].primitives[1].indices, ElementsAre(0, 1, 1, 2));
  const Material& a = scene.materials[static_cast<std::size_t>(scene.meshes[0].primitives[0].material)];
  EXPECT_EQ(a.base_color, glm::vec4(0.1f, 0.2f, 0.3f, 1.0f));
  EXPECT_FLOAT_EQ(a.roughness, std::pow(0.02f, 0.25f));
  EXPECT_EQ(a.metallic, 0.0f);
  const Material& b = scene.materials[static_cast<std::size_t>(scene.meshes[0].primitives[1].material)];
  EXPECT_EQ(b.alpha_mode, AlphaMode::kBlend);
  EXPECT_EQ(b.base_color.a, 0.25f);
  EXPECT_EQ(b.emissive, glm::vec3(2, 0, 0));
  EXPECT_EQ(b.ior, 1.4f);
  EXPECT_TRUE(scene.materials[static_cast<std::size_t>(scene.meshes[1].primitives[0].material)].unlit);
  EXPECT_THAT(scene.warnings, IsEmpty());
}

TEST_F(Obj, WhatIsMissingIsWarnedOf) {
  const Scene scene = Read(std::string("mtllib gone.mtl\n") + kSquare + "usemtl x\nf 1 2 3\n");
  ASSERT_EQ(scene.warnings.size(), 2u);
  EXPECT_THAT(scene.warnings[0], HasSubstr("mtllib gone.mtl: cannot be opened: No such file"));
  EXPECT_THAT(scene.warnings[1], HasSubstr("usemtl x: no mtllib has it, so it is plain"));
}

TEST_F(Obj, MaterialsOutsideTheFolderAreNotRead) {
  const Scene scene = Read(std::string("mtllib ../../etc/passwd\n") + kSquare + "f 1 2 3\n");
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_THAT(scene.warnings[0], HasSubstr("leaves the scene's folder"));
}

TEST_F(Obj, QuadsWithoutNormalsAreASubdivisionSurface) {
  const Primitive p = ReadPrimitive(std::string(kSquare) + "f 1 2 3 4\n");
  ASSERT_NE(p.patches, nullptr);
  EXPECT_EQ(p.patches->patches.size(), 16u);
  EXPECT_EQ(p.indices.size(), 6u) << "and without tessellation its own faces";
  EXPECT_EQ(ReadPrimitive(std::string(kSquare) + "vn 0 0 1\nf 1//1 2//1 3//1 4//1\n").patches, nullptr);
  EXPECT_EQ(ReadPrimitive(std::string(kSquare) + "f 1 2 3\n").patches, nullptr);
  EXPECT_NE(ReadPrimitive(std::string(kSquare) + "f 1 2 3\nt crease 2/1/0 0 1 2.5\n").patches, nullptr);
}

TEST_F(Obj, MaterialsOfASubdivisionSurfaceShareIt) {
  const Scene scene =
      Read("v 0 0 0\nv 1 0 0\nv 2 0 1\nv 0 1 0\nv 1 1 0\nv 2 1 1\nusemtl a\nf 1 2 5 4\nusemtl b\nf 2 3 6 5\n");
  ASSERT_EQ(scene.meshes[0].primitives.size(), 2u);
  for (const Primitive& p : scene.meshes[0].primitives) {
    ASSERT_NE(p.patches, nullptr);
    EXPECT_EQ(p.patches->patches.size(), 16u);
  }
}

TEST_F(Obj, LinesGoOnAfterABackslash) {
  EXPECT_EQ(ReadPrimitive(std::string(kSquare) + "f 1 2 \\\n 3\n").indices.size(), 3u);
}

TEST_F(Obj, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(ErrorOf(""), "has no faces, lines or points");
  EXPECT_EQ(ErrorOf("v 1 2\n"), "line 1: v: found nothing, expected a finite number");
  EXPECT_EQ(ErrorOf("v 1 nan 3\n"), "line 1: v: found 'nan', expected a finite number");
  EXPECT_EQ(ErrorOf("v 1 2 3\nvn 0 inf 0\n"), "line 2: vn: found 'inf', expected a finite number");
  EXPECT_EQ(ErrorOf("vt x\n"), "line 1: vt: found 'x', expected a finite number");
  EXPECT_EQ(ErrorOf(std::string(kSquare) + "f 1 2 5\n"), "line 5: f: vertex: index 5, but there are 4 so far");
  EXPECT_EQ(ErrorOf(std::string(kSquare) + "f 1 2 -5\n"), "line 5: f: vertex: index -5, but there are 4 so far");
  EXPECT_EQ(ErrorOf(std::string(kSquare) + "f 1 2 0\n"), "line 5: f: vertex: found '0', expected an index");
  EXPECT_EQ(ErrorOf(std::string(kSquare) + "f 1 2 x\n"), "line 5: f: vertex: found 'x', expected an index");
  EXPECT_EQ(ErrorOf(std::string(kSquare) + "vt 0 0\nf 1/1 2/2 3/1\n"),
            "line 6: f: texture coordinate: index 2, but there is 1 so far");
  EXPECT_EQ(ErrorOf(std::string(kSquare) + "f 1//1 2//1 3//1\n"), "line 5: f: normal: index 1, but there are 0 so far");
  EXPECT_EQ(ErrorOf(std::string(kSquare) + "f 1 2\n"), "line 5: f: found 2 corners, expected at least 3");
  EXPECT_EQ(ErrorOf(std::string(kSquare) + "l 1\n"), "line 5: l: found 1 corner, expected at least 2");
  EXPECT_EQ(ErrorOf("usemtl\n"), "line 1: usemtl: found nothing, expected a name");
  EXPECT_EQ(ErrorOf("s x\n"), "line 1: s: found 'x', expected a group's number or off");
  EXPECT_EQ(ErrorOf("t crease 2/1/0 0 1 2\n"), "line 1: t crease: found '0', expected a vertex below 0");
}

TEST_F(Obj, ErrorsInMaterialsNameTheirFile) {
  folder_.Write("m.mtl", "newmtl a\nKd red\n");
  const auto scene = ReadScene(folder_.Write("m.obj", std::string("mtllib m.mtl\n") + kSquare + "f 1 2 3\n"), {});
  ASSERT_FALSE(scene);
  EXPECT_THAT(scene.error().message, HasSubstr("m.mtl: line 2: Kd: found 'red', expected a finite number"));
}

TEST_F(Obj, FacesThatNoSurfaceCanHaveAreDrawnAsPolygons) {
  const Scene scene = Read(std::string(kSquare) + "f 1 1 1 1\n");
  ASSERT_EQ(scene.meshes.size(), 1u);
  for (const Primitive& p : scene.meshes[0].primitives) {
    for (const std::uint32_t index : p.indices) EXPECT_LT(index, p.positions.size());
  }
}

TEST(ObjShared, RealFilesAreRead) {
  if (SharedData().empty()) GTEST_SKIP() << "no shared data";
  const auto spot = ReadScene(SharedData() + "/mesh/spot.obj", {});
  ASSERT_TRUE(spot) << spot.error().message;
  EXPECT_EQ(spot->meshes[0].primitives[0].indices.size(), 3u * 5856u);
  const auto teapot = ReadScene(SharedData() + "/mesh/teapot_materialx.obj", {});
  ASSERT_TRUE(teapot) << teapot.error().message;
  EXPECT_EQ(teapot->meshes[0].primitives[0].indices.size(), 3u * 25200u);
}

}  // namespace
}  // namespace burin::scene

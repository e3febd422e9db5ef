// SPDX-License-Identifier: Apache-2.0

#include "core/scene/describe.h"

#include <nlohmann/json.hpp>

#include "scene_fixture.h"

namespace burin::scene {
namespace {

TEST(DescribeScene, SaysItToPeople) {
  Scene scene = ReadOrDie(DataPath("rig.glb"));
  scene.path = "rig.glb";
  EXPECT_EQ(DescribeScene(scene, false), R"(rig.glb: scene "rig"
  nodes: 7, skins: 1, images: 0
  bounds: -0.5 0 0 to 0.5 5 8
  meshes (1):
    0 "strip": 10 vertices, 8 triangles, 2 morph targets
  animations (3):
    0 "bend": 2.000 s, 2 channels
    1 "jump": 2.000 s, 2 channels
    2 "bend again": 2.000 s, 2 channels
)");
}

TEST(DescribeScene, SaysItToPrograms) {
  const Scene scene = ReadOrDie(DataPath("everything.gltf"));
  const nlohmann::json json = nlohmann::json::parse(DescribeScene(scene, true));
  EXPECT_EQ(json["name"], "everything");
  EXPECT_EQ(json["nodes"], 10);
  EXPECT_EQ(json["meshes"][0]["name"], "square");
  EXPECT_EQ(json["meshes"][0]["triangles"], 2);
  EXPECT_EQ(json["meshes"][0]["primitives"][0]["texcoords"], 2);
  EXPECT_EQ(json["meshes"][2]["primitives"][0]["material"], nullptr);
  EXPECT_EQ(json["materials"][0]["alpha_mode"], "mask");
  EXPECT_EQ(json["materials"][0]["images"]["normal"], 1);
  EXPECT_EQ(json["materials"][1]["images"]["base_color"], nullptr);
  EXPECT_EQ(json["cameras"][0]["zfar"], nullptr);
  EXPECT_EQ(json["cameras"][1]["zfar"], 11.0);
  EXPECT_EQ(json["lights"][2]["type"], "spot");
  EXPECT_EQ(json["bounds"]["max"][1], 26.0);
  EXPECT_EQ(json["warnings"].size(), 1u);
}

TEST(DescribeScene, TakesAnEmptyScene) {
  Scene scene;
  scene.path = "nothing.gltf";
  EXPECT_EQ(DescribeScene(scene, false),
            "nothing.gltf: scene (unnamed)\n  nodes: 0, skins: 0, images: 0\n  bounds: nothing is drawn\n");
  EXPECT_EQ(nlohmann::json::parse(DescribeScene(scene, true))["bounds"], nullptr);
}

}  // namespace
}  // namespace burin::scene

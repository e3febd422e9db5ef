// SPDX-License-Identifier: Apache-2.0
// What ReadGltf makes of the files of tests/data/scene (make_scenes.py says what is in them).

#include <gmock/gmock.h>

#include <cmath>
#include <glm/gtc/epsilon.hpp>
#include <glm/vec3.hpp>

#include "scene_fixture.h"

namespace burin::scene {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr float kTolerance = 1e-6f;  // a few roundings of values near 1

void ExpectNear(const glm::vec3& a, const glm::vec3& b) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], kTolerance) << c;
}

TEST(GltfReader, TurnsEveryModeIntoAList) {
  const Scene scene = ReadOrDie(DataPath("modes.glb"));
  ASSERT_EQ(scene.meshes.size(), 1u);
  const std::vector<Primitive>& p = scene.meshes[0].primitives;
  ASSERT_EQ(p.size(), 7u);
  EXPECT_EQ(p[0].mode, PrimitiveMode::kPoints);
  EXPECT_THAT(p[0].indices, ElementsAre(0, 1, 2, 3, 4));
  EXPECT_EQ(p[1].mode, PrimitiveMode::kLines);
  EXPECT_THAT(p[1].indices, ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(p[1].positions.size(), 4u) << "the fifth point is in no line";
  EXPECT_THAT(p[2].indices, ElementsAre(0, 1, 1, 2, 2, 3, 3, 4, 4, 0));
  EXPECT_THAT(p[3].indices, ElementsAre(0, 1, 1, 2, 2, 3, 3, 4));
  for (int mode = 4; mode < 7; ++mode) EXPECT_EQ(p[static_cast<std::size_t>(mode)].mode, PrimitiveMode::kTriangles);
  EXPECT_EQ(p[4].indices.size(), 3u);
  EXPECT_THAT(
      scene.warnings,
      ElementsAre(HasSubstr("primitives[1]: 5 indices are no whole number of lines; the last one is dropped"),
                  HasSubstr("primitives[4]: 5 indices are no whole number of triangles; the last two are dropped")));
}

TEST(GltfReader, KeepsTheWindingOfStripsAndFans) {
  const Scene scene = ReadOrDie(DataPath("modes.glb"));
  // The five points turn counter-clockwise in the z = 0 plane, strip and fan cover the same polygon: every flat normal
  // is +z.
  for (const std::size_t mode : {4u, 5u, 6u}) {
    const Primitive& p = scene.meshes[0].primitives[mode];
    EXPECT_TRUE(p.flat_normals);
    ASSERT_EQ(p.normals.size(), p.positions.size());
    EXPECT_EQ(p.positions.size(), p.indices.size()) << "flat normals share no vertices";
    for (const glm::vec3& normal : p.normals) ExpectNear(normal, {0, 0, 1});
  }
  const Primitive& fan = scene.meshes[0].primitives[6];
  ASSERT_EQ(fan.positions.size(), 9u);
  ExpectNear(fan.positions[0], {2, 0, 0});  // specification: p_i = {v_(i+1), v_(i+2), v_0}
  ExpectNear(fan.positions[1], {2, 1, 0});
  ExpectNear(fan.positions[2], {0, 0, 0});
}

TEST(GltfReader, ReadsMaterials) {
  const Scene scene = ReadOrDie(DataPath("everything.gltf"));
  ASSERT_EQ(scene.materials.size(), 2u);
  const Material& m = scene.materials[0];
  EXPECT_EQ(m.name, "full");
  EXPECT_EQ(m.base_color, glm::vec4(0.5f, 0.6f, 0.7f, 0.8f));
  EXPECT_EQ(m.metallic, 0.25f);
  EXPECT_EQ(m.roughness, 0.75f);
  EXPECT_EQ(m.emissive, glm::vec3(2.0f, 1.0f, 4.0f)) << "factor times strength";
  EXPECT_EQ(m.alpha_mode, AlphaMode::kMask);
  EXPECT_EQ(m.alpha_cutoff, 0.25f);
  EXPECT_TRUE(m.double_sided);
  EXPECT_EQ(m.normal_scale, 0.5f);
  EXPECT_EQ(m.occlusion_strength, 0.75f);
  EXPECT_EQ(m.ior, 1.25f);
  EXPECT_EQ(m.base_color_texture.image, 0);
  EXPECT_EQ(m.metallic_roughness_texture.image, 1);
  EXPECT_EQ(m.normal_texture.image, 1);
  EXPECT_EQ(m.normal_texture.texcoord, 1);
  EXPECT_EQ(m.base_color_texture.texcoord, 1) << "the transform's texCoord overrides";
  const TextureSampler& nearest = m.base_color_texture.sampler;
  EXPECT_EQ(nearest.mag, Filter::kNearest);
  EXPECT_EQ(nearest.min, Filter::kNearest);
  EXPECT_EQ(nearest.mip, Filter::kNearest);
  EXPECT_TRUE(nearest.mipmaps);
  EXPECT_EQ(nearest.wrap_s, Wrap::kClampToEdge);
  EXPECT_EQ(nearest.wrap_t, Wrap::kMirroredRepeat);
  EXPECT_FALSE(m.normal_texture.sampler.mipmaps);
  EXPECT_EQ(m.normal_texture.sampler.mag, Filter::kLinear);
  EXPECT_EQ(m.normal_texture.sampler.wrap_s, Wrap::kRepeat);
  EXPECT_TRUE(scene.materials[1].unlit);
  EXPECT_EQ(scene.materials[1].alpha_mode, AlphaMode::kBlend);
}

TEST(GltfReader, TransformsTextureCoordinates) {
  const Scene scene = ReadOrDie(DataPath("everything.gltf"));
  // Offset (0.5, 0.25), 90 degrees counter-clockwise as the image is seen, scale (2, 3): (1, 1) scales to (2, 3), turns
  // to (3, -2) (v is down), moves to (3.5, -1.75).
  const glm::vec3 uv = scene.materials[0].base_color_texture.uv_transform * glm::vec3(1.0f, 1.0f, 1.0f);
  ExpectNear(uv, {3.5f, -1.75f, 1.0f});
}

TEST(GltfReader, ReadsIntegerAttributesAsFractions) {
  const Scene scene = ReadOrDie(DataPath("everything.gltf"));
  const Primitive& square = scene.meshes[0].primitives[0];
  ASSERT_EQ(square.positions.size(), 4u);
  EXPECT_THAT(square.texcoords[0], ElementsAre(glm::vec2(0, 1), glm::vec2(1, 1), glm::vec2(1, 0), glm::vec2(0, 0)));
  EXPECT_EQ(square.texcoords[0], square.texcoords[1]);
  EXPECT_THAT(square.colors,
              ElementsAre(glm::vec4(0, 0, 0, 1), glm::vec4(1, 0, 0, 1), glm::vec4(0, 1, 0, 1), glm::vec4(0, 0, 1, 1)));
  const Primitive& quantised = scene.meshes[1].primitives[0];
  EXPECT_THAT(quantised.positions, ElementsAre(glm::vec3(-1, 0, 0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)));
}

TEST(GltfReader, AppliesSparseValues) {
  const Scene scene = ReadOrDie(DataPath("everything.gltf"));
  float highest = 0.0f;
  for (const glm::vec3& p : scene.meshes[2].primitives[0].positions) {
    highest = std::max(highest, p.y);
    EXPECT_EQ(p.y, p == glm::vec3(1, 5, 1) ? 5.0f : p == glm::vec3(2, 3, 2) ? 3.0f : 0.0f);
  }
  EXPECT_EQ(highest, 5.0f);
}

TEST(GltfReader, ReadsHierarchyCamerasAndLights) {
  const Scene scene = ReadOrDie(DataPath("everything.gltf"));
  EXPECT_EQ(scene.name, "everything");
  ASSERT_EQ(scene.nodes.size(), 10u);
  EXPECT_EQ(scene.nodes[0].parent, 1);
  EXPECT_EQ(scene.nodes[0].transform.scale, glm::vec3(-1, 1, 1));
  ASSERT_TRUE(scene.nodes[1].matrix.has_value());
  EXPECT_EQ((*scene.nodes[1].matrix)[3], glm::vec4(10, 20, 30, 1));
  EXPECT_EQ(scene.nodes[3].parent, kNone);
  EXPECT_THAT(scene.roots, ElementsAre(1, 2, 4, 5, 6, 7, 8, 9)) << "the hidden node is in no scene";
  ASSERT_EQ(scene.cameras.size(), 3u);
  EXPECT_FALSE(scene.cameras[0].zfar.has_value());
  EXPECT_EQ(scene.cameras[1].zfar, 11.0f);
  EXPECT_EQ(scene.cameras[1].aspect_ratio, 2.0f);
  EXPECT_TRUE(scene.cameras[2].orthographic);
  EXPECT_EQ(scene.cameras[2].ymag, 3.0f);
  ASSERT_EQ(scene.lights.size(), 3u);
  EXPECT_EQ(scene.lights[0].intensity, 3.0f);
  EXPECT_EQ(scene.lights[0].color, glm::vec3(1.0f));
  EXPECT_EQ(scene.lights[1].type, LightType::kPoint);
  EXPECT_EQ(scene.lights[1].range, 7.5f);
  EXPECT_EQ(scene.lights[2].inner_cone_rad, 0.25f);
  EXPECT_NEAR(scene.lights[2].outer_cone_rad, 0.785398163f, kTolerance);
  EXPECT_EQ(scene.nodes[7].light, 0);
  EXPECT_EQ(scene.nodes[9].light, 2);
}

TEST(GltfReader, WarnsOfIgnoredExtensionsOnce) {
  const std::string path = DataPath("everything.gltf");
  EXPECT_THAT(ReadOrDie(path).warnings, ElementsAre(path + ": the extension EXT_made_up is ignored"));
}

TEST(GltfReader, MakesTangentsForNormalMaps) {
  const Scene scene = ReadOrDie(DataPath("everything.gltf"));
  const Primitive& square = scene.meshes[0].primitives[0];
  ASSERT_EQ(square.tangents.size(), 4u);
  // u grows along +x, the image's up is +y: w = 1 so that cross(n, t) * w is +y.
  for (const glm::vec4& tangent : square.tangents) EXPECT_EQ(tangent, glm::vec4(1, 0, 0, 1));
  EXPECT_TRUE(scene.meshes[1].primitives[0].tangents.empty());
}

TEST(GltfReader, ReadsSkinsWithEightJointsAVertex) {
  const Scene scene = ReadOrDie(DataPath("rig.glb"));
  ASSERT_EQ(scene.skins.size(), 1u);
  EXPECT_THAT(scene.skins[0].joints, ElementsAre(0, 1, 2, 3, 4));
  EXPECT_EQ(scene.skins[0].inverse_bind_matrices[3][3], glm::vec4(0, -3, 0, 1));
  const Primitive& strip = scene.meshes[0].primitives[0];
  EXPECT_EQ(strip.joints[0][8], glm::u16vec4(4, 3, 0, 0)) << "joint 99 has no weight";
  EXPECT_EQ(strip.weights[0][8], glm::vec4(0.75f, 0.25f, 0, 0));
  EXPECT_EQ(strip.weights[0][0], glm::vec4(0.5f, 0, 0, 0));
  EXPECT_EQ(strip.joints[1][0], glm::u16vec4(0, 1, 0, 0));
  EXPECT_EQ(strip.weights[1][0], glm::vec4(0.25f, 0.25f, 0, 0));
}

TEST(GltfReader, ReadsMorphTargetsSparseWithoutAView) {
  const Scene scene = ReadOrDie(DataPath("rig.glb"));
  const Primitive& strip = scene.meshes[0].primitives[0];
  ASSERT_EQ(strip.targets.size(), 2u);
  EXPECT_EQ(strip.targets[0].positions[7], glm::vec3(0));
  EXPECT_EQ(strip.targets[0].positions[8], glm::vec3(0, 1, 0));
  EXPECT_EQ(strip.targets[0].positions[9], glm::vec3(0, 2, 0));
  EXPECT_TRUE(strip.targets[0].normals.empty());
  EXPECT_EQ(strip.targets[1].normals[0], glm::vec3(1, 0, -1));
  EXPECT_THAT(scene.meshes[0].weights, ElementsAre(0.5f, 0.0f));
  EXPECT_THAT(scene.nodes[6].weights, ElementsAre(0.0f, 1.0f));
}

TEST(GltfReader, ReadsAnimations) {
  const Scene scene = ReadOrDie(DataPath("rig.glb"));
  ASSERT_EQ(scene.animations.size(), 3u);
  EXPECT_EQ(scene.animations[1].name, "jump");
  EXPECT_EQ(scene.animations[1].duration_s, 2.0f);
  ASSERT_EQ(scene.animations[1].channels.size(), 2u);
  const AnimationChannel& cubic = scene.animations[1].channels[1];
  EXPECT_EQ(cubic.interpolation, Interpolation::kCubicSpline);
  EXPECT_EQ(cubic.path, AnimationPath::kScale);
  EXPECT_THAT(cubic.times, ElementsAre(0.5f, 1.0f, 2.0f));
  EXPECT_EQ(cubic.values.size(), 27u);
  EXPECT_EQ(scene.animations[0].channels[1].components, 2);
}

TEST(GltfReader, SurvivesAVeryDeepHierarchy) {
  constexpr int kDepth = 100'000;
  std::string nodes = R"([{"mesh":0,"children":[1],"translation":[0,0,1]})";
  for (int i = 1; i < kDepth; ++i) {
    nodes += ",{\"translation\":[1,0,0]" +
             (i + 1 < kDepth ? ",\"children\":[" + std::to_string(i + 1) + "]}" : std::string("}"));
  }
  const TempFolder folder;
  folder.Write("triangle.bin", TriangleBin());
  const Scene scene = ReadOrDie(folder.Write("deep.gltf", Edited(TriangleText(), {{R"([{"mesh":0}])", nodes + "]"}})));
  EXPECT_EQ(scene.nodes.size(), static_cast<std::size_t>(kDepth));
}

TEST(GltfReader, ShowsEveryNodeWithoutAScene) {
  const TempFolder folder;
  folder.Write("triangle.bin", TriangleBin());
  const Scene scene =
      ReadOrDie(folder.Write("library.gltf", Edited(TriangleText(), {{R"("scene":0,"scenes":[{"nodes":[0]}],)", ""}})));
  EXPECT_THAT(scene.roots, ElementsAre(0));
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("has no scene: every node is shown")));
}

TEST(GltfReader, KeepsTheLastOfKeysAtOneTime) {
  const TempFolder folder;
  folder.Write("triangle.bin", BytesOf<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}) +
                                   BytesOf<float>({1, 0, 1, 0, 0, 1, 0, 1, 1}) + BytesOf<std::uint16_t>({0, 1, 1, 0}));
  const Scene scene = ReadOrDie(folder.Write(
      "keys.gltf",
      Edited(TriangleText(),
             {{R"(,"indices":2)", ""}, {R"("scene":0)", R"("scene":0,"animations":[{"samplers":[{"input":2,"output":1}],
                                            "channels":[{"sampler":0,"target":{"node":0,"path":"translation"}}]}])"}})));
  ASSERT_EQ(scene.animations.size(), 1u);
  EXPECT_EQ(scene.animations[0].channels[0].times.size(), 2u);
  EXPECT_THAT(scene.animations[0].channels[0].values, ElementsAre(1, 0, 1, 0, 1, 1));
}

}  // namespace
}  // namespace burin::scene

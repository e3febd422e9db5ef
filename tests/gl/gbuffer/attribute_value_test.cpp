// SPDX-License-Identifier: Apache-2.0
// Attributes at known pixels of scenes whose geometry is known in closed form.
#include <gmock/gmock.h>

#include "tests/gl/gbuffer/scene_fixture.h"

namespace burin::gbuffer {
namespace {

using testing::ElementsAre;
using testing::FloatNear;
using testing::Pointwise;

// Rasterizers interpolate in binary32 and snap vertices to 1/256 of a pixel.
constexpr float kInterpolation = 2e-3f;

auto Near(std::vector<float> values, float tolerance = 1e-5f) { return Pointwise(FloatNear(tolerance), values); }

class AttributeValue : public GbufferTest {
 protected:
  // A square that fills the frame of 8 x 4 pixels, 5 away.
  static TestScene Wall() {
    TestScene test;
    scene::Material material;
    material.base_color = {0.25f, 0.5f, 0.75f, 1.0f};
    material.emissive = {0.1f, 0.2f, 3.0f};
    material.roughness = 0.6f;
    material.metallic = 0.3f;
    scene::Primitive square = Square(test.AddMaterial(material));
    square.texcoords[1] = {{1, 0}, {0, 0}, {1, 1}, {0, 1}};
    square.tangents.assign(4, {1, 0, 0, 1});
    test.AddNode(test.AddMesh(square), Translate(0, 0, -5));
    return test;
  }
  std::vector<float> WallAt(Attribute attribute, int x, int y) {
    return Render(Wall(), Orthographic(), attribute, Float(), 8, 4).At(x, y);
  }
};

TEST_F(AttributeValue, DepthIsLinear) { EXPECT_THAT(WallAt(Attribute::kDepth, 3, 2), Near({5, 5, 5, 1})); }

TEST_F(AttributeValue, ZbufferIsDirect3Ds) {
  EXPECT_THAT(WallAt(Attribute::kZbuffer, 3, 2), Near({0.5f, 0.5f, 0.5f, 1}));
}

TEST_F(AttributeValue, PerspectiveZbufferIsZOverW) {
  TestScene test;
  test.AddNode(test.AddMesh(Square()), Translate(0, 0, -5) * glm::scale(glm::mat4(1.0f), glm::vec3(10)));
  for (const float zfar : {6.0f, 50.0f, 1e7f}) {
    const double n = 0.5, f = zfar, z = 5.0;
    const double expected = f * (z - n) / (z * (f - n));  // D3DXMatrixPerspectiveFovRH
    EXPECT_THAT(Render(test, Perspective(0.8f, 1.0f, 0.5f, zfar), Attribute::kZbuffer, Float(), 4, 4).At(1, 1)[0],
                FloatNear(static_cast<float>(expected), 1e-6f))
        << zfar;
  }
}

TEST_F(AttributeValue, InfiniteProjectionsWork) {
  TestScene test;
  test.AddNode(test.AddMesh(Square()), Translate(0, 0, -5) * glm::scale(glm::mat4(1.0f), glm::vec3(10)));
  scene::View view;
  view.clip_from_view = glm::mat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, -1, 0, 0, -0.5f, 0);
  view.znear = 0.5f;
  view.zfar = std::numeric_limits<float>::infinity();
  EXPECT_THAT(Render(test, view, Attribute::kZbuffer, Float(), 4, 4).At(1, 1)[0], FloatNear(0.9f, 1e-6f));
  EXPECT_THAT(Render(test, view, Attribute::kDepth, Float(), 4, 4).At(1, 1)[0], FloatNear(5.0f, 1e-5f));
}

TEST_F(AttributeValue, SurfacesFarAwayKeepTheirOrder) {
  TestScene test;
  test.AddNode(test.AddMesh(Square()), Translate(0, 0, -9000.0f) * glm::scale(glm::mat4(1.0f), glm::vec3(9000)));
  test.AddNode(0, Translate(0, 0, -9001.0f) * glm::scale(glm::mat4(1.0f), glm::vec3(9000)));
  EXPECT_EQ(Render(test, Perspective(0.8f, 1.0f, 0.01f, 1e5f), Attribute::kObjectId, Float(), 4, 4).At(1, 1)[0], 1.0f);
}

TEST_F(AttributeValue, NormalAndTangentAreUnitWorldVectors) {
  EXPECT_THAT(WallAt(Attribute::kNormal, 1, 1), Near({0, 0, 1, 1}));
  EXPECT_THAT(WallAt(Attribute::kViewNormal, 1, 1), Near({0, 0, 1, 1}));
  EXPECT_THAT(WallAt(Attribute::kTangent, 1, 1), Near({1, 0, 0, 1}));
}

TEST_F(AttributeValue, ViewNormalTurnsWithTheCamera) {
  // The camera looks along -x: what faces +x comes towards it.
  TestScene test;
  test.AddNode(test.AddMesh(Square()),
               Translate(-5, 0, 0) * glm::rotate(glm::mat4(1.0f), glm::half_pi<float>(), {0, 1, 0}));
  scene::View view = Orthographic();
  view.view_from_world = glm::lookAtRH(glm::vec3(0), glm::vec3(-1, 0, 0), glm::vec3(0, 1, 0));
  EXPECT_THAT(Render(test, view, Attribute::kNormal, Float(), 8, 4).At(4, 2), Near({1, 0, 0, 1}));
  EXPECT_THAT(Render(test, view, Attribute::kViewNormal, Float(), 8, 4).At(4, 2), Near({0, 0, 1, 1}));
}

TEST_F(AttributeValue, TangentFollowsTheTextureCoordinatesWhereTheMeshHasNone) {
  TestScene test;
  scene::Primitive square = Square();
  square.texcoords[0] = {{0, 0}, {0, 1}, {1, 0}, {1, 1}};  // u grows downwards
  test.AddNode(test.AddMesh(square), Translate(0, 0, -5));
  EXPECT_THAT(Render(test, Orthographic(), Attribute::kTangent, Float(), 8, 8).At(3, 3), Near({0, -1, 0, 1}, 1e-4f));
}

TEST_F(AttributeValue, PositionsAreOfThePixelsCentre) {
  // 8 x 4 pixels over -1..1 in both directions.
  EXPECT_THAT(WallAt(Attribute::kPosition, 0, 0), Near({-0.875f, 0.75f, -5, 1}, kInterpolation));
  EXPECT_THAT(WallAt(Attribute::kPosition, 7, 3), Near({0.875f, -0.75f, -5, 1}, kInterpolation));
  EXPECT_THAT(WallAt(Attribute::kViewPosition, 5, 1), Near({0.375f, 0.25f, -5, 1}, kInterpolation));
  EXPECT_THAT(WallAt(Attribute::kScreenPosition, 5, 1), Near({5.5f, 1.5f, 0, 1}));
}

TEST_F(AttributeValue, TexcoordsAreTheFilesOwn) {
  EXPECT_THAT(WallAt(Attribute::kTexcoord, 0, 0), Near({0.0625f, 0.125f, 0, 1}, kInterpolation));
  EXPECT_THAT(WallAt(Attribute::kTexcoord1, 0, 0), Near({0.9375f, 0.125f, 0, 1}, kInterpolation));
}

TEST_F(AttributeValue, MaterialsNumbersComeThrough) {
  EXPECT_THAT(WallAt(Attribute::kAlbedo, 2, 2), Near({0.25f, 0.5f, 0.75f, 1}));
  EXPECT_THAT(WallAt(Attribute::kEmissive, 2, 2), Near({0.1f, 0.2f, 3.0f, 1}));
  EXPECT_THAT(WallAt(Attribute::kRoughness, 2, 2), Near({0.6f, 0.6f, 0.6f, 1}));
  EXPECT_THAT(WallAt(Attribute::kMetallic, 2, 2), Near({0.3f, 0.3f, 0.3f, 1}));
  EXPECT_THAT(WallAt(Attribute::kVertexColor, 2, 2), Near({1, 1, 1, 1}));
  EXPECT_THAT(WallAt(Attribute::kAlpha, 2, 2), Near({1, 1, 1, 1}));
}

TEST_F(AttributeValue, IdsCountFromOne) {
  EXPECT_THAT(WallAt(Attribute::kObjectId, 2, 2), ElementsAre(1, 1, 1, 1));
  EXPECT_THAT(WallAt(Attribute::kMaterialId, 2, 2), ElementsAre(1, 1, 1, 1));
  EXPECT_THAT(WallAt(Attribute::kPrimitiveId, 0, 0), ElementsAre(1, 1, 1, 1));
  EXPECT_THAT(WallAt(Attribute::kPrimitiveId, 7, 3), ElementsAre(2, 2, 2, 1));
  EXPECT_THAT(WallAt(Attribute::kFacing, 2, 2), ElementsAre(1, 1, 1, 1));
}

TEST_F(AttributeValue, LightDepthIsMeasuredFromTheKeyLight) {
  TestScene test = Wall();
  scene::Light light;
  light.type = scene::LightType::kPoint;
  test.AddLight(light, Translate(0.125f, 0.25f, -2));  // before the centre of pixel (4, 1)
  EXPECT_THAT(Render(test, Orthographic(), Attribute::kLightDepth, Float(), 8, 4).At(4, 1)[0],
              FloatNear(3.0f, kInterpolation));
  const float dx = 0.25f;  // one pixel to the side: a point light measures the distance, a spot light along its axis
  EXPECT_THAT(Render(test, Orthographic(), Attribute::kLightDepth, Float(), 8, 4).At(5, 1)[0],
              FloatNear(std::sqrt(9.0f + dx * dx), kInterpolation));
  test.scene.lights[0].type = scene::LightType::kSpot;
  EXPECT_THAT(Render(test, Orthographic(), Attribute::kLightDepth, Float(), 8, 4).At(5, 1)[0],
              FloatNear(3.0f, kInterpolation));
  test.scene.lights[0].type = scene::LightType::kDirectional;
  EXPECT_THAT(Render(test, Orthographic(), Attribute::kLightDepth, Float(), 8, 4).At(0, 0)[0],
              FloatNear(3.0f, kInterpolation));
}

TEST_F(AttributeValue, ATiltedPlaneInPerspectiveMatchesItsRays) {
  // The plane through (0, 0, -6) with normal (0.6, 0, 0.8).
  const glm::vec3 normal(0.6f, 0.0f, 0.8f);
  TestScene test;
  test.AddNode(test.AddMesh(Square()), Translate(0, 0, -6) *
                                           glm::rotate(glm::mat4(1.0f), std::atan2(0.6f, 0.8f), {0, 1, 0}) *
                                           glm::scale(glm::mat4(1.0f), glm::vec3(20)));
  constexpr int kWidth = 60, kHeight = 40;
  const float yfov = 0.9f, aspect = 1.5f;
  const scene::View view = Perspective(yfov, aspect);
  const Picture depth = Render(test, view, Attribute::kDepth, Float(), kWidth, kHeight);
  const Picture position = Render(test, view, Attribute::kPosition, Float(), kWidth, kHeight);
  const Picture normals = Render(test, view, Attribute::kNormal, Float(), kWidth, kHeight);
  for (const auto& [x, y] : {std::pair(3, 5), std::pair(30, 20), std::pair(55, 37)}) {
    const float sx = (2.0f * (static_cast<float>(x) + 0.5f) / kWidth - 1.0f) * std::tan(yfov / 2) * aspect;
    const float sy = (1.0f - 2.0f * (static_cast<float>(y) + 0.5f) / kHeight) * std::tan(yfov / 2);
    const glm::vec3 ray(sx, sy, -1.0f);
    const float t = glm::dot(normal, glm::vec3(0, 0, -6)) / glm::dot(normal, ray);
    EXPECT_THAT(depth.At(x, y)[0], FloatNear(t, kInterpolation * t)) << x << " " << y;
    EXPECT_THAT(position.At(x, y), Near({sx * t, sy * t, -t, 1}, kInterpolation * t));
    EXPECT_THAT(normals.At(x, y), Near({0.6f, 0, 0.8f, 1}, 1e-4f));
  }
}

TEST_F(AttributeValue, ASpheresNormalsMatchItsRays) {
  TestScene test;
  const glm::vec3 center(0.2f, -0.1f, -4.0f);
  test.AddNode(test.AddMesh(Sphere()), Translate(center.x, center.y, center.z));
  constexpr int kSize = 64;
  const float yfov = 0.7f;
  const Picture normals = Render(test, Perspective(yfov, 1.0f), Attribute::kNormal, Float(), kSize, kSize);
  int hits = 0;
  for (int y = 0; y < kSize; y += 7) {
    for (int x = 0; x < kSize; x += 7) {
      const float sx = (2.0f * (static_cast<float>(x) + 0.5f) / kSize - 1.0f) * std::tan(yfov / 2);
      const float sy = (1.0f - 2.0f * (static_cast<float>(y) + 0.5f) / kSize) * std::tan(yfov / 2);
      const glm::vec3 ray = glm::normalize(glm::vec3(sx, sy, -1.0f));
      const float b = glm::dot(ray, center);
      const float discriminant = b * b - glm::dot(center, center) + 1.0f;
      if (discriminant < 0.05f) continue;  // near the silhouette the facets show
      const glm::vec3 n = ray * (b - std::sqrt(discriminant)) - center;
      EXPECT_THAT(normals.At(x, y), Near({n.x, n.y, n.z, 1}, 0.01f)) << x << " " << y;
      ++hits;
    }
  }
  EXPECT_GT(hits, 20);
}

TEST_F(AttributeValue, MirroredObjectsShowTheirFronts) {
  TestScene test;
  scene::Primitive square = Square();
  square.normals.assign(4, glm::normalize(glm::vec3(1, 0, 2)));
  test.AddNode(test.AddMesh(square), Translate(0, 0, -5) * glm::scale(glm::mat4(1.0f), glm::vec3(-1, 1, 1)));
  const glm::vec3 n = glm::normalize(glm::vec3(-1, 0, 2));
  EXPECT_THAT(Render(test, Orthographic(), Attribute::kNormal, Float(), 8, 4).At(2, 2), Near({n.x, n.y, n.z, 1}));
  EXPECT_THAT(Render(test, Orthographic(), Attribute::kFacing, Float(), 8, 4).At(2, 2)[0], 1.0f);
}

TEST_F(AttributeValue, FlattenedObjectsKeepTheirNormals) {
  TestScene test;
  test.AddNode(test.AddMesh(Square()), Translate(0, 0, -5) * glm::scale(glm::mat4(1.0f), glm::vec3(1, 1, 0)));
  EXPECT_THAT(Render(test, Orthographic(), Attribute::kNormal, Float(), 8, 4).At(2, 2), Near({0, 0, 1, 1}));
}

TEST_F(AttributeValue, NormalsStandUprightUnderUnevenScale) {
  TestScene test;
  scene::Primitive square = Square();
  square.normals.assign(4, glm::normalize(glm::vec3(1, 1, 1)));
  test.AddNode(test.AddMesh(square), Translate(0, 0, -5) * glm::scale(glm::mat4(1.0f), glm::vec3(1, 2, 4)));
  const glm::vec3 n = glm::normalize(glm::vec3(1.0f, 0.5f, 0.25f));
  EXPECT_THAT(Render(test, Orthographic(), Attribute::kNormal, Float(), 8, 4).At(2, 2), Near({n.x, n.y, n.z, 1}));
}

TEST_F(AttributeValue, BacksShowOnDoubleSidedMaterialsOnly) {
  const glm::mat4 turned = Translate(0, 0, -5) * glm::rotate(glm::mat4(1.0f), glm::pi<float>(), {0, 1, 0});
  TestScene test;
  scene::Material material;
  test.AddNode(test.AddMesh(Square(test.AddMaterial(material))), turned);
  EXPECT_THAT(Render(test, Orthographic(), Attribute::kFacing, Float(), 8, 4).At(2, 2), ElementsAre(0, 0, 0, 0));
  test.scene.materials[0].double_sided = true;
  EXPECT_THAT(Render(test, Orthographic(), Attribute::kFacing, Float(), 8, 4).At(2, 2), ElementsAre(-1, -1, -1, 1));
  // The normal turns to the side that is seen.
  EXPECT_THAT(Render(test, Orthographic(), Attribute::kNormal, Float(), 8, 4).At(2, 2), Near({0, 0, 1, 1}));
}

TEST_F(AttributeValue, ANormalMapBendsTheNormalInTangentSpace) {
  TestScene test;
  scene::Material material;
  material.normal_texture.image = 0;
  // (0.6, 0, 0.8) in 8 bits: 204, 127.5, 230.
  test.scene.images.push_back(gl::MakeImage<std::uint8_t>(1, 1, 3, image::SampleType::kU8, [](std::size_t i) {
    return std::array{204, 128, 230}[i];
  }));
  scene::Primitive square = Square(test.AddMaterial(material));
  square.tangents.assign(4, {0, 1, 0, 1});  // up: the bitangent is to the left
  test.AddNode(test.AddMesh(square), Translate(0, 0, -5));
  EXPECT_THAT(Render(test, Orthographic(), Attribute::kNormal, Float(), 8, 4).At(2, 2),
              Near({0, 0.6f, 0.8f, 1}, 0.01f));
  test.scene.materials[0].normal_scale = 0.0f;
  EXPECT_THAT(Render(test, Orthographic(), Attribute::kNormal, Float(), 8, 4).At(2, 2), Near({0, 0, 1, 1}, 0.01f));
}

}  // namespace
}  // namespace burin::gbuffer

// SPDX-License-Identifier: Apache-2.0
// --edges resolve, against exact areas.
#include <epoxy/gl.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <random>

#include "tests/gl/overdraw/edge_fixture.h"
#include "tests/support/triangle_mesh.h"

namespace burin::overdraw {
namespace {

constexpr int kSize = 64;
constexpr int kAngles = 12;
constexpr float kBloat = 0.01f;       // px, what the mode promises
constexpr float kAreaError = 0.002f;  // of one pixel on a straight edge
constexpr float kRounding = 1e-5f;
constexpr float kStep8 = 1.0f / 255.0f;

/// Over the whole turn; no two see the grid alike.
float AngleOf(int i) { return 2 * kPi * (static_cast<float>(i) + 0.13f) / kAngles; }
float OffsetOf(int i) { return 0.37f * static_cast<float>(i) - 2.0f; }

class Resolve : public EdgeTest {
 protected:
  Resolve() { background_ = {0, 0, 0, 1}; }

  Picture Resolved(const TestScene& test, const scene::View& view = Orthographic()) {
    return DrawOne(test, view, EdgeMode::kResolve, kSize, kSize);
  }
  Picture Plain(const TestScene& test, const scene::View& view = Orthographic()) {
    return DrawOne(test, view, EdgeMode::kOff, kSize, kSize);
  }
  /// Mean and largest error of red against the plane's areas, and what is changed off the edge.
  /// Pixels at the frame's border may have no neighbour across the edge.
  void ExpectAreas(const Picture& picture, const HalfPlane& plane) {
    constexpr int margin = 1;
    double sum = 0, length = 0;
    for (int y = margin; y < kSize - margin; ++y) {
      for (int x = margin; x < kSize - margin; ++x) {
        const double value = picture.At(x, y)[0], area = plane.Area(x, y);
        ASSERT_NEAR(value, area, kAreaError) << x << " " << y;
        if (std::abs(plane.Distance(x, y)) > plane.Extent() + 1e-3) {
          ASSERT_EQ(value, area > 0.5 ? 1.0 : 0.0) << "off the edge, " << x << " " << y;
        }
        sum += value - area;
        length += std::abs(plane.Distance(x, y)) < 0.5;  // a band of one pixel
      }
    }
    ASSERT_GT(length, kSize / 3);
    EXPECT_LT(std::abs(sum / length), kBloat);
  }
};

TEST_F(Resolve, AnEdgesPixelsHoldTheAreaThatItsSurfaceCoversAtEveryAngle) {
  for (int i = 0; i < kAngles; ++i) {
    SCOPED_TRACE(i);
    ExpectAreas(Resolved(Edge(AngleOf(i), OffsetOf(i), kSize)), PlaneOf(AngleOf(i), OffsetOf(i), kSize));
  }
}

TEST_F(Resolve, EdgesAlongTheGridAndItsDiagonalsHoldTheirAreasToo) {
  for (int i = 0; i < 8; ++i) {
    SCOPED_TRACE(i);
    const float angle = kPi / 4 * static_cast<float>(i);
    for (const float offset : {-0.4f, -0.1f, 0.2f, 0.45f})
      ExpectAreas(Resolved(Edge(angle, offset, kSize)), PlaneOf(angle, offset, kSize));
  }
}

TEST_F(Resolve, AnEdgeOfManyShortPiecesIsStraight) {
  // A sheet whose edge is cut into pieces of 0.3 pixels.
  TestScene test;
  scene::Primitive sheet;
  constexpr int kPieces = 427;
  for (int i = 0; i <= kPieces; ++i) {
    const float y = -1 + 2 * static_cast<float>(i) / kPieces;
    sheet.positions.insert(sheet.positions.end(), {{-1, y, 0}, {1, y, 0}});
    if (i == 0) continue;
    const auto k = static_cast<std::uint32_t>(2 * i);
    sheet.indices.insert(sheet.indices.end(), {k - 2, k - 1, k, k, k - 1, k + 1});
  }
  sheet.normals.assign(sheet.positions.size(), {0, 0, 1});
  sheet.material = test.AddMaterial(Unlit({1, 1, 1, 1}));
  test.AddNode(test.AddMesh(sheet), glm::mat4(1));
  for (const int i : {0, 1, 4, 11}) {
    SCOPED_TRACE(i);
    test.scene.nodes[0].matrix = EdgeMatrix(AngleOf(i), OffsetOf(i), kSize, -3);
    ExpectAreas(Resolved(test), PlaneOf(AngleOf(i), OffsetOf(i), kSize));
  }
}

TEST_F(Resolve, NothingButColourChanges) {
  const TestScene test = Edge(0.4f, 0.3f, kSize);
  const Attribute attributes[] = {Attribute::kColor,  Attribute::kObjectId, Attribute::kMaterialId,
                                  Attribute::kNormal, Attribute::kDepth,    Attribute::kAlbedo};
  std::vector<Picture> pictures[2];
  for (const bool is_on : {false, true}) {
    std::vector<gl::Texture> targets;
    std::vector<Request> requests;
    for (std::size_t i = 0; i < std::size(attributes); ++i)
      targets.push_back(Must(gl::Texture::Create(Float(), kSize, kSize, 1, "target")));
    for (std::size_t i = 0; i < std::size(attributes); ++i) requests.push_back({attributes[i], &targets[i]});
    ExpectDone(Draw(test, Perspective(0.9f, 1), requests, is_on ? EdgeMode::kResolve : EdgeMode::kOff));
    for (const gl::Texture& target : targets) pictures[is_on].push_back(ReadPicture(target));
  }
  EXPECT_NE(pictures[0][0].values, pictures[1][0].values);
  for (std::size_t i = 1; i < std::size(attributes); ++i)
    EXPECT_EQ(pictures[0][i].values, pictures[1][i].values) << gbuffer::Info(attributes[i]).name;
}

/// What a target of linear light says, in display encoding (IEC 61966-2-1) with unassociated alpha.
float Encoded(float linear) {
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

TEST_F(Resolve, DisplayTargetsHoldTheLinearResultEncoded) {
  background_ = {0.05f, 0.3f, 0.8f, 1};
  TestScene test = Edge(0.4f, 0.3f, kSize);
  test.scene.materials[0] = Unlit({0.9f, 0.5f, 0.02f, 1});
  const Picture linear = Resolved(test);
  gl::Format x8r8g8b8 = Unorm();
  x8r8g8b8.swizzle = {GL_RED, GL_GREEN, GL_BLUE, GL_ONE};
  x8r8g8b8.components = 3;
  for (const gl::Format& format : {Unorm(), x8r8g8b8, Unorm(4, 16), Float(4, 16)}) {
    const Picture display = DrawOne(test, Orthographic(), EdgeMode::kResolve, kSize, kSize, Attribute::kColor, format,
                                    image::Encoding::kDisplay);
    // Two colours of 8 bits, mixed and rounded again.
    const float tolerance = format.bits == 8 ? 1.6f * kStep8 : 1e-3f;
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) {
        for (std::size_t c = 0; c < 3; ++c)
          ASSERT_NEAR(display.At(x, y)[c], Encoded(linear.At(x, y)[c]), tolerance) << x << " " << y << " " << c;
        ASSERT_EQ(display.At(x, y)[3], 1.0f);
      }
    }
  }
}

TEST_F(Resolve, WhatIsBrighterThanATargetHoldsHasNoWiderOutlineThere) {
  TestScene test = Edge(0.4f, 0.3f, kSize);
  const HalfPlane plane = PlaneOf(0.4f, 0.3f, kSize);
  test.scene.materials[0] = Unlit({20, 20, 20, 1});
  const Picture display = DrawOne(test, Orthographic(), EdgeMode::kResolve, kSize, kSize, Attribute::kColor, Unorm(),
                                  image::Encoding::kDisplay);
  const Picture linear = Resolved(test);
  for (int y = 1; y < kSize - 1; ++y) {
    for (int x = 1; x < kSize - 1; ++x) {
      ASSERT_NEAR(display.At(x, y)[0], Encoded(static_cast<float>(plane.Area(x, y))), 1.6f * kStep8 + kAreaError);
      ASSERT_NEAR(linear.At(x, y)[0], 20.0 * plane.Area(x, y), 20.0 * kAreaError) << "a float target keeps it all";
    }
  }
}

TEST_F(Resolve, IntensityAndAlphaFollowFromTheResolvedColour) {
  background_ = {0.02f, 0.1f, 0.05f, 0.25f};
  TestScene test = Edge(0.4f, 0.3f, kSize);
  test.scene.materials[0] = Unlit({0.9f, 0.5f, 0.1f, 1});
  const Picture color = Resolved(test);
  gl::Format l8 = Unorm(1);
  l8.swizzle = {GL_RED, GL_RED, GL_RED, GL_ONE};
  const auto one = [&](Attribute attribute, const gl::Format& format) {
    return DrawOne(test, Orthographic(), EdgeMode::kResolve, kSize, kSize, attribute, format);
  };
  const Picture intensity = one(Attribute::kIntensity, Float(1)), intensity8 = one(Attribute::kIntensity, l8),
                luminance8 = one(Attribute::kColor, l8), alpha = one(Attribute::kAlpha, Float(1));
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const std::vector<float> c = color.At(x, y);
      const float luma = 0.2126f * c[0] + 0.7152f * c[1] + 0.0722f * c[2];
      ASSERT_NEAR(intensity.At(x, y)[0], luma, kRounding);
      ASSERT_NEAR(intensity8.At(x, y)[0], luma, 0.51f * kStep8);
      ASSERT_NEAR(luminance8.At(x, y)[0], luma, 0.51f * kStep8);
      ASSERT_NEAR(alpha.At(x, y)[0], c[3], kRounding);
    }
  }
}

TEST_F(Resolve, BeforeATransparentBackgroundAlphaIsTheCoverageAndTheColourStays) {
  background_ = glm::vec4(0);
  TestScene test = Edge(0.4f, 0.3f, kSize);
  test.scene.materials[0] = Unlit({0.8f, 0.4f, 0.1f, 1});
  const HalfPlane plane = PlaneOf(0.4f, 0.3f, kSize);
  const Picture linear = Resolved(test);
  const Picture display = DrawOne(test, Orthographic(), EdgeMode::kResolve, kSize, kSize, Attribute::kColor, Unorm(),
                                  image::Encoding::kDisplay);
  int partial = 0;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const std::vector<float> c = linear.At(x, y), d = display.At(x, y);
      ASSERT_NEAR(c[3], plane.Area(x, y), kAreaError);
      ASSERT_NEAR(c[0], 0.8f * c[3], kRounding);
      ASSERT_NEAR(c[1], 0.4f * c[3], kRounding);
      ASSERT_NEAR(d[3], c[3], 0.51f * kStep8);
      partial += c[3] > 0.1f && c[3] < 0.9f;
      if (d[3] < 0.1f) continue;
      ASSERT_NEAR(d[0], Encoded(0.8f), 1.1f * kStep8) << "display files have unassociated colour";
      ASSERT_NEAR(d[2], Encoded(0.1f), 1.1f * kStep8);
    }
  }
  EXPECT_GT(partial, kSize / 2);
}

/// A square before the whole frame whose colour differs from pixel to pixel.
scene::Primitive Gradient(int material) {
  scene::Primitive square = Square(material);
  square.colors = {{0.1f, 0.9f, 0, 1}, {1, 0, 0.2f, 1}, {0, 0.1f, 1, 1}, {0.5f, 1, 0.6f, 1}};
  return square;
}

TEST_F(Resolve, HiddenEdgesDoNothing) {
  TestScene front;
  const int white = front.AddMaterial(Unlit({1, 1, 1, 1}));
  front.AddNode(front.AddMesh(Gradient(white)), Translate(0, 0, -3) * glm::scale(glm::mat4(1), glm::vec3(2)));
  TestScene both = front;
  const glm::mat4 small = glm::scale(glm::mat4(1), glm::vec3(0.4f));
  both.AddNode(both.AddMesh(Square(white)),
               glm::rotate(Translate(0.2f, 0.1f, -5), 0.2f, glm::vec3(0.3f, 0.2f, 1)) * small);
  both.AddNode(both.AddMesh(gbuffer::Sphere(white, 24)), Translate(-0.4f, 0, -3.5f) * small);
  EXPECT_EQ(Resolved(both).values, Resolved(front).values);
  EXPECT_EQ(Resolved(both).values, Plain(front).values);
}

TEST_F(Resolve, AnEdgeCountsWhereItIsNotHidden) {
  // A white square whose edge is half behind another.
  TestScene test = Edge(0.4f, 0.3f, kSize, -5);
  test.AddNode(test.AddMesh(Gradient(0)), Translate(0, 1, -3));
  const Picture picture = Resolved(test), plain = Plain(test);
  const HalfPlane plane = PlaneOf(0.4f, 0.3f, kSize);
  for (int x = 0; x < kSize; ++x) {
    for (int y = 0; y < kSize / 2 - 1; ++y) ASSERT_EQ(picture.At(x, y), plain.At(x, y)) << x << " " << y;
    for (int y = kSize / 2 + 1; y < kSize; ++y) ASSERT_NEAR(picture.At(x, y)[0], plane.Area(x, y), kAreaError);
  }
}

TEST_F(Resolve, AnOpenSheetLooksAlikeFromBehindWhereItIsDoubleSided) {
  TestScene test = Edge(0.4f, 0.3f, kSize);
  test.scene.nodes[0].matrix = EdgeMatrix(0.4f, 0.3f, kSize, -3) * glm::rotate(glm::mat4(1), kPi, glm::vec3(1, 0, 0));
  EXPECT_EQ(Resolved(test).values, Plain(test).values) << "single-sided: not there";
  EXPECT_EQ(Resolved(test).At(kSize - 1, kSize / 2)[0], 0.0f);
  test.scene.materials[0].double_sided = true;
  ExpectAreas(Resolved(test), PlaneOf(0.4f, 0.3f, kSize));
}

TEST_F(Resolve, AMirroredNodeLooksLikeAnUnmirroredOne) {
  for (int i = 0; i < kAngles; i += 3) {
    SCOPED_TRACE(i);
    TestScene test = Edge(AngleOf(i), OffsetOf(i), kSize);
    *test.scene.nodes[0].matrix *= glm::scale(glm::mat4(1), glm::vec3(1, -1, 1));
    ExpectAreas(Resolved(test), PlaneOf(AngleOf(i), OffsetOf(i), kSize));
  }
}

TEST_F(Resolve, TheEdgeBetweenTwoFacesMixesThem) {
  // A roof seen from above, white to the right of its ridge, a third of that to the left.
  TestScene test;
  const int white = test.AddMaterial(Unlit({1, 1, 1, 1})), grey = test.AddMaterial(Unlit({0.25f, 0.25f, 0.25f, 1}));
  for (const float rise : {0.0f, 1.0f, -1.0f}) {
    scene::Primitive right, left;
    right.positions = {{0, -8, 0}, {8, -8, -8 * rise}, {8, 8, -8 * rise}, {0, 8, 0}};
    left.positions = {{0, 8, 0}, {-8, 8, -8 * rise}, {-8, -8, -8 * rise}, {0, -8, 0}};
    right.normals.assign(4, {0, 0, 1});
    left.normals = right.normals;
    right.indices = left.indices = {0, 1, 2, 0, 2, 3};
    right.material = white;
    left.material = grey;
    scene::Mesh mesh;
    mesh.primitives = {right, left};
    test.scene.meshes = {mesh};
    test.scene.nodes.clear();
    test.scene.roots.clear();
    for (int i = 0; i < kAngles; ++i) {
      SCOPED_TRACE(testing::Message() << "rise " << rise << ", angle " << i);
      test.scene.nodes.clear();
      test.scene.roots.clear();
      const float offset = 2 * OffsetOf(i) / kSize;
      test.AddNode(0, glm::rotate(Translate(0, 0, -20), AngleOf(i), glm::vec3(0, 0, 1)) * Translate(offset, 0, 0));
      const Picture picture = Resolved(test, Orthographic(1, 50));
      const HalfPlane plane = PlaneOf(AngleOf(i), OffsetOf(i), kSize);
      for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x)
          ASSERT_NEAR(picture.At(x, y)[0], 0.25 + 0.75 * plane.Area(x, y), kAreaError) << x << " " << y;
      }
    }
  }
}

TEST_F(Resolve, PerspectiveHoldsTheAreasToo) {
  const scene::View view = Perspective(0.9f, 1);
  for (int i = 0; i < kAngles; ++i) {
    SCOPED_TRACE(i);
    TestScene test = Edge(0, 0, kSize);
    // The edge leans away from the eye.
    const glm::mat4 world = glm::rotate(Translate(0.1f, -0.05f, -6), AngleOf(i), glm::vec3(0, 0, 1)) *
                            glm::rotate(glm::mat4(1), 0.7f, glm::vec3(1, 0.5f, 0)) * Translate(4, 0, 0) *
                            glm::scale(glm::mat4(1), glm::vec3(4, 5, 1));
    test.scene.nodes[0].matrix = world;
    const auto at = [&](float x, float y) { return glm::vec3(world * glm::vec4(x, y, 0, 1)); };
    const HalfPlane plane = Projected(view, kSize, at(-1, -0.3f), at(-1, 0.3f), at(-0.9f, 0));
    const Picture picture = Resolved(test, view);
    for (int y = 16; y < 48; ++y) {
      for (int x = 16; x < 48; ++x) ASSERT_NEAR(picture.At(x, y)[0], plane.Area(x, y), kAreaError) << x << " " << y;
    }
  }
}

TEST_F(Resolve, AnEdgeThroughTheNearPlaneIsSmoothUpToTheBorder) {
  // A floor from behind the eye to far ahead.
  const scene::View view = Perspective(0.9f, 1);
  TestScene test;
  const int mesh = test.AddMesh(Square(test.AddMaterial(Unlit({1, 1, 1, 1}))));
  const glm::mat4 world = Translate(5.2f, -1, 0) * glm::rotate(glm::mat4(1), 0.05f, glm::vec3(0, 1, 0)) *
                          glm::rotate(glm::mat4(1), -kPi / 2, glm::vec3(1, 0, 0)) *
                          glm::scale(glm::mat4(1), glm::vec3(5, 20, 1));
  test.AddNode(mesh, world);
  const auto at = [&](float x, float y) { return glm::vec3(world * glm::vec4(x, y, 0, 1)); };
  const HalfPlane plane = Projected(view, kSize, at(-1, 0.2f), at(-1, 0.9f), at(-0.9f, 0.9f));
  const Picture picture = Resolved(test, view);
  int partial = 0;
  for (int y = 40; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const double area = plane.Area(x, y);
      ASSERT_NEAR(picture.At(x, y)[0], area, kAreaError) << x << " " << y;
      partial += area > 0.1 && area < 0.9;
    }
  }
  EXPECT_GT(partial, 10);
}

/// A bar of `width` pixels and endless length.
TestScene Bar(float angle_rad, float offset, float width) {
  TestScene test;
  test.AddNode(test.AddMesh(Square(test.AddMaterial(Unlit({1, 1, 1, 1})))),
               glm::rotate(Translate(0, 0, -3), angle_rad, glm::vec3(0, 0, 1)) * Translate(2 * offset / kSize, 0, 0) *
                   glm::scale(glm::mat4(1), glm::vec3(width / kSize, 4, 1)));
  return test;
}

TEST_F(Resolve, ABarThinnerThanAPixelStaysWithinItsBounds) {
  for (const float width : {0.2f, 0.5f, 0.8f}) {
    for (int i = 0; i < kAngles; ++i) {
      SCOPED_TRACE(testing::Message() << "width " << width << ", angle " << i);
      const HalfPlane middle = PlaneOf(AngleOf(i), OffsetOf(i), kSize);
      const Picture picture = Resolved(Bar(AngleOf(i), OffsetOf(i), width));
      for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
          const float value = picture.At(x, y)[0];
          ASSERT_GE(value, 0.0f);
          ASSERT_LE(value, 1.0f);
          if (std::abs(middle.Distance(x, y)) > middle.Extent() + 0.5 * width + 1e-3) {
            ASSERT_EQ(value, 0.0f) << x << " " << y;
          }
        }
      }
    }
  }
}

TEST_F(Resolve, ABarOfAPixelAndMoreHasItsWidth) {
  for (const float width : {1.5f, 2.5f}) {
    for (int i = 0; i < kAngles; ++i) {
      SCOPED_TRACE(testing::Message() << "width " << width << ", angle " << i);
      const HalfPlane middle = PlaneOf(AngleOf(i), OffsetOf(i), kSize);
      const Picture picture = Resolved(Bar(AngleOf(i), OffsetOf(i), width));
      for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
          const double area = AreaBeyond(middle.normal.x, middle.normal.y, middle.offset - 0.5 * width, x, y) -
                              AreaBeyond(middle.normal.x, middle.normal.y, middle.offset + 0.5 * width, x, y);
          ASSERT_NEAR(picture.At(x, y)[0], area, kAreaError) << x << " " << y;
        }
      }
    }
  }
}

scene::Primitive PrimitiveOf(const test::TriangleMesh& mesh, int material) {
  scene::Primitive primitive;
  primitive.positions = mesh.positions;
  primitive.normals = mesh.normals;
  primitive.indices = mesh.triangles;
  primitive.material = material;
  return primitive;
}

TEST_F(Resolve, ASymmetricModelMakesASymmetricPicture) {
  TestScene test;
  test::TriangleMesh ball = test::Icosphere(2);  // a mirror's image of itself in every coordinate
  test::SmoothNormals(ball);
  test.AddNode(test.AddMesh(PrimitiveOf(ball, test.AddMaterial(Unlit({0.9f, 0.6f, 0.3f, 1})))),
               Translate(0, 0, -4) * glm::scale(glm::mat4(1), glm::vec3(0.77f)));
  for (const scene::View& view : {Orthographic(), Perspective(0.5f, 1)}) {
    const Picture picture = Resolved(test, view);
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize / 2; ++x) {
        ASSERT_NEAR(picture.At(x, y)[0], picture.At(kSize - 1 - x, y)[0], 2e-3f) << x << " " << y;
        ASSERT_NEAR(picture.At(x, y)[0], picture.At(x, kSize - 1 - y)[0], 2e-3f) << x << " " << y;
      }
    }
  }
}

TEST_F(Resolve, ASecondRunHasTheSameBits) {
  TestScene test = ColoredCube();
  test.scene.nodes[0].matrix = glm::rotate(Translate(0, 0, -6), 0.7f, glm::vec3(0.3f, 1, 0.2f));
  const scene::View view = Perspective(0.6f, 1);
  const Picture first = Resolved(test, view);
  EXPECT_NE(first.values, Plain(test, view).values);
  EXPECT_EQ(first.values, Resolved(test, view).values) << "a new renderer";
  const auto renderer = Must(gbuffer::SceneRenderer::Create(test.scene, nullptr));
  const auto edges = EdgeRenderer::Create(test.scene, {.mode = EdgeMode::kResolve});
  const gl::Texture small = Must(gl::Texture::Create(Unorm(), 20, 30, 1, "small"));
  const gl::Texture target = Must(gl::Texture::Create(Float(), kSize, kSize, 1, "target"));
  const Request other{Attribute::kColor, &small, image::Encoding::kDisplay}, request{Attribute::kColor, &target};
  for (int i = 0; i < 2; ++i) {
    ExpectDone(DrawWith(*renderer, *edges, test, Orthographic(), std::span(&other, 1)));
    ExpectDone(DrawWith(*renderer, *edges, test, view, std::span(&request, 1)));
    EXPECT_EQ(first.values, ReadPicture(target).values) << "sizes and formats may take turns";
  }
}

TEST_F(Resolve, ScenesWithoutEdgesAreLeftAlone) {
  TestScene empty;
  EXPECT_EQ(Resolved(empty).values, Plain(empty).values);
  TestScene lines;
  scene::Primitive line = Square();
  line.mode = scene::PrimitiveMode::kLines;
  line.normals.clear();
  line.indices = {0, 3};
  lines.AddNode(lines.AddMesh(line), Translate(0, 0, -3));
  EXPECT_EQ(Resolved(lines).values, Plain(lines).values);
}

TEST_F(Resolve, AMeshThatIsNotANumberIsRefusedByName) {
  TestScene test = Edge(0.4f, 0.3f, kSize);
  test.scene.meshes[0].name = "teapot";
  test.scene.meshes[0].primitives[0].positions[2].x = std::numeric_limits<float>::quiet_NaN();
  const gl::Texture target = Must(gl::Texture::Create(Float(), kSize, kSize, 1, "target"));
  const Request request{Attribute::kColor, &target};
  const Result<void> drawn = Draw(test, Orthographic(), std::span(&request, 1), EdgeMode::kResolve);
  ASSERT_FALSE(drawn.has_value());
  EXPECT_EQ(drawn.error().kind, ErrorKind::kInput);
  EXPECT_THAT(drawn.error().message, testing::StartsWith("mesh \"teapot\": vertex 2 is at (nan, "));
  EXPECT_TRUE(Draw(test, Orthographic(), std::span(&request, 1), EdgeMode::kOff).has_value()) << "nothing asks";
}

}  // namespace
}  // namespace burin::overdraw

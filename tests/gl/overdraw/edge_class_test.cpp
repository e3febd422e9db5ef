// SPDX-License-Identifier: Apache-2.0
// Which edges are lines, in which channel, and where something hides them.
#include <gmock/gmock.h>

#include "tests/gl/overdraw/edge_attribute_fixture.h"

namespace burin::overdraw {
namespace {

using gbuffer::Orthographic;
using gbuffer::Perspective;
using gbuffer::Square;
using gbuffer::TestScene;
using gbuffer::Translate;
using testing::Each;
using testing::ElementsAre;
using testing::FloatNear;

constexpr int kSize = 40;

/// Two squares that meet at x = 0, each turned back from the eye by half of `fold_deg`.
std::vector<std::array<glm::vec3, 4>> Roof(float fold_deg) {
  const float back = -std::tan(glm::radians(0.5f * fold_deg));
  return {{{{-1, -1, back}, {0, -1, 0}, {0, 1, 0}, {-1, 1, back}}},
          {{{0, -1, 0}, {1, -1, back}, {1, 1, back}, {0, 1, 0}}}};
}

/// Half as large as the frame, at its middle.
glm::mat4 Middle() { return glm::scale(Translate(0, 0, -5), glm::vec3(0.5f)); }

class EdgeClasses : public EdgeAttributeTest {
 protected:
  static TestScene Of(scene::Primitive primitive) {
    TestScene test;
    test.AddNode(test.AddMesh(std::move(primitive)), Middle());
    return test;
  }
  /// The middle line lies between two pixels: each has half of it.
  std::vector<float> AtTheMiddle(const TestScene& test) {
    return RenderEdges(test, Orthographic(), Attribute::kEdges, kSize, kSize).At(kSize / 2, kSize / 2 + 2);
  }
  std::vector<float> DistanceAt(const TestScene& test, const scene::View& view, int x, int y) {
    return RenderEdges(test, view, Attribute::kEdgeDist, kSize, kSize).At(x, y);
  }
};

auto Near(std::vector<float> values) { return testing::Pointwise(FloatNear(2e-3f), values); }

TEST_F(EdgeClasses, FoldsAreCreases) { EXPECT_THAT(AtTheMiddle(Of(Faces(Roof(60)))), Near({0, 0.5f, 0, 0})); }

TEST_F(EdgeClasses, FacetsAreNot) {
  EXPECT_THAT(AtTheMiddle(Of(Faces(Roof(28)))), Near({0, 0, 0, 0}));
  EXPECT_THAT(AtTheMiddle(Of(Faces(Roof(32)))), Near({0, 0.5f, 0, 0}));
}

TEST_F(EdgeClasses, CreaseAngleBringsSmallerFolds) {
  options_.crease_angle_deg = 10.0f;
  EXPECT_THAT(AtTheMiddle(Of(Faces(Roof(12)))), Near({0, 0.5f, 0, 0}));
  EXPECT_THAT(AtTheMiddle(Of(Faces(Roof(8)))), Near({0, 0, 0, 0}));
}

TEST_F(EdgeClasses, CreasesHaveNoInside) {
  for (const int x : {kSize / 2 - 3, kSize / 2 + 2}) {
    EXPECT_NEAR(DistanceAt(Of(Faces(Roof(60))), Orthographic(), x, kSize / 2)[0], 2.5f, 1e-3f);
  }
}

TEST_F(EdgeClasses, MaterialsMeet) {
  TestScene test;
  const int one = test.AddMaterial(gbuffer::Unlit({1, 0, 0, 1}));
  const int two = test.AddMaterial(gbuffer::Unlit({0, 1, 0, 1}));
  const int mesh = test.AddMesh(Faces({Roof(0)[0]}, one));
  test.scene.meshes[static_cast<std::size_t>(mesh)].primitives.push_back(Faces({Roof(0)[1]}, two));
  test.AddNode(mesh, Middle());
  EXPECT_THAT(AtTheMiddle(test), Near({0, 0, 0, 0.5f}));
}

TEST_F(EdgeClasses, SeamsAreNoLines) {
  scene::Primitive flat = Faces(Roof(0));
  flat.texcoords[0] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.3f, 0}, {1, 0}, {1, 1}, {0.3f, 1}};
  const TestScene test = Of(flat);
  EXPECT_THAT(AtTheMiddle(test), Near({0, 0, 0, 0}));
  EXPECT_NEAR(DistanceAt(test, Orthographic(), kSize / 2, kSize / 2)[0], -9.5f, 1e-3f) << "to the boundary";
}

TEST_F(EdgeClasses, WhatIsHiddenHasNoLines) {
  TestScene test = Of(Box());
  test.AddNode(test.AddMesh(Square()), glm::scale(Translate(0, 0, -3), glm::vec3(3)));
  EXPECT_THAT(RenderEdges(test, Orthographic(), Attribute::kEdges, kSize, kSize).values, Each(0.0f));
  EXPECT_EQ(DistanceAt(test, Orthographic(), kSize / 2, kSize / 4)[0], 1e10f);
}

TEST_F(EdgeClasses, LinesEndAtWhatIsInFront) {
  // A wall in front covers the right half, from 3.3 pixels left of the middle.
  TestScene test = Of(Square());
  const float left = -3.3f / (0.5f * kSize);
  test.AddNode(test.AddMesh(Square()), glm::scale(Translate(left + 2, 0, -3), glm::vec3(2)));
  const std::vector<Line> seen = {
      {{10, 10}, {10, 30}}, {{10, 10}, {16.7, 10}}, {{10, 30}, {16.7, 30}}, {{16.7, -9}, {16.7, 49}}};
  const Picture distances = RenderEdges(test, Orthographic(), Attribute::kEdgeDist, kSize, kSize);
  const Picture edges = RenderEdges(test, Orthographic(), Attribute::kEdges, kSize, kSize);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const Point p(x + 0.5, y + 0.5);
      const double expected = Distance(seen, p);
      if (expected < 15.9) {
        const double found = distances.At(x, y)[0];
        // Lines end within half a pixel of what hides them, which only the wall behind the ends can tell.
        ASSERT_NEAR(p.x > 16.7 ? -found : std::abs(found), expected, p.x > 16.7 ? 0.3 : 1e-3) << x << "," << y;
      }
      if (p.x > 18.5) {
        ASSERT_THAT(edges.At(x, y), Each(0.0f)) << x << "," << y;
      }
    }
  }
}

TEST_F(EdgeClasses, WhatLiesJustUnderAPlaneHasNone) {
  TestScene test;
  const glm::mat4 lying = glm::rotate(glm::mat4(1.0f), glm::radians(-90.0f), glm::vec3(1, 0, 0));
  test.AddNode(test.AddMesh(Square()), glm::scale(lying, glm::vec3(20)));
  test.AddNode(test.AddMesh(Square()), Translate(0, -0.01f, 0) * lying);
  scene::View view = Perspective(0.3f, 1.0f);
  view.view_from_world = glm::lookAt(glm::vec3(0.5f, 3, 9), glm::vec3(0), glm::vec3(0, 1, 0));
  EXPECT_THAT(RenderEdges(test, view, Attribute::kEdges, 60, 60).values, Each(0.0f));
}

TEST_F(EdgeClasses, DoNotDependOnWhatElseIsRendered) {
  // A pane that is blended and hides what is behind it from data: its alpha is above a half.
  TestScene test = Of(Square());
  scene::Material glass = gbuffer::Unlit({1, 1, 1, 0.8f});
  glass.alpha_mode = scene::AlphaMode::kBlend;
  test.AddNode(test.AddMesh(Square(test.AddMaterial(glass))), Translate(0.8f, 0, -3));
  const std::vector<float> alone = RenderEdges(test, Orthographic(), Attribute::kEdges, kSize, kSize).values;

  const auto target = [] { return gl::Must(gl::Texture::Create(gbuffer::Float(), kSize, kSize, 1, "target")); };
  for (const Attribute other : {Attribute::kColor, Attribute::kDepth}) {
    const std::array<gl::Texture, 2> targets = {target(), target()};
    const std::array<gbuffer::Request, 2> requests = {{{other, targets.data()}, {Attribute::kEdges, &targets[1]}}};
    const std::unique_ptr<EdgeRenderer> edges = EdgeRenderer::Create(test.scene, options_);
    edges->BeginFrame();
    edges_ = edges.get();
    RenderInto(test, Orthographic(), requests);
    edges_ = nullptr;
    EXPECT_EQ(ReadPicture(targets[1]).values, alone) << gbuffer::Info(other).name;
  }
  EXPECT_THAT(std::vector(alone.begin() + 4 * (20 * kSize + 29), alone.begin() + 4 * (20 * kSize + 31)), Each(0.0f));
}

TEST_F(EdgeClasses, WhatStandsOnAPlaneHasItsLowerLine) {
  // A box on the ground, seen from above its front: the ground is nearer to the eye just below the box's lower edge.
  TestScene test;
  test.AddNode(test.AddMesh(Box()), glm::mat4(1.0f));
  const glm::mat4 lying = glm::rotate(glm::mat4(1.0f), glm::radians(-90.0f), glm::vec3(1, 0, 0));
  test.AddNode(test.AddMesh(Square()), glm::scale(Translate(0, -1, 0) * lying, glm::vec3(20)));
  scene::View view = Perspective(0.6f, 1.0f);
  view.view_from_world = glm::lookAt(glm::vec3(0.5f, 4, 9), glm::vec3(0), glm::vec3(0, 1, 0));
  constexpr int kLarge = 200;
  const Line lower = {Project(view, {-1, -1, 1}, kLarge, kLarge), Project(view, {1, -1, 1}, kLarge, kLarge)};
  const Picture edges = RenderEdges(test, view, Attribute::kEdges, kLarge, kLarge);
  for (int x = static_cast<int>(lower.a.x) + 3; x < static_cast<int>(lower.b.x) - 3; ++x) {
    for (int y = 0; y < kLarge; ++y) {
      const double expected = lower.Coverage({x + 0.5, y + 0.5});
      if (expected > 0.0) {
        ASSERT_NEAR(edges.At(x, y)[0], expected, 5e-3) << x << "," << y;
      }
    }
  }
}

}  // namespace
}  // namespace burin::overdraw

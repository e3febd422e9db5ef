// SPDX-License-Identifier: Apache-2.0
// Coverage and distances against closed forms.
#include <gmock/gmock.h>

#include "tests/gl/overdraw/edge_attribute_fixture.h"

namespace burin::overdraw {
namespace {

using gbuffer::Float;
using gbuffer::Orthographic;
using gbuffer::Perspective;
using gbuffer::Square;
using gbuffer::TestScene;
using gbuffer::Translate;
using gbuffer::Unorm;
using testing::ElementsAre;
using testing::FloatNear;

constexpr int kWidth = 80, kHeight = 60;
constexpr double kCoverageTolerance = 2e-3;  // gathered in half floats
constexpr double kDistanceTolerance = 1e-3;

/// A shape whose outline is a square, turned in the picture and off the pixels' grid.
struct Turned {
  TestScene scene;
  scene::View view = Perspective(0.6f, static_cast<float>(kWidth) / kHeight);
  std::vector<Line> outline;

  Turned(scene::Primitive shape, float front, float angle_deg, glm::vec2 shift, int scale = 1) {
    glm::mat4 world = Translate(shift.x, shift.y, -5.0f);
    world = glm::rotate(world, glm::radians(angle_deg), glm::vec3(0, 0, 1));
    world = glm::scale(world, glm::vec3(0.7f));
    scene.AddNode(scene.AddMesh(std::move(shape)), world);
    const std::array<glm::vec3, 4> corners = {{{-1, -1, front}, {1, -1, front}, {1, 1, front}, {-1, 1, front}}};
    const auto at = [&](std::size_t i) { return glm::vec3(world * glm::vec4(corners[i % 4], 1.0f)); };
    for (std::size_t i = 0; i < 4; ++i) outline.push_back({Pixel(at(i), scale), Pixel(at(i + 1), scale)});
  }

  [[nodiscard]] Point Pixel(const glm::vec3& p, int scale) const {
    const glm::dvec4 clip = glm::dmat4(view.clip_from_view) * glm::dvec4(p, 1.0);
    return {(clip.x / clip.w + 1.0) * 0.5 * kWidth * scale, (1.0 - clip.y / clip.w) * 0.5 * kHeight * scale};
  }
  /// The outline runs against the clock on the screen, y down: inside is on the left as seen from above.
  [[nodiscard]] bool IsInside(Point p) const {
    return std::ranges::all_of(outline, [&](const Line& line) {
      const Point d = line.b - line.a, q = p - line.a;
      return d.x * q.y - d.y * q.x < 0.0;
    });
  }
};

class EdgeAttribute : public EdgeAttributeTest {
 protected:
  void ExpectDistances(const Picture& picture, const Turned& turned, int scale = 1) {
    for (int y = 0; y < kHeight * scale; ++y) {
      for (int x = 0; x < kWidth * scale; ++x) {
        const Point p(x + 0.5, y + 0.5);
        const double distance = Distance(turned.outline, p);
        if (std::abs(distance - 16.0) < kDistanceTolerance || distance < kDistanceTolerance) continue;
        const double expected = distance > 16.0 ? 1e10 : turned.IsInside(p) ? -distance : distance;
        ASSERT_NEAR(picture.At(x, y)[0], expected, kDistanceTolerance) << x << "," << y;
      }
    }
  }
  void ExpectCoverage(const Picture& picture, const Turned& turned, std::size_t channel) {
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const std::vector<float> found = picture.At(x, y);
        for (std::size_t c = 0; c < 4; ++c) {
          const double expected = c == channel ? Coverage(turned.outline, {x + 0.5, y + 0.5}) : 0.0;
          ASSERT_NEAR(found[c], expected, kCoverageTolerance) << x << "," << y << " channel " << c;
        }
      }
    }
  }
};

constexpr std::array kAngles = {0.0f, 7.0f, 30.0f, 45.0f, 61.5f, 85.0f};
constexpr std::array kShifts = {glm::vec2(0.0f), glm::vec2(0.013f, 0.029f)};

TEST_F(EdgeAttribute, BoxHasTheSilhouetteOfItsFront) {
  for (const float angle : kAngles) {
    for (const glm::vec2 shift : kShifts) {
      SCOPED_TRACE(testing::Message() << angle << " degrees, shifted by " << shift.x);
      const Turned box(Box(), 1.0f, angle, shift);
      ExpectCoverage(RenderEdges(box.scene, box.view, Attribute::kEdges, kWidth, kHeight), box, 0);
      ExpectDistances(RenderEdges(box.scene, box.view, Attribute::kEdgeDist, kWidth, kHeight), box);
    }
  }
}

TEST_F(EdgeAttribute, SquareHasBoundaries) {
  for (const float angle : kAngles) {
    SCOPED_TRACE(testing::Message() << angle << " degrees");
    const Turned square(Square(), 0.0f, angle, kShifts[1]);
    ExpectCoverage(RenderEdges(square.scene, square.view, Attribute::kEdges, kWidth, kHeight), square, 2);
    ExpectDistances(RenderEdges(square.scene, square.view, Attribute::kEdgeDist, kWidth, kHeight), square);
  }
}

TEST_F(EdgeAttribute, SharpCornersKeepTheirSides) {
  scene::Primitive spike;
  spike.positions = {{-0.8f, 0.21f, 0}, {-0.8f, -0.05f, 0}, {0.53f, 0.02f, 0}};
  spike.normals.assign(3, {0, 0, 1});
  spike.indices = {0, 1, 2};
  TestScene test;
  test.AddNode(test.AddMesh(spike), Translate(0, 0, -5));
  std::vector<Line> outline;
  const auto at = [&](std::size_t i) { return Project(Orthographic(), spike.positions[i % 3], kWidth, kWidth); };
  for (std::size_t i = 0; i < 3; ++i) outline.push_back({at(i), at(i + 1)});
  const Picture picture = RenderEdges(test, Orthographic(), Attribute::kEdgeDist, kWidth, kWidth);
  for (int y = 0; y < kWidth; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const Point p(x + 0.5, y + 0.5);
      const double distance = Distance(outline, p);
      if (distance > 15.9) continue;
      const bool is_inside = std::ranges::all_of(outline, [&](const Line& line) {
        const Point d = line.b - line.a, q = p - line.a;
        return d.x * q.y - d.y * q.x < 0.0;
      });
      ASSERT_NEAR(picture.At(x, y)[0], is_inside ? -distance : distance, kDistanceTolerance) << x << "," << y;
    }
  }
}

TEST_F(EdgeAttribute, DistancesAreInPixelsOfTheTarget) {
  const Turned square(Square(), 0.0f, 30.0f, kShifts[1], 3);
  ExpectDistances(RenderEdges(square.scene, square.view, Attribute::kEdgeDist, 3 * kWidth, 3 * kHeight), square, 3);
}

TEST_F(EdgeAttribute, SphereIsRound) {
  TestScene test;
  test.AddNode(test.AddMesh(gbuffer::Sphere(scene::kNone, 384)), glm::scale(Translate(0, 0, -5), glm::vec3(0.6f)));
  constexpr int kSize = 100;
  const Picture picture = RenderEdges(test, Orthographic(), Attribute::kEdgeDist, kSize, kSize);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      // The mesh's silhouette zigzags between rings of its vertices: 0.02 of a pixel here.
      const double expected = glm::length(Point(x + 0.5, y + 0.5) - 0.5 * kSize) - 0.3 * kSize;
      if (std::abs(expected) < 15.8) {
        EXPECT_NEAR(picture.At(x, y)[0], expected, 0.05) << x << "," << y;
      }
      if (std::abs(expected) > 16.2) {
        ASSERT_EQ(picture.At(x, y)[0], 1e10f) << x << "," << y;
      }
    }
  }
}

TEST_F(EdgeAttribute, AreTheSameWhateverIsAntialiased) {
  const Turned box(Box(), 1.0f, 20.0f, kShifts[1]);
  std::vector<std::vector<float>> all;
  for (const EdgeMode mode : {EdgeMode::kOff, EdgeMode::kUnsorted, EdgeMode::kSorted, EdgeMode::kResolve}) {
    options_.mode = mode;
    all.push_back(RenderEdges(box.scene, box.view, Attribute::kEdgeDist, kWidth, kHeight).values);
  }
  EXPECT_EQ(all[1], all[0]);
  EXPECT_EQ(all[2], all[0]);
  EXPECT_EQ(all[3], all[0]);
}

TEST_F(EdgeAttribute, UnsignedTargetsKeepAPixelOnEitherSide) {
  const Turned square(Square(), 0.0f, 30.0f, kShifts[1]);
  const Picture distance = RenderEdges(square.scene, square.view, Attribute::kEdgeDist, kWidth, kHeight, Unorm());
  const Picture coverage = RenderEdges(square.scene, square.view, Attribute::kEdges, kWidth, kHeight, Unorm());
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const Point p(x + 0.5, y + 0.5);
      const double away = Distance(square.outline, p);
      const double expected = std::clamp(0.5 + 0.5 * (square.IsInside(p) ? -away : away), 0.0, 1.0);
      ASSERT_NEAR(distance.At(x, y)[0], expected, 3e-3) << x << "," << y;
      ASSERT_EQ(distance.At(x, y)[3], away < 16.0 ? 1.0f : 0.0f) << x << "," << y;
      ASSERT_NEAR(coverage.At(x, y)[2], Coverage(square.outline, p), 4e-3) << x << "," << y;
    }
  }
}

TEST_F(EdgeAttribute, HalfFloatsHoldTheLargestNumberFarOff) {
  const Turned square(Square(), 0.0f, 30.0f, kShifts[1]);
  const Picture picture = RenderEdges(square.scene, square.view, Attribute::kEdgeDist, kWidth, kHeight, Float(1, 16));
  EXPECT_EQ(picture.At(0, 0)[0], 65504.0f);
  EXPECT_NEAR(picture.At(kWidth / 2, kHeight / 2)[0], -Distance(square.outline, {40.5, 30.5}), 1e-2);
}

TEST_F(EdgeAttribute, WithoutEdgesThereIsBackground) {
  TestScene nothing;
  EXPECT_THAT(RenderEdges(nothing, Orthographic(), Attribute::kEdges, 4, 4).At(1, 1), ElementsAre(0, 0, 0, 0));
  EXPECT_THAT(RenderEdges(nothing, Orthographic(), Attribute::kEdgeDist, 4, 4).At(1, 1),
              ElementsAre(1e10f, 1e10f, 1e10f, 0));
  const Turned square(Square(), 0.0f, 0.0f, kShifts[0]);
  EXPECT_THAT(Render(square.scene, square.view, Attribute::kEdgeDist, Float(), kWidth, kHeight).At(20, 20),
              ElementsAre(1e10f, 1e10f, 1e10f, 0))
      << "no edge stage";
}

}  // namespace
}  // namespace burin::overdraw

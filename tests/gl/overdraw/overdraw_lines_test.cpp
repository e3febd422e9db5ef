// SPDX-License-Identifier: Apache-2.0
// --edges sorted and unsorted: smooth lines over the edges.
#include <gmock/gmock.h>

#include <algorithm>

#include "tests/gl/overdraw/edge_fixture.h"
#include "tests/support/triangle_mesh.h"

namespace burin::overdraw {
namespace {

constexpr int kSize = 64;
constexpr int kAngles = 12;
constexpr float kBloat = 0.5f, kBloatError = 0.03f;  // px: half of a line one pixel wide lies off its surface
constexpr EdgeMode kModes[] = {EdgeMode::kUnsorted, EdgeMode::kSorted};

float AngleOf(int i) { return 2 * kPi * (static_cast<float>(i) + 0.13f) / kAngles; }
float OffsetOf(int i) { return 0.37f * static_cast<float>(i) - 2.0f; }

class OverdrawLines : public EdgeTest {
 protected:
  OverdrawLines() { background_ = {0, 0, 0, 1}; }
  Picture Lines(const TestScene& test, EdgeMode mode = EdgeMode::kSorted, const scene::View& view = Orthographic()) {
    return DrawOne(test, view, mode, kSize, kSize);
  }
};

TEST_F(OverdrawLines, OutlinesGrowByHalfAPixelAtEveryAngle) {
  for (const EdgeMode mode : kModes) {
    for (int i = 0; i < kAngles; ++i) {
      const Picture picture = Lines(Edge(AngleOf(i), OffsetOf(i), kSize), mode);
      const HalfPlane plane = PlaneOf(AngleOf(i), OffsetOf(i), kSize);
      // Along whole columns, or rows of a steep edge, that the edge crosses well inside the frame.
      const bool is_steep = std::abs(plane.normal.x) > std::abs(plane.normal.y);
      double sum = 0, length = 0;
      for (int k = 8; k < kSize - 8; ++k) {
        double column = 0, across = 0;
        for (int j = 0; j < kSize; ++j) {
          const int x = is_steep ? j : k, y = is_steep ? k : j;
          column += picture.At(x, y)[0] - plane.Area(x, y);
          across += plane.Area(x, y);
        }
        if (across < 4 || across > kSize - 4) continue;
        sum += column;
        length += 1 / (is_steep ? std::abs(plane.normal.x) : std::abs(plane.normal.y));
      }
      ASSERT_GT(length, kSize / 3);
      EXPECT_NEAR(sum / length, kBloat, kBloatError) << "angle " << i;
    }
  }
}

TEST_F(OverdrawLines, ALineFallsOffSmoothlyAndChangesNothingFartherThanAPixel) {
  for (int i = 0; i < kAngles; ++i) {
    const TestScene test = Edge(AngleOf(i), OffsetOf(i), kSize);
    const Picture picture = Lines(test);
    const HalfPlane plane = PlaneOf(AngleOf(i), OffsetOf(i), kSize);
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) {
        const double distance = plane.Distance(x, y);
        if (distance < -1.01) {
          ASSERT_EQ(picture.At(x, y)[0], 0.0f) << x << " " << y;
        } else if (distance > 0.01) {
          ASSERT_EQ(picture.At(x, y)[0], 1.0f) << x << " " << y;
        } else {
          ASSERT_NEAR(picture.At(x, y)[0], 1 + distance, 0.02) << x << " " << y;
        }
      }
    }
  }
}

/// A sheet below y = -`below_px` pixels of the middle whose upper edge is cut into pieces of about 5.3 pixels.
TestScene PiecewiseSheet(float below_px) {
  TestScene test;
  scene::Primitive sheet;
  constexpr int kPieces = 12;
  for (int i = 0; i <= kPieces; ++i) {
    const float x = -1.1f + 2.2f * (static_cast<float>(i) + 0.3f * static_cast<float>(i % 3 == 1)) / kPieces;
    const float top = -2 * below_px / kSize;
    sheet.positions.insert(sheet.positions.end(), {{x, top, 0}, {x, -2, 0}});
    if (i == 0) continue;
    const auto k = static_cast<std::uint32_t>(2 * i);
    sheet.indices.insert(sheet.indices.end(), {k - 2, k - 1, k, k, k - 1, k + 1});
  }
  sheet.normals.assign(sheet.positions.size(), {0, 0, 1});
  sheet.material = test.AddMaterial(Unlit({1, 1, 1, 1}));
  test.AddNode(test.AddMesh(sheet), Translate(0, 0, -3));
  return test;
}

TEST_F(OverdrawLines, JointsOfCollinearEdgesAreCoveredWhole) {
  // The edge is a hair below the centres of row 31, which the sheet itself leaves free.
  const TestScene test = PiecewiseSheet(-0.5f + 0.004f);
  const Picture plain = DrawOne(test, Orthographic(), EdgeMode::kOff, kSize, kSize);
  for (const EdgeMode mode : kModes) {
    const Picture picture = Lines(test, mode);
    for (int x = 0; x < kSize; ++x) {
      ASSERT_EQ(plain.At(x, 31)[0], 0.0f);
      ASSERT_GT(picture.At(x, 31)[0], 0.99f) << "butt ends would leave 0.75, " << x;
    }
  }
}

TEST_F(OverdrawLines, LinesLeaveDepthIdsAndDataAlone) {
  const TestScene test = Edge(0.4f, 0.3f, kSize);
  const Attribute attributes[] = {Attribute::kColor,  Attribute::kObjectId, Attribute::kMaterialId,
                                  Attribute::kNormal, Attribute::kDepth,    Attribute::kPrimitiveId};
  std::vector<Picture> pictures[3];
  const EdgeMode modes[] = {EdgeMode::kOff, EdgeMode::kUnsorted, EdgeMode::kSorted};
  for (std::size_t m = 0; m < 3; ++m) {
    std::vector<gl::Texture> targets;
    std::vector<Request> requests;
    for (std::size_t i = 0; i < std::size(attributes); ++i)
      targets.push_back(Must(gl::Texture::Create(Float(), kSize, kSize, 1, "target")));
    for (std::size_t i = 0; i < std::size(attributes); ++i) requests.push_back({attributes[i], &targets[i]});
    ExpectDone(Draw(test, Perspective(0.9f, 1), requests, modes[m]));
    for (const gl::Texture& target : targets) pictures[m].push_back(ReadPicture(target));
  }
  for (std::size_t m = 1; m < 3; ++m) {
    EXPECT_NE(pictures[0][0].values, pictures[m][0].values);
    for (std::size_t i = 1; i < std::size(attributes); ++i)
      EXPECT_EQ(pictures[0][i].values, pictures[m][i].values) << gbuffer::Info(attributes[i]).name;
  }
}

TEST_F(OverdrawLines, LinesWriteNoDepthSoLaterOnesAreNotHiddenByThem) {
  // Two squares side by side at two depths: the farther one's outline passes under no line of the nearer one.
  TestScene test;
  const int white = test.AddMaterial(Unlit({1, 1, 1, 1}));
  const int mesh = test.AddMesh(Square(white));
  test.AddNode(mesh, Translate(-1.01f, 0, -2));
  test.AddNode(mesh, Translate(1.0f, 0, -5));
  const Picture picture = Lines(test, EdgeMode::kUnsorted);
  // The gap is 0.32 pixels wide at the middle; both lines cover it.
  for (int y = 8; y < kSize - 8; ++y) {
    for (int x = 28; x < 36; ++x) ASSERT_GT(picture.At(x, y)[0], 0.85f) << x << " " << y;
  }
}

/// A near white square right of x = 0 and, later in the file, a far red one whose outline shows in the same place.
TestScene NearBeforeFar(float edge_px) {
  TestScene test;
  const int white = test.AddMaterial(Unlit({1, 1, 1, 1})), red = test.AddMaterial(Unlit({1, 0, 0, 1}));
  const glm::mat4 wide = glm::scale(glm::mat4(1), glm::vec3(4, 4, 1));
  const float x = 4 + 2 * edge_px / kSize;
  test.AddNode(test.AddMesh(Square(white)), Translate(x, 0, -2) * wide);
  test.AddNode(test.AddMesh(Square(red)), Translate(x, 0, -6) * wide);
  return test;
}

TEST_F(OverdrawLines, SortedOrderDrawsNearerLinesOverFartherOnes) {
  // The column left of the edge is 0.2 pixels off it: lines of weight 0.8.
  const TestScene test = NearBeforeFar(-0.3f);
  options_.sorts_whole_scene = true;
  const std::vector<float> sorted = Lines(test, EdgeMode::kSorted).At(31, 20);
  const float weight = 0.8f;
  EXPECT_NEAR(sorted[0], weight + (1 - weight) * weight, 0.02f);
  EXPECT_NEAR(sorted[1], weight, 0.02f) << "white is on top";
  // In the file's order, which is also that of objects, red comes last.
  for (const bool is_per_object : {true, false}) {
    options_.sorts_whole_scene = !is_per_object;
    const std::vector<float> last = Lines(test, is_per_object ? EdgeMode::kSorted : EdgeMode::kUnsorted).At(31, 20);
    EXPECT_NEAR(last[1], weight * (1 - weight), 0.02f);
  }
}

TEST_F(OverdrawLines, LinesBehindSurfacesAreHidden) {
  TestScene front = Edge(0.4f, 0.3f, kSize);
  TestScene both = front;
  both.AddNode(both.AddMesh(Square(both.AddMaterial(Unlit({1, 0, 0, 1})))),
               Translate(0.5f, 0.1f, -5) * glm::scale(glm::mat4(1), glm::vec3(0.2f)));
  for (const EdgeMode mode : kModes) EXPECT_EQ(Lines(both, mode).values, Lines(front, mode).values);
}

/// The cube of side 2 turned by `angle_rad` about y: front face green, the others blue, one primitive a face.
TestScene TwoColoredCube(float angle_rad) {
  TestScene test;
  const test::TriangleMesh cube = test::Cube();
  scene::Mesh mesh;
  const int green = test.AddMaterial(Unlit({0, 1, 0, 1})), blue = test.AddMaterial(Unlit({0, 0, 1, 1}));
  for (std::uint32_t face = 0; face < 6; ++face) {
    scene::Primitive side;
    side.positions.assign(cube.positions.begin() + 4 * face, cube.positions.begin() + 4 * face + 4);
    side.normals.assign(cube.normals.begin() + 4 * face, cube.normals.begin() + 4 * face + 4);
    side.indices = {0, 1, 2, 0, 2, 3};
    side.material = side.normals[0].z > 0 ? green : blue;
    mesh.primitives.push_back(std::move(side));
  }
  test.scene.meshes.push_back(std::move(mesh));
  test.AddNode(
      0, glm::rotate(Translate(0, 0, -4), angle_rad, glm::vec3(0, 1, 0)) * glm::scale(glm::mat4(1), glm::vec3(0.5f)));
  return test;
}

TEST_F(OverdrawLines, ASharpSilhouetteHasTheFrontFacesColour) {
  // Turned to the right, the right side is hidden behind the front face's right edge; and the other way round.
  for (const float angle : {0.3f, -0.3f}) {
    for (const EdgeMode mode : kModes) {
      const Picture picture = Lines(TwoColoredCube(angle), mode);
      int green = 0;
      for (int y = 24; y < 40; ++y) {
        // From the side where the front face ends inwards.
        for (int k = 0; k < kSize / 2; ++k) {
          const std::vector<float> c = picture.At(angle > 0 ? kSize - 1 - k : k, y);
          ASSERT_EQ(c[2], 0.0f) << "nothing of the face that looks away, " << k << " " << y;
          green += c[1] > 0.05f && c[1] < 0.95f;
        }
      }
      EXPECT_GE(green, 16) << "a line is there";
    }
  }
}

TEST_F(OverdrawLines, ALineInAValleyIsNotHiddenByTheValleysOwnSlopes) {
  // Two faces that rise steeply towards the eye from the edge between them, which is 0.3 pixels left of a centre.
  TestScene test;
  const int green = test.AddMaterial(Unlit({0, 1, 0, 1})), blue = test.AddMaterial(Unlit({0, 0, 1, 1}));
  scene::Primitive left, right;
  left.positions = {{0, 2, 0}, {-2, 2, 4}, {-2, -2, 4}, {0, -2, 0}};
  right.positions = {{0, -2, 0}, {2, -2, 4}, {2, 2, 4}, {0, 2, 0}};
  left.normals.assign(4, {0, 0, 1});
  right.normals = left.normals;
  left.indices = right.indices = {0, 1, 2, 0, 2, 3};
  left.material = green;
  right.material = blue;
  scene::Mesh mesh;
  mesh.primitives = {left, right};
  test.scene.meshes.push_back(std::move(mesh));
  test.AddNode(0, Translate(2 * 0.2f / kSize, 0, -7));
  for (const EdgeMode mode : kModes) {
    const Picture picture = Lines(test, mode);
    for (int y = 8; y < kSize - 8; ++y) {
      // One of the faces is drawn, over the other: 0.7 of it beyond the edge on one side or 0.3 on the other.
      const float in_left = picture.At(31, y)[2], in_right = picture.At(32, y)[1];
      ASSERT_NEAR(std::max(in_left / 0.3f, in_right / 0.7f), 1.0f, 0.05f) << y;
      ASSERT_EQ(picture.At(30, y)[2], 0.0f);
      ASSERT_EQ(picture.At(33, y)[1], 0.0f);
    }
  }
}

TEST_F(OverdrawLines, TheLineOfAFaceSeenFromBehindIsLitAsItsBack) {
  background_ = glm::vec4(0);
  scene::Light sun;
  sun.intensity = 3.0f;
  scene::Material material;
  material.double_sided = true;
  material.metallic = 0.0f;
  TestScene test;
  // The front of the sheet is turned away from the eye, and lit; its back is in its own shadow.
  test.AddNode(test.AddMesh(Square(test.AddMaterial(material))),
               EdgeMatrix(0.4f, 0.3f, kSize, -3) * glm::rotate(glm::mat4(1), kPi, glm::vec3(1, 0, 0)));
  test.AddLight(sun, glm::rotate(glm::mat4(1), kPi, glm::vec3(0, 1, 0)));
  const HalfPlane plane = PlaneOf(0.4f, 0.3f, kSize);
  const Picture picture = Lines(test);
  std::vector<float> inside;
  int compared = 0;
  for (int y = 0; y < kSize; ++y) {
    for (int x = kSize - 1; x >= 0; --x) {
      const std::vector<float> c = picture.At(x, y);
      if (plane.Distance(x, y) > 2) inside = c;
      if (plane.Distance(x, y) > -0.05 || c[3] < 0.2f || inside.empty()) continue;
      ASSERT_NEAR(c[0] / c[3], inside[0], 0.05f * inside[0]) << x << " " << y;
      ++compared;
    }
  }
  EXPECT_GT(compared, kSize / 3);
}

TEST_F(OverdrawLines, TransparentBackgroundsGetTheLinesCoverageAsAlpha) {
  background_ = glm::vec4(0);
  TestScene test = Edge(0.4f, 0.3f, kSize);
  test.scene.materials[0] = Unlit({0.8f, 0.4f, 0.1f, 1});
  const Picture picture = Lines(test);
  int partial = 0;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const std::vector<float> c = picture.At(x, y);
      ASSERT_NEAR(c[0], 0.8f * c[3], 1e-5f);
      ASSERT_NEAR(c[1], 0.4f * c[3], 1e-5f);
      partial += c[3] > 0.1f && c[3] < 0.9f;
    }
  }
  EXPECT_GT(partial, kSize / 2);
}

TEST_F(OverdrawLines, AMirroredNodesLinesAreThoseOfAnUnmirroredOne) {
  TestScene test = Edge(0.4f, 0.3f, kSize);
  const Picture straight = Lines(test);
  *test.scene.nodes[0].matrix *= glm::scale(glm::mat4(1), glm::vec3(1, -1, 1));
  const Picture mirrored = Lines(test);
  for (std::size_t i = 0; i < straight.values.size(); ++i) ASSERT_NEAR(straight.values[i], mirrored.values[i], 1e-4f);
}

TEST_F(OverdrawLines, AnEdgeThroughTheNearPlaneIsDrawnUpToTheBorder) {
  const scene::View view = Perspective(0.9f, 1);
  const glm::mat4 world = Translate(5.2f, -1, 0) * glm::rotate(glm::mat4(1), -kPi / 2, glm::vec3(1, 0, 0)) *
                          glm::scale(glm::mat4(1), glm::vec3(5, 20, 1));
  TestScene test;
  test.AddNode(test.AddMesh(Square(test.AddMaterial(Unlit({1, 1, 1, 1})))), world);
  const auto at = [&](float x, float y) { return glm::vec3(world * glm::vec4(x, y, 0, 1)); };
  const HalfPlane plane = Projected(view, kSize, at(-1, 0.2f), at(-1, 0.9f), at(-0.9f, 0.9f));
  for (const EdgeMode mode : kModes) {
    const Picture picture = Lines(test, mode, view);
    for (int y = 40; y < kSize; ++y) {
      double gain = 0;
      for (int x = 0; x < kSize; ++x) gain += picture.At(x, y)[0] - plane.Area(x, y);
      EXPECT_NEAR(gain * std::abs(plane.normal.x), kBloat, 0.1) << y;
    }
  }
}

TEST_F(OverdrawLines, ASecondRunHasTheSameBits) {
  const TestScene test = TwoColoredCube(0.7f);
  for (const EdgeMode mode : kModes) {
    const Picture first = Lines(test, mode, Perspective(0.6f, 1));
    EXPECT_EQ(first.values, Lines(test, mode, Perspective(0.6f, 1)).values);
  }
}

}  // namespace
}  // namespace burin::overdraw

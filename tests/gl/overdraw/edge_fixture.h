// SPDX-License-Identifier: Apache-2.0
#pragma once
// Scenes drawn with their edges, and exact areas to compare with. Pixels run right and down from the top left corner.

#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/vec2.hpp>
#include <memory>
#include <vector>

#include "core/overdraw/edge_renderer.h"
#include "tests/gl/gbuffer/scene_fixture.h"
#include "tests/support/triangle_mesh.h"

namespace burin::overdraw {

using gbuffer::Attribute;
using gbuffer::Float;
using gbuffer::Orthographic;
using gbuffer::Perspective;
using gbuffer::Request;
using gbuffer::Square;
using gbuffer::TestScene;
using gbuffer::Translate;
using gbuffer::Unlit;
using gbuffer::Unorm;
using gl::Must;

inline constexpr float kPi = 3.14159265f;

/// Area of the pixel's square (x, y)..(x + 1, y + 1) where dot(n, p) > offset, by clipping (Sutherland and Hodgman
/// 1974).
inline double AreaBeyond(double nx, double ny, double offset, int x, int y) {
  const std::array<glm::dvec2, 4> square = {glm::dvec2(x, y), glm::dvec2(x + 1, y), glm::dvec2(x + 1, y + 1),
                                            glm::dvec2(x, y + 1)};
  std::vector<glm::dvec2> kept;
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::dvec2 a = square[i], b = square[(i + 1) % 4];
    const double da = nx * a.x + ny * a.y - offset, db = nx * b.x + ny * b.y - offset;
    if (da > 0) kept.push_back(a);
    if ((da > 0) != (db > 0)) kept.push_back(a + (b - a) * (da / (da - db)));
  }
  double area = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const glm::dvec2 a = kept[i], b = kept[(i + 1) % kept.size()];
    area += 0.5 * (a.x * b.y - a.y * b.x);
  }
  return area;
}

/// The half plane that a large square covers, in pixels: dot(n, p) > offset.
struct HalfPlane {
  glm::dvec2 normal;
  double offset;
  [[nodiscard]] double Area(int x, int y) const { return AreaBeyond(normal.x, normal.y, offset, x, y); }
  /// From the pixel's centre to the edge, along the normal.
  [[nodiscard]] double Distance(int x, int y) const { return normal.x * (x + 0.5) + normal.y * (y + 0.5) - offset; }
  /// Half of the square's extent along the normal.
  [[nodiscard]] double Extent() const { return 0.5 * (std::abs(normal.x) + std::abs(normal.y)); }
};

/// Where a line of view space shows in a picture of `view`, as a half plane whose surface holds `inside`.
inline HalfPlane Projected(const scene::View& view, int size, const glm::vec3& a, const glm::vec3& b,
                           const glm::vec3& inside) {
  const auto row = [&](const glm::vec3& p) {
    const glm::dvec4 clip = glm::dmat4(view.clip_from_view) * glm::dvec4(p, 1);
    return glm::dvec3(0.5 * size * (clip.x + clip.w), 0.5 * size * (clip.w - clip.y), clip.w);
  };
  glm::dvec3 line = glm::cross(row(a), row(b));  // dot(line, (x, y, 1)) == 0
  if (glm::dot(line, row(inside)) < 0) line = -line;
  line /= glm::length(glm::dvec2(line));
  return {glm::dvec2(line), -line.z};
}

class EdgeTest : public gbuffer::GbufferTest {
 protected:
  /// The scene at rest with edges as `options_` say, or without any stage for edges.
  Result<void> Draw(const TestScene& test, const scene::View& view, std::span<const Request> requests, EdgeMode mode) {
    const auto renderer = Must(gbuffer::SceneRenderer::Create(test.scene, nullptr));
    options_.mode = mode;
    const auto edges = EdgeRenderer::Create(test.scene, options_);
    return DrawWith(*renderer, *edges, test, view, requests);
  }
  Result<void> DrawWith(gbuffer::SceneRenderer& renderer, EdgeRenderer& edges, const TestScene& test,
                        const scene::View& view, std::span<const Request> requests) {
    const scene::Pose pose = scene::EvaluatePose(test.scene, {}, 0.0);
    const std::vector<scene::DrawItem> items = scene::BuildDrawItems(test.scene, pose, pose);
    gbuffer::FrameInput frame;
    frame.view = frame.previous_view = view;
    frame.pose = &pose;
    frame.items = items;
    frame.background = background_;
    frame.edges = &edges;
    edges.BeginFrame();
    return renderer.Render(frame, requests);
  }
  static void ExpectDone(const Result<void>& result) {
    EXPECT_TRUE(result.has_value()) << (result ? "" : result.error().message);
  }
  Picture DrawOne(const TestScene& test, const scene::View& view, EdgeMode mode, int width, int height,
                  Attribute attribute = Attribute::kColor, const gl::Format& format = Float(),
                  image::Encoding encoding = image::Encoding::kSceneLinear) {
    const gl::Texture target = Must(gl::Texture::Create(format, width, height, 1, "target"));
    const Request request{attribute, &target, encoding};
    ExpectDone(Draw(test, view, std::span(&request, 1), mode));
    return ReadPicture(target);
  }
  /// The means of k x k pixels of a plain rendering.
  Picture Reference(const TestScene& test, const scene::View& view, int k, int width, int height) {
    const Picture large = DrawOne(test, view, EdgeMode::kOff, width * k, height * k);
    Picture mean{.width = width, .channels = 4, .values = {}};
    mean.values.resize(static_cast<std::size_t>(4 * width * height));
    for (int y = 0; y < height * k; ++y) {
      for (int x = 0; x < width * k; ++x) {
        const auto from = static_cast<std::size_t>(4 * (y * width * k + x));
        const auto to = static_cast<std::size_t>(4 * (y / k * width + x / k));
        for (std::size_t c = 0; c < 4; ++c) mean.values[to + c] += large.values[from + c] / static_cast<float>(k * k);
      }
    }
    return mean;
  }

  /// A white square whose one edge passes the frame, half-size 1, at `angle_rad` and `offset` pixels off its middle.
  static TestScene Edge(float angle_rad, float offset, int size, float z = -3.0f) {
    TestScene test;
    test.AddNode(test.AddMesh(Square(test.AddMaterial(Unlit({1, 1, 1, 1})))), EdgeMatrix(angle_rad, offset, size, z));
    return test;
  }
  static glm::mat4 EdgeMatrix(float angle_rad, float offset, int size, float z) {
    // The left edge of a square of side 8 goes through the middle.
    return glm::rotate(Translate(0, 0, z), angle_rad, glm::vec3(0, 0, 1)) *
           Translate(4 + 2 * offset / static_cast<float>(size), 0, 0) * glm::scale(glm::mat4(1), glm::vec3(4, 4, 1));
  }
  static HalfPlane PlaneOf(float angle_rad, float offset, int size) {
    const glm::dvec2 normal(std::cos(static_cast<double>(angle_rad)), -std::sin(static_cast<double>(angle_rad)));
    return {normal, 0.5 * size * (normal.x + normal.y) + offset};
  }

  EdgeOptions options_;
};

/// The cube of side 2, each face of a colour and a primitive of its own.
inline TestScene ColoredCube() {
  TestScene test;
  const test::TriangleMesh cube = test::Cube();
  const glm::vec4 colors[] = {{1, 1, 1, 1},    {0.9f, 0.1f, 0.1f, 1}, {0.2f, 0.8f, 0.2f, 1},
                              {0, 0.2f, 1, 1}, {0.5f, 0.5f, 0, 1},    {0.3f, 0, 0.6f, 1}};
  scene::Mesh mesh;
  for (std::uint32_t face = 0; face < 6; ++face) {
    scene::Primitive side;
    side.positions.assign(cube.positions.begin() + 4 * face, cube.positions.begin() + 4 * face + 4);
    side.normals.assign(cube.normals.begin() + 4 * face, cube.normals.begin() + 4 * face + 4);
    side.indices = {0, 1, 2, 0, 2, 3};
    side.material = test.AddMaterial(Unlit(colors[face]));
    mesh.primitives.push_back(std::move(side));
  }
  test.scene.meshes.push_back(std::move(mesh));
  test.AddNode(0, Translate(0, 0, -4));
  return test;
}

}  // namespace burin::overdraw

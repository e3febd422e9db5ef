// SPDX-License-Identifier: Apache-2.0
#pragma once
// Attributes of edges of scenes made in code, and their closed forms. Pixels count from the top left corner.

#include <array>

#include "core/overdraw/edge_renderer.h"
#include "tests/gl/gbuffer/scene_fixture.h"

namespace burin::overdraw {

using gbuffer::Attribute;

/// Flat faces of four corners each, counter-clockwise seen from the front.
inline scene::Primitive Faces(const std::vector<std::array<glm::vec3, 4>>& quads, int material = scene::kNone) {
  scene::Primitive primitive;
  for (const auto& [a, b, c, d] : quads) {
    const auto base = static_cast<std::uint32_t>(primitive.positions.size());
    primitive.positions.insert(primitive.positions.end(), {a, b, c, d});
    primitive.normals.insert(primitive.normals.end(), 4, glm::normalize(glm::cross(b - a, d - a)));
    primitive.indices.insert(primitive.indices.end(), {base, base + 1, base + 2, base, base + 2, base + 3});
  }
  primitive.material = material;
  return primitive;
}

/// Side 2 about the origin.
inline scene::Primitive Box() {
  const auto p = [](int i) { return glm::vec3((i & 1) ? 1 : -1, (i & 2) ? 1 : -1, (i & 4) ? 1 : -1); };
  return Faces({{p(4), p(5), p(7), p(6)},
                {p(1), p(0), p(2), p(3)},
                {p(5), p(1), p(3), p(7)},
                {p(0), p(4), p(6), p(2)},
                {p(6), p(7), p(3), p(2)},
                {p(0), p(1), p(5), p(4)}});
}

using Point = glm::dvec2;

struct Line {
  Point a, b;
  /// Of (p beyond the ends, p across): 0 or more each.
  [[nodiscard]] Point Place(Point p) const {
    const double length = glm::length(b - a);
    const Point along = (b - a) / length;
    const double t = glm::dot(p - a, along);
    return {std::max({-t, t - length, 0.0}), std::abs(along.x * (p.y - a.y) - along.y * (p.x - a.x))};
  }
  [[nodiscard]] double Distance(Point p) const { return glm::length(Place(p)); }
  /// By a line one pixel wide with square ends.
  [[nodiscard]] double Coverage(Point p) const {
    const Point place = Place(p);
    return std::clamp(1.0 - place.x, 0.0, 1.0) * std::clamp(1.0 - place.y, 0.0, 1.0);
  }
};

inline double Distance(const std::vector<Line>& lines, Point p) {
  double least = 1e10;
  for (const Line& line : lines) least = std::min(least, line.Distance(p));
  return least;
}
inline double Coverage(const std::vector<Line>& lines, Point p) {
  double most = 0.0;
  for (const Line& line : lines) most = std::max(most, line.Coverage(p));
  return most;
}

class EdgeAttributeTest : public gbuffer::GbufferTest {
 protected:
  using Picture = gbuffer::GbufferTest::Picture;

  Picture RenderEdges(const gbuffer::TestScene& test, const scene::View& view, Attribute attribute, int width,
                      int height, const gl::Format& format = gbuffer::Float()) {
    const std::unique_ptr<EdgeRenderer> edges = EdgeRenderer::Create(test.scene, options_);
    edges->BeginFrame();
    edges_ = edges.get();
    Picture picture = Render(test, view, attribute, format, width, height);
    edges_ = nullptr;
    return picture;
  }

  static Point Project(const scene::View& view, const glm::vec3& world, int width, int height) {
    const glm::dvec4 clip = glm::dmat4(view.clip_from_view) * glm::dmat4(view.view_from_world) * glm::dvec4(world, 1.0);
    return {(clip.x / clip.w + 1.0) * 0.5 * width, (1.0 - clip.y / clip.w) * 0.5 * height};
  }

  EdgeOptions options_;
};

}  // namespace burin::overdraw

// SPDX-License-Identifier: Apache-2.0
// Slack of lines: half of a line lies over the edge's own faces, which may come nearer than the edge there by their
// slope. The paper pushes all triangles back by one polygon offset instead.
#include "core/overdraw/edge_records.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "core/overdraw/edge_shape.h"
#include "core/overdraw/screen_projection.h"
#include "core/overdraw/screen_segment.h"

namespace burin::overdraw {
namespace {

constexpr std::size_t kGrain = 512;
constexpr float kMargin = 2.0f;          // pixels round the picture
constexpr float kReach = 1.5f;           // pixels from the edge to the centres that its line covers
constexpr float kRelativeSlack = 4e-6f;  // of the rasterizer's interpolation
constexpr float kMostSlack = 0.02f;      // of the depth: faces seen edge on have any slope
// Shading changes slowly along an edge: that of one point will do for the shortest, the next is this many pixels off.
constexpr float kOnePoint = 2.0f;
constexpr float kPointSpacing = 8.0f;

/// A record, its faces and how many of both there are.
struct Built {
  std::array<EdgeRecord, 2> records{};
  std::array<gbuffer::FaceEdge, 2> faces{};
  std::uint8_t record_count = 0;
  std::uint8_t face_count = 0;
};

std::uint32_t PointsOf(const ScreenSegment& s) {
  const float length = std::hypot(s.b.x - s.a.x, s.b.y - s.a.y);
  return length <= kOnePoint ? 1 : 2 + static_cast<std::uint32_t>(length / kPointSpacing);
}

gbuffer::FaceEdge Face(const EdgeSegment& edge, bool is_left, const ScreenSegment& s) {
  gbuffer::FaceEdge face;
  face.item = is_left ? edge.left_item : edge.right_item;
  face.vertices = is_left ? edge.left_vertices : edge.right_vertices;
  face.is_back = is_left ? !edge.is_left_front : !edge.is_right_front;
  face.points = PointsOf(s);
  face.range = s.range;
  face.w = s.w;
  return face;
}

ScreenSegment Reversed(const ScreenSegment& s) { return {s.b, s.a, {s.range.y, s.range.x}, {s.w.y, s.w.x}}; }

EdgeRecord Record(const ScreenSegment& s, float slack, float kind, std::uint32_t points) {
  return {{s.a.x, s.a.y, s.b.x, s.b.y}, {s.a.z, s.b.z, slack, kind}, {0, 0, points, 0}};
}

Built Area(const EdgeSegment& edge, const PictureView& view, const Projection& projection) {
  Built built;
  const EdgeShape shape = ShapeOf(edge, projection);
  std::optional<ScreenSegment> cut = CutToPicture(shape.a, shape.b, projection, view.width, view.height, kMargin);
  if (!cut) return built;
  built.record_count = 1;
  if (shape.is_outline) {
    if (!shape.OutlineIsPositive(edge)) cut = Reversed(*cut);
    // The face that looks towards the eye, where both are on the screen: a double-sided mesh.
    const bool takes_left = edge.shows_left && (edge.is_left_front || !edge.shows_right);
    built.faces[0] = Face(edge, takes_left, *cut);
    built.face_count = 1;
  } else {
    built.faces[0] = Face(edge, shape.is_left_positive, *cut);
    built.faces[1] = Face(edge, !shape.is_left_positive, *cut);
    built.face_count = 2;
  }
  const float kind = !shape.is_outline ? 0.0f : edge.is_smooth ? kSmoothOutline : kSharpOutline;
  built.records[0] = Record(*cut, shape.fold_slack, kind, built.faces[0].points);
  return built;
}

float LineSlack(const EdgeSegment& edge, const glm::vec4& a, const glm::vec4& b, const Projection& projection) {
  float slope = 0.0f;
  if (edge.shows_left) slope = std::max(slope, projection.Slope(a, b, projection.Clip(edge.left_corner)));
  if (edge.shows_right) slope = std::max(slope, projection.Slope(a, b, projection.Clip(edge.right_corner)));
  const float depth = std::max(a.z / a.w, b.z / b.w);
  if (!(a.w > 0.0f) || !(b.w > 0.0f) || !std::isfinite(depth)) return 0.0f;
  return depth * kRelativeSlack + std::min(kReach * slope, kMostSlack * depth);
}

Built Line(const EdgeSegment& edge, const PictureView& view, const Projection& projection) {
  Built built;
  const glm::vec4 a = projection.Clip(edge.ends[0]);
  const glm::vec4 b = projection.Clip(edge.ends[1]);
  const std::optional<ScreenSegment> cut = CutToPicture(a, b, projection, view.width, view.height, kMargin);
  if (!cut) return built;
  const float slack = LineSlack(edge, a, b, projection);
  const bool begins_left = edge.beta < 0.5f;
  const float second = begins_left ? edge.beta : 1.0f - edge.beta;
  built.record_count = built.face_count = second > 0.0f ? 2 : 1;
  built.faces = {Face(edge, begins_left, *cut), Face(edge, !begins_left, *cut)};
  built.records = {Record(*cut, slack, 1.0f, built.faces[0].points),
                   Record(*cut, slack, second, built.faces[0].points)};
  return built;
}

template <class Build>
void BuildAll(std::span<const EdgeSegment> segments, const PictureView& view, const Build& build, EdgeRecords& out) {
  const Projection projection(view.clip_from_world, view.width, view.height);
  std::vector<Built> built(segments.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, segments.size(), kGrain),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t i = range.begin(); i < range.end(); ++i) {
                        built[i] = build(segments[i], view, projection);
                      }
                    });
  out.records.clear();
  out.faces.clear();
  for (const Built& one : built) {
    const auto face = static_cast<std::uint32_t>(out.faces.size());
    for (std::uint32_t i = 0; i < one.record_count; ++i) {
      out.records.push_back(one.records[i]);
      // Of two lines each has a face of its own; an area has one or both.
      out.records.back().shade.x = face + i;
      out.records.back().shade.y = face + one.face_count - 1u;
    }
    out.faces.insert(out.faces.end(), one.faces.begin(), one.faces.begin() + one.face_count);
  }
}

}  // namespace

void EdgeRecords::SetPlaces(std::span<const std::uint32_t> first) {
  for (EdgeRecord& record : records) {
    record.shade.x = first[record.shade.x];
    record.shade.y = first[record.shade.y];
  }
}

void BuildAreas(std::span<const EdgeSegment> segments, const PictureView& view, EdgeRecords& areas) {
  BuildAll(segments, view, Area, areas);
}

void BuildLines(std::span<const EdgeSegment> segments, const PictureView& view, EdgeRecords& lines) {
  BuildAll(segments, view, Line, lines);
}

}  // namespace burin::overdraw

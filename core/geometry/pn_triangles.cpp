// SPDX-License-Identifier: Apache-2.0
// Curved PN triangles (Vlachos et al. 2001, section 3). Deviations: where the two sides of an edge have different
// normals, each end's tangent is the edge projected on the line in which both planes meet, so that a crease stays
// closed and a cap stays flat (in the paper each side bends by its own normal, and the surface opens).
#include "core/geometry/pn_triangles.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numeric>
#include <tuple>

#include "core/geometry/weld.h"

namespace burin::geometry {
namespace {

constexpr std::uint32_t kNetSize = 10;    // a cubic triangle's control points
constexpr std::uint32_t kNormalSize = 6;  // a quadratic one's
constexpr std::size_t kGrain = 1024;

// Where a triangle's sides have their inner control points: from its corner k to k + 1, then near k + 1.
constexpr std::array<std::array<std::uint32_t, 2>, 3> kSidePoints = {{{1, 2}, {6, 8}, {7, 4}}};
constexpr std::array<std::uint32_t, 3> kCornerPoints = {0, 3, 9};
constexpr std::uint32_t kMiddlePoint = 5;
constexpr std::array<std::uint32_t, 3> kCornerNormals = {0, 2, 5};
constexpr std::array<std::uint32_t, 3> kSideNormals = {1, 4, 3};

// Sines between which an edge turns from smooth to creased; between nearly equal planes the line of intersection
// means nothing.
constexpr double kSmoothSine = 0.1736, kCreasedSine = 0.5;

std::uint32_t Next(std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }

// Adding +0 turns -0 into +0, so that equal points have equal bits.
glm::vec3 Point(const glm::vec3& p) { return p + 0.0f; }

glm::dvec3 UnitOrZero(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0.0 && std::isfinite(length) ? v / length : glm::dvec3(0.0);
}

glm::dvec3 OnPlane(const glm::dvec3& d, const glm::dvec3& normal) { return d - glm::dot(d, normal) * normal; }

/// The direction in which an edge leaves its end, as long as `d`. `normals`: of the faces on its sides, at that end.
glm::dvec3 Leaving(const glm::dvec3& d, std::span<const glm::dvec3> normals) {
  glm::dvec3 sum(0.0);
  for (const glm::dvec3& normal : normals) sum += OnPlane(d, normal);
  const glm::dvec3 mean = sum / static_cast<double>(normals.size());
  if (normals.size() != 2) return mean;
  const glm::dvec3 line = glm::cross(normals[0], normals[1]);
  const double sine = glm::length(line);
  const double t = std::clamp((sine - kSmoothSine) / (kCreasedSine - kSmoothSine), 0.0, 1.0);
  if (t <= 0.0) return mean;
  const glm::dvec3 along = line / sine;
  return glm::mix(mean, along * glm::dot(along, d), t * t * (3.0 - 2.0 * t));
}

template <class Body>
void ForEach(std::size_t count, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, kGrain), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) body(i);
  });
}

/// The values of `source` at the triangles' corners; empty when there are none.
template <class T>
std::vector<T> AtCorners(std::span<const T> source, std::span<const std::uint32_t> indices) {
  std::vector<T> values;
  if (source.empty()) return values;
  values.reserve(indices.size());
  for (const std::uint32_t index : indices) values.push_back(source[index]);
  return values;
}

BezierPatches MakePart(const PnPart& part) {
  BezierPatches patches;
  for (std::size_t set = 0; set < 2; ++set) patches.texcoords[set] = AtCorners(part.texcoords[set], part.indices);
  patches.colors = AtCorners(part.colors, part.indices);
  const auto triangles = static_cast<std::uint32_t>(part.indices.size() / 3);
  patches.patches.resize(triangles);
  for (std::uint32_t t = 0; t < triangles; ++t) {
    BezierPatch& patch = patches.patches[t];
    patch.domain = PatchDomain::kTriangle;
    patch.position = {.first = kNetSize * t, .u_order = 4, .v_order = 4};
    patch.normal = {.first = kNormalSize * t, .u_order = 3, .v_order = 3};
    for (std::size_t set = 0; set < 2; ++set) {
      if (!patches.texcoords[set].empty()) patch.texcoord[set] = {.first = 3 * t, .u_order = 2, .v_order = 2};
    }
    if (!patches.colors.empty()) patch.color = {.first = 3 * t, .u_order = 2, .v_order = 2};
    patch.face = t;
  }
  return patches;
}

std::uint32_t Root(std::vector<std::uint32_t>& parents, std::uint32_t i) {
  while (parents[i] != i) i = parents[i] = parents[parents[i]];
  return i;
}

}  // namespace

struct PnSurface::Frame {
  std::vector<glm::vec3> positions;  ///< one a corner
  std::vector<glm::vec3> normals;
};

PnSurface::PnSurface(std::span<const PnPart> parts, float crease_angle_deg) {
  std::vector<glm::vec3> corners;
  first_triangle_.push_back(0);
  bool makes_normals = false;
  for (const PnPart& part : parts) {
    for (const std::uint32_t index : part.indices) corners.push_back(Point(part.positions[index]));
    first_triangle_.push_back(static_cast<std::uint32_t>(corners.size() / 3));
    parts_.push_back(MakePart(part));
    indices_.emplace_back(part.indices.begin(), part.indices.end());
    has_normals_.push_back(part.has_normals);
    makes_normals |= !part.has_normals;
  }
  FindEdges(WeldPositions(corners));
  if (makes_normals) JoinSmoothCorners(corners, crease_angle_deg);
}

std::size_t PnSurface::PartOf(std::uint32_t triangle) const {
  return static_cast<std::size_t>(std::ranges::upper_bound(first_triangle_, triangle) - first_triangle_.begin()) - 1;
}

void PnSurface::FindEdges(std::span<const std::uint32_t> welded) {
  for (std::uint32_t corner = 0; corner < welded.size(); ++corner) {
    const std::uint32_t next = Next(corner);
    const bool runs_up = welded[corner] < welded[next];
    sides_.push_back(runs_up ? Side{corner, next} : Side{next, corner});
  }
  const auto key = [&](const Side& side) {
    return std::tuple(welded[side.low], welded[side.high], std::min(side.low, side.high), side.low);
  };
  std::ranges::sort(sides_, {}, key);
  for (std::uint32_t s = 0; s < sides_.size(); ++s) {
    const bool is_same = s > 0 && welded[sides_[s].low] == welded[sides_[s - 1].low] &&
                         welded[sides_[s].high] == welded[sides_[s - 1].high];
    if (!is_same) edge_begins_.push_back(s);
  }
  edge_begins_.push_back(static_cast<std::uint32_t>(sides_.size()));
}

// Corners that two faces share along a smooth edge shade alike: their classes are the fans between creases.
void PnSurface::JoinSmoothCorners(std::span<const glm::vec3> positions, float crease_angle_deg) {
  const double cosine = std::cos(glm::radians(static_cast<double>(crease_angle_deg)));
  const auto normal_of = [&](std::uint32_t corner) {
    const std::uint32_t first = corner / 3 * 3;
    const glm::dvec3 a(positions[first]);
    return UnitOrZero(glm::cross(glm::dvec3(positions[first + 1]) - a, glm::dvec3(positions[first + 2]) - a));
  };
  const auto makes = [&](std::uint32_t corner) { return !has_normals_[PartOf(corner / 3)]; };
  std::vector<std::uint32_t> parents(positions.size());
  std::iota(parents.begin(), parents.end(), 0u);
  for (std::size_t e = 0; e + 1 < edge_begins_.size(); ++e) {
    if (edge_begins_[e + 1] - edge_begins_[e] != 2) continue;
    const Side& a = sides_[edge_begins_[e]];
    const Side& b = sides_[edge_begins_[e] + 1];
    if (!makes(a.low) || !makes(b.low) || glm::dot(normal_of(a.low), normal_of(b.low)) < cosine) continue;
    parents[Root(parents, a.low)] = Root(parents, b.low);
    parents[Root(parents, a.high)] = Root(parents, b.high);
  }
  for (std::uint32_t corner = 0; corner < positions.size(); ++corner) {
    if (makes(corner)) joined_.push_back(corner);
  }
  std::vector<std::uint32_t> roots(positions.size());
  for (const std::uint32_t corner : joined_) roots[corner] = Root(parents, corner);
  std::ranges::sort(joined_, {}, [&](std::uint32_t corner) { return std::pair(roots[corner], corner); });
  for (std::uint32_t i = 0; i < joined_.size(); ++i) {
    if (i == 0 || roots[joined_[i]] != roots[joined_[i - 1]]) joined_begins_.push_back(i);
  }
  joined_begins_.push_back(static_cast<std::uint32_t>(joined_.size()));
}

// Face normals by the angle that each face has at the vertex (Thürmer and Wüthrich 1998): no matter how the faces
// around it are cut into triangles.
void PnSurface::MakeNormals(std::span<const glm::vec3> positions, std::span<glm::vec3> normals) const {
  if (joined_begins_.empty()) return;
  ForEach(joined_begins_.size() - 1, [&](std::size_t group) {
    const std::span<const std::uint32_t> corners(&joined_[joined_begins_[group]], &joined_[joined_begins_[group + 1]]);
    glm::dvec3 sum(0.0);
    for (const std::uint32_t corner : corners) {
      const glm::dvec3 at(positions[corner]);
      const glm::dvec3 a = UnitOrZero(glm::dvec3(positions[Next(corner)]) - at);
      const glm::dvec3 b = UnitOrZero(glm::dvec3(positions[Next(Next(corner))]) - at);
      const glm::dvec3 normal = glm::cross(a, b);
      sum += UnitOrZero(normal) * std::atan2(glm::length(normal), glm::dot(a, b));
    }
    const glm::vec3 unit(UnitOrZero(sum));
    for (const std::uint32_t corner : corners) normals[corner] = unit;
  });
}

glm::vec4* PnSurface::NetOf(std::uint32_t triangle) {
  const std::size_t part = PartOf(triangle);
  return &parts_[part].positions[std::size_t{kNetSize} * (triangle - first_triangle_[part])];
}

void PnSurface::PlaceEdge(std::span<const Side> sides, const Frame& frame) {
  // Sides that are apart in this pose are edges of their own.
  const auto same = [&](const Side& a, const Side& b) {
    return frame.positions[a.low] == frame.positions[b.low] && frame.positions[a.high] == frame.positions[b.high];
  };
  std::vector<glm::dvec3> low_normals, high_normals;
  for (std::size_t s = 0; s < sides.size(); ++s) {
    const auto is_same = [&](const Side& other) { return same(other, sides[s]); };
    if (std::any_of(sides.begin(), sides.begin() + static_cast<std::ptrdiff_t>(s), is_same)) continue;
    low_normals.clear();
    high_normals.clear();
    for (const Side& side : sides) {
      if (!is_same(side)) continue;
      low_normals.push_back(UnitOrZero(glm::dvec3(frame.normals[side.low])));
      high_normals.push_back(UnitOrZero(glm::dvec3(frame.normals[side.high])));
    }
    const glm::dvec3 low(frame.positions[sides[s].low]), high(frame.positions[sides[s].high]);
    const glm::vec3 near_low = Point(glm::vec3(low + Leaving(high - low, low_normals) / 3.0));
    const glm::vec3 near_high = Point(glm::vec3(high + Leaving(low - high, high_normals) / 3.0));
    for (const Side& side : sides) {
      if (!is_same(side)) continue;
      const bool runs_up = Next(side.low) == side.high;
      const std::array<std::uint32_t, 2>& points = kSidePoints[(runs_up ? side.low : side.high) % 3];
      glm::vec4* const net = NetOf(side.low / 3);
      net[points[runs_up ? 0 : 1]] = glm::vec4(near_low, 1.0f);
      net[points[runs_up ? 1 : 0]] = glm::vec4(near_high, 1.0f);
    }
  }
}

void PnSurface::PlaceTriangle(std::uint32_t triangle, const Frame& frame) {
  glm::vec4* const net = NetOf(triangle);
  const glm::vec3* const positions = &frame.positions[std::size_t{3} * triangle];
  const glm::vec3* const normals = &frame.normals[std::size_t{3} * triangle];
  glm::dvec3 corner_sum(0.0), side_sum(0.0);
  for (std::size_t k = 0; k < 3; ++k) {
    net[kCornerPoints[k]] = glm::vec4(positions[k], 1.0f);
    corner_sum += glm::dvec3(positions[k]);
    for (const std::uint32_t point : kSidePoints[k]) side_sum += glm::dvec3(net[point]);
  }
  // b111 of the paper: E + (E - V) / 2.
  net[kMiddlePoint] = glm::vec4(Point(glm::vec3(side_sum / 4.0 - corner_sum / 6.0)), 1.0f);

  const std::size_t part = PartOf(triangle);
  glm::vec3* const out = &parts_[part].normals[std::size_t{kNormalSize} * (triangle - first_triangle_[part])];
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    out[kCornerNormals[k]] = normals[k];
    const glm::dvec3 d = glm::dvec3(positions[next]) - glm::dvec3(positions[k]);
    const glm::dvec3 sum = glm::dvec3(normals[k]) + glm::dvec3(normals[next]);
    const double square = glm::dot(d, d);
    const glm::dvec3 turned = square > 0.0 ? sum - 2.0 * glm::dot(d, sum) / square * d : sum;
    // The paper's quadratic has no binomial factor: half its coefficient is the control point.
    out[kSideNormals[k]] = glm::vec3(0.5 * UnitOrZero(turned));
  }
}

void PnSurface::Pose(std::span<const PnPose> poses) {
  Frame frame;
  frame.positions.reserve(sides_.size());
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const std::size_t triangles = parts_[p].patches.size();
    parts_[p].positions.resize(kNetSize * triangles);
    parts_[p].normals.resize(kNormalSize * triangles);
    for (const std::uint32_t index : indices_[p]) {
      frame.positions.push_back(Point(poses[p].positions[index]));
      frame.normals.push_back(has_normals_[p] ? poses[p].normals[index] : glm::vec3(0.0f));
    }
  }
  MakeNormals(frame.positions, frame.normals);
  if (edge_begins_.empty()) return;
  ForEach(edge_begins_.size() - 1, [&](std::size_t e) {
    PlaceEdge({&sides_[edge_begins_[e]], sides_.data() + edge_begins_[e + 1]}, frame);
  });
  ForEach(first_triangle_.back(), [&](std::size_t t) { PlaceTriangle(static_cast<std::uint32_t>(t), frame); });
}

}  // namespace burin::geometry

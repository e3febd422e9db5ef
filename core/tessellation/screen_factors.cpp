// SPDX-License-Identifier: Apache-2.0
// Level of detail from each side's control polygon on the screen: it is at least as long as the curve, needs nothing
// but the side's control points, and changes continuously as the view does.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <glm/ext/matrix_double4x4.hpp>
#include <glm/ext/vector_double2.hpp>
#include <glm/ext/vector_double4.hpp>
#include <tuple>

#include "core/tessellation/boundary.h"
#include "core/tessellation/tessellate.h"

namespace burin::tessellation {
namespace {

using geometry::BezierPatch;
using geometry::BezierPatches;

/// Whether point a comes before b in the order that makes a side's direction its own, whichever patch it is seen from.
bool Precedes(const glm::vec4& a, const glm::vec4& b) {
  return std::tie(a.x, a.y, a.z, a.w) < std::tie(b.x, b.y, b.z, b.w);
}

bool RunsBackwards(const BezierPatches& patches, const BezierPatch& patch, std::uint32_t side) {
  for (std::uint32_t k = 0, last = SideOrder(patch, side) - 1; k < last; ++k, --last) {
    const glm::vec4& a = patches.positions[SidePoint(patch, side, k)];
    const glm::vec4& b = patches.positions[SidePoint(patch, side, last)];
    if (a != b) return Precedes(b, a);
  }
  return false;
}

/// Keeps what of the segment lies between the planes z = -w and z = w, so that w >= 0. One of them is the near plane in
/// every convention of clip space, reversed depth too, and the other is behind the eye or beyond everything. False:
/// nothing is left.
bool ClipDepth(glm::dvec4& a, glm::dvec4& b) {
  for (const double sign : {-1.0, 1.0}) {
    const double at_a = a.w + sign * a.z, at_b = b.w + sign * b.z;
    if (at_a < 0.0 && at_b < 0.0) return false;
    if (at_a < 0.0) a = b + (a - b) * (at_b / (at_b - at_a));
    if (at_b < 0.0) b = a + (b - a) * (at_a / (at_a - at_b));
  }
  return a.w > 0.0 && b.w > 0.0;
}

double SegmentPixels(glm::dvec4 a, glm::dvec4 b, const glm::dvec2& half_size) {
  if (!ClipDepth(a, b)) return 0.0;
  const double x = (a.x / a.w - b.x / b.w) * half_size.x, y = (a.y / a.w - b.y / b.w) * half_size.y;
  return std::sqrt(x * x + y * y);
}

double SidePixels(const BezierPatches& patches, const BezierPatch& patch, std::uint32_t side, const glm::dmat4& clip,
                  const glm::dvec2& half_size) {
  const std::uint32_t order = SideOrder(patch, side);
  const bool is_backwards = RunsBackwards(patches, patch, side);
  double pixels = 0.0;
  glm::dvec4 last(0.0);
  for (std::uint32_t k = 0; k < order; ++k) {
    glm::dvec4 point = patches.positions[SidePoint(patch, side, is_backwards ? order - 1 - k : k)];
    if (!patch.is_rational) point.w = 1.0;
    const glm::dvec4 at = clip * point;
    if (k > 0) pixels += SegmentPixels(last, at, half_size);
    last = at;
  }
  return pixels;
}

constexpr int kMostOrder = 8;

/// The mean length of the lines at 1/4, 1/2 and 3/4 of a quad, each by its control polygon. `along_v`: of lines of
/// constant u.
double InsidePixels(const BezierPatches& patches, const BezierPatch& patch, bool along_v, const glm::dmat4& clip,
                    const glm::dvec2& half_size) {
  const std::uint32_t order = along_v ? patch.position.v_order : patch.position.u_order;
  const std::uint32_t across = along_v ? patch.position.u_order : patch.position.v_order;
  std::array<std::array<glm::dvec4, kMostOrder>, kMostOrder> net;
  for (std::uint32_t k = 0; k < order; ++k) {
    for (std::uint32_t l = 0; l < across; ++l) {
      const std::uint32_t index = ValueIndex(patch.domain, patch.position, along_v ? l : k, along_v ? k : l);
      glm::dvec4 point = patches.positions[patch.position.first + index];
      if (!patch.is_rational) point.w = 1.0;
      net[k][l] = clip * point;
    }
  }
  double pixels = 0.0;
  for (const double t : {0.25, 0.5, 0.75}) {
    glm::dvec4 last(0.0);
    for (std::uint32_t k = 0; k < order; ++k) {
      std::array<glm::dvec4, kMostOrder> points = net[k];
      for (std::uint32_t left = across; left > 1; --left) {
        for (std::uint32_t l = 0; l + 1 < left; ++l) points[l] += t * (points[l + 1] - points[l]);
      }
      if (k > 0) pixels += SegmentPixels(last, points[0], half_size);
      last = points[0];
    }
  }
  return pixels / 3.0;
}

/// Strips between lines of different density shade worse than others, so the inside is cut like the denser side unless
/// it is wider by far. Continuous.
float InsideFactor(float inside, float denser) {
  constexpr float kAlike = 1.15f, kFar = 1.5f;
  const float ratio = inside / denser;
  if (ratio <= kAlike) return denser;
  return ratio >= kFar ? inside : denser * (1.0f + (kFar - 1.0f) * (ratio - kAlike) / (kFar - kAlike));
}

/// Whether all control points are beyond one border of the picture, by a twentieth of it for what is drawn wide, or
/// beyond one of the planes of ClipDepth.
bool IsInvisible(const BezierPatches& patches, const BezierPatch& patch, const glm::dmat4& clip) {
  constexpr double kBorder = 1.1;
  std::array<bool, 6> all_beyond;
  all_beyond.fill(true);
  for (std::uint32_t k = 0; k < ValueCount(patch.domain, patch.position); ++k) {
    glm::dvec4 point = patches.positions[patch.position.first + k];
    if (!patch.is_rational) point.w = 1.0;
    const glm::dvec4 at = clip * point;
    const double border = kBorder * at.w;
    const std::array<bool, 6> beyond{at.x > border,  -at.x > border, at.y > border,
                                     -at.y > border, at.z > at.w,    -at.z > at.w};
    for (std::size_t plane = 0; plane < beyond.size(); ++plane) all_beyond[plane] &= beyond[plane];
  }
  return std::ranges::any_of(all_beyond, [](bool is_beyond) { return is_beyond; });
}

}  // namespace

std::vector<Factors> ScreenFactors(const BezierPatches& patches, const ScreenMetric& metric, std::size_t* clamped) {
  const glm::dmat4 clip(metric.clip_from_object);
  const glm::dvec2 half_size(0.5 * metric.width, 0.5 * metric.height);
  const double most = static_cast<double>(kMaxFactor);
  std::vector<Factors> factors(patches.patches.size(), Factors{1.0f, 1.0f, 1.0f, 1.0f});
  std::atomic<std::size_t> over = 0;
  const auto measure = [&](std::size_t p) {
    const BezierPatch& patch = patches.patches[p];
    if (metric.skips_invisible && IsInvisible(patches, patch, clip)) return;
    const auto shapes = SideShapes(patches, patch);
    const auto factor_of = [&](double pixels) {
      const double factor = pixels / static_cast<double>(metric.edge_length_px);
      // False for NaN.
      return factor >= 1.0 ? static_cast<float>(std::min(factor, most)) : 1.0f;
    };
    for (std::uint32_t s = 0; s < SideCount(patch.domain); ++s) {
      if (shapes[s] == SideShape::kPoint) continue;
      const double pixels = SidePixels(patches, patch, s, clip, half_size);
      if (pixels > most * static_cast<double>(metric.edge_length_px)) over.fetch_add(1, std::memory_order_relaxed);
      factors[p][s] = factor_of(pixels);
    }
    if (patch.domain != geometry::PatchDomain::kQuad) return;
    for (const std::size_t k : {kInsideU, kInsideV}) {
      const std::size_t side = k == kInsideU ? 0 : 2;
      const float inside = factor_of(InsidePixels(patches, patch, k == kInsideV, clip, half_size));
      factors[p][k] = InsideFactor(inside, std::max(factors[p][side], factors[p][side + 1]));
    }
  };
  tbb::parallel_for(std::size_t{0}, factors.size(), measure);
  if (clamped != nullptr) *clamped = over;
  return factors;
}

}  // namespace burin::tessellation

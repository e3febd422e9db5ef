// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/edge_quality/edge_mask.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>

#include "core/gl/readback.h"

namespace burin::bench {
namespace {

using gbuffer::Attribute;

constexpr int kFiner = 4;
constexpr double kReach = 2.0;           // pixels
constexpr float kCreaseCosine = 0.966f;  // 15 degrees between neighbouring samples
constexpr float kColorStep = 0.05f;
constexpr float kDepthStep = 0.004f;  // of the frame's depth range, over what the slopes beside it explain

/// What the finer frame holds, row by row.
struct Surface {
  int size = 0;
  std::vector<float> object, material, primitive, depth, normal, color;
};

std::vector<float> Read(const gl::Texture& texture, int channels) {
  const image::Image image = gl::Read(texture, image::SampleType::kF32, channels, image::Encoding::kData);
  const auto samples = image.As<float>();
  return {samples.begin(), samples.end()};
}

Surface ReadSurface(Stand& stand, const Method& plain, const Place& place) {
  Surface surface;
  surface.size = stand.size() * kFiner;
  const struct {
    Attribute attribute;
    int components;
    std::vector<float>* values;
  } wanted[] = {{Attribute::kObjectId, 1, &surface.object},       {Attribute::kMaterialId, 1, &surface.material},
                {Attribute::kPrimitiveId, 1, &surface.primitive}, {Attribute::kDepth, 1, &surface.depth},
                {Attribute::kNormal, 4, &surface.normal},         {Attribute::kVertexColor, 4, &surface.color}};
  for (const auto& want : wanted) {  // one by one: together they would take half a gigabyte
    auto target = gl::Texture::Create(gl::PlainFormat(gl::Numeric::kFloat, 32, want.components), surface.size,
                                      surface.size, 1, "edge mask");
    if (!target) {
      fmt::print(stderr, "edge_quality: {}\n", target.error().message);
      std::exit(1);
    }
    const gbuffer::Request request{want.attribute, &*target, image::Encoding::kSceneLinear};
    stand.FillAttributes(plain, place, {&request, 1});
    *want.values = Read(*target, std::min(want.components, 3));
  }
  return surface;
}

float DepthRange(const Surface& surface) {
  float low = std::numeric_limits<float>::max();
  float high = std::numeric_limits<float>::lowest();
  for (std::size_t i = 0; i < surface.depth.size(); ++i) {
    if (surface.object[i] == 0.0f) continue;
    low = std::min(low, surface.depth[i]);
    high = std::max(high, surface.depth[i]);
  }
  return std::max(high - low, 0.0f);
}

glm::vec3 At(const std::vector<float>& triples, std::size_t i) {
  return {triples[3 * i], triples[3 * i + 1], triples[3 * i + 2]};
}

class EdgeFinder {
 public:
  explicit EdgeFinder(const Surface& surface) : surface_(surface), depth_step_(kDepthStep * DepthRange(surface)) {}

  /// Whether an edge passes between sample `i` and its neighbour `i + step`; the row or column runs from `first` to
  /// `last`.
  [[nodiscard]] bool Between(std::size_t i, std::size_t step, std::size_t first, std::size_t last) const {
    const std::size_t j = i + step;
    if (surface_.object[i] != surface_.object[j] || surface_.material[i] != surface_.material[j]) return true;
    if (surface_.primitive[i] == surface_.primitive[j]) return false;  // background too
    if (glm::dot(At(surface_.normal, i), At(surface_.normal, j)) < kCreaseCosine) return true;
    const glm::vec3 color = glm::abs(At(surface_.color, i) - At(surface_.color, j));
    if (std::max({color.r, color.g, color.b}) > kColorStep) return true;
    const std::vector<float>& depth = surface_.depth;
    const float before = i >= first + step ? std::abs(depth[i] - depth[i - step]) : 0.0f;
    const float after = j + step <= last ? std::abs(depth[j + step] - depth[j]) : 0.0f;
    const float jump = std::abs(depth[j] - depth[i]);
    // A slope that goes on explains a step; a lone sample's own jump on its other side does not.
    return jump > depth_step_ + 3.0f * std::min(before, after) && jump > 2.0f * std::max(before, after);
  }

 private:
  const Surface& surface_;
  float depth_step_;
};

void Mark(Mask& mask, int size, double x, double y) {
  const int left = std::max(0, static_cast<int>(std::floor(x - kReach - 0.5)));
  const int right = std::min(size - 1, static_cast<int>(std::ceil(x + kReach)));
  const int top = std::max(0, static_cast<int>(std::floor(y - kReach - 0.5)));
  const int bottom = std::min(size - 1, static_cast<int>(std::ceil(y + kReach)));
  for (int row = top; row <= bottom; ++row) {
    for (int column = left; column <= right; ++column) {
      const double dx = column + 0.5 - x;
      const double dy = row + 0.5 - y;
      if (dx * dx + dy * dy <= kReach * kReach) mask[static_cast<std::size_t>(row) * size + column] = 1;
    }
  }
}

}  // namespace

Mask EdgeMask(Stand& stand, const Method& plain, const Place& place) {
  const Surface surface = ReadSurface(stand, plain, place);
  const EdgeFinder finder(surface);
  const auto n = static_cast<std::size_t>(surface.size);
  Mask mask(static_cast<std::size_t>(stand.size()) * static_cast<std::size_t>(stand.size()), 0);
  for (std::size_t y = 0; y < n; ++y) {
    for (std::size_t x = 0; x < n; ++x) {
      const std::size_t i = y * n + x;
      if (x + 1 < n && finder.Between(i, 1, y * n, y * n + n - 1)) {
        Mark(mask, stand.size(), static_cast<double>(x + 1) / kFiner, (static_cast<double>(y) + 0.5) / kFiner);
      }
      if (y + 1 < n && finder.Between(i, n, x, (n - 1) * n + x)) {
        Mark(mask, stand.size(), (static_cast<double>(x) + 0.5) / kFiner, static_cast<double>(y + 1) / kFiner);
      }
    }
  }
  return mask;
}

}  // namespace burin::bench

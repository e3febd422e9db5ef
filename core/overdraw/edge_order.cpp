// SPDX-License-Identifier: Apache-2.0
// A binary partition: a range is cut across its principal axis (the direction of largest variance), at the largest
// power of two of leaves below its size, so that all subtrees but the last are full.
#include "core/overdraw/edge_order.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <bit>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

namespace burin::overdraw {
namespace {

constexpr std::size_t kSerialItems = 16384;
/// Enough points for the axis of a large range, whose exact direction matters less.
constexpr std::size_t kSampledItems = 4096;

struct Item {
  glm::vec4 point;
  float along;  ///< the axis of the present cut
  std::uint32_t index;
};

/// By power iteration on the covariance, begun from its largest column.
glm::vec4 PrincipalAxis(std::span<const Item> items) {
  constexpr int kIterations = 8;
  const std::size_t step = (items.size() + kSampledItems - 1) / kSampledItems;
  const glm::vec4 about = items[0].point;
  glm::vec4 mean(0);
  glm::mat4 squares(0);
  float count = 0;
  for (std::size_t i = 0; i < items.size(); i += step, ++count) {
    const glm::vec4 p = items[i].point - about;
    mean += p;
    for (int k = 0; k < 4; ++k) squares[k] += p[k] * p;
  }
  for (int k = 0; k < 4; ++k) squares[k] -= mean[k] / count * mean;
  int largest = 0;
  for (int k = 1; k < 4; ++k) {
    if (squares[k][k] > squares[largest][largest]) largest = k;
  }
  glm::vec4 axis = squares[largest];
  for (int i = 0; i < kIterations; ++i) {
    const float length = glm::length(axis);
    if (!(length > 0.0f)) return {1, 0, 0, 0};
    axis = squares * (axis / length);
  }
  return axis;
}

void Partition(std::span<Item> items, std::size_t leaf) {
  if (items.size() <= leaf) return;
  const std::size_t leaves = (items.size() + leaf - 1) / leaf;
  const std::size_t cut = std::bit_ceil(leaves) / 2 * leaf;
  const glm::vec4 axis = PrincipalAxis(items);
  for (Item& item : items) item.along = glm::dot(item.point, axis);
  std::nth_element(
      items.begin(), items.begin() + static_cast<std::ptrdiff_t>(cut), items.end(),
      [](const Item& a, const Item& b) { return a.along != b.along ? a.along < b.along : a.index < b.index; });
  const std::span<Item> low = items.first(cut), high = items.subspan(cut);
  if (items.size() <= kSerialItems) {
    Partition(low, leaf);
    Partition(high, leaf);
  } else {
    tbb::parallel_invoke([&] { Partition(low, leaf); }, [&] { Partition(high, leaf); });
  }
}

}  // namespace

std::vector<std::uint32_t> ClusterOrder(std::span<const glm::vec4> points, std::size_t leaf) {
  std::vector<Item> items(points.size());
  for (std::size_t i = 0; i < items.size(); ++i) items[i] = {points[i], 0.0f, static_cast<std::uint32_t>(i)};
  Partition(items, leaf);
  std::vector<std::uint32_t> order(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) order[i] = items[i].index;
  return order;
}

}  // namespace burin::overdraw

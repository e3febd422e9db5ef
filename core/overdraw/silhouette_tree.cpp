// SPDX-License-Identifier: Apache-2.0
// The search. Its node test is conservative against rounding, so that its result is the scan's, edge for edge. With
// u = 2^-24, x = eye - anchor, f = dot(axis, x) - cosine |x| and S = |eye| + radius (eye.w = 1):
// - eye - f / (1 + cosine) axis is still in the cone, so the eye is at least f sine / (1 + cosine) in front of every
//   plane, sine being the least dot(normal, axis); the nodes hold axis and cosine times that factor, 1 at most.
// - A leaf's facing value is off by at most 4 u S (four products, three sums, |normal| = 1, |offset| <= radius), a
//   rounded anchor moves every plane by 4 u radius, and f's roundings are 12 u |x|, |x| <= |eye| + 2 radius.
// All of it is below 32 u S = 1.9e-6 S. With eye.w = 0 the anchors and the radius drop out.
#include "core/overdraw/silhouette_tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "core/overdraw/silhouette_cone.h"

#if defined(__x86_64__)
#include <immintrin.h>
#define BURIN_AVX2 __attribute__((target("avx2")))
#endif

namespace burin::overdraw {
namespace {

constexpr float kMargin = 2.5e-6f;

float MarginFor(const glm::vec4& eye, float radius) {
  return kMargin * (std::sqrt(eye.x * eye.x + eye.y * eye.y + eye.z * eye.z) + radius * eye.w);
}

}  // namespace

/// One bit a child that may have silhouettes.
std::uint32_t SilhouetteTree::OpenChildren(const Node& node, const glm::vec4& eye, float margin) {
  std::uint32_t open = 0;
  for (std::size_t c = 0; c < kChildren; ++c) {
    const auto inside = [&](const float(&anchor)[3][kChildren], float sign) {
      const float x = eye.x - anchor[0][c] * eye.w, y = eye.y - anchor[1][c] * eye.w, z = eye.z - anchor[2][c] * eye.w;
      const float along = (x * node.axis[0][c] + y * node.axis[1][c] + z * node.axis[2][c]) * sign;
      return along - node.cosine[c] * std::sqrt(x * x + y * y + z * z) > margin;
    };
    if (!inside(node.front, 1.0f) && !inside(node.back, -1.0f)) open |= 1u << c;
  }
  return open;
}

void SilhouetteTree::SearchLeaf(const Leaf& leaf, const glm::vec4& eye, std::uint32_t first,
                                std::vector<std::uint32_t>& found) {
  const auto is_front = [&](const float(&planes)[4][kLeafEdges], std::size_t i) {
    return FacingValue({planes[0][i], planes[1][i], planes[2][i], planes[3][i]}, eye) > 0.0f;
  };
  for (std::uint32_t i = 0; i < kLeafEdges; ++i) {
    if (is_front(leaf.left, i) != is_front(leaf.right, i)) found.push_back(first + i);
  }
}

#if defined(__x86_64__)
namespace {

struct Eye8 {
  __m256 x, y, z, w;
};

BURIN_AVX2 inline Eye8 Spread(const glm::vec4& eye) {
  return {_mm256_set1_ps(eye.x), _mm256_set1_ps(eye.y), _mm256_set1_ps(eye.z), _mm256_set1_ps(eye.w)};
}

/// Which of eight children have the eye well inside the cone at `anchor`.
BURIN_AVX2 inline __m256 InsideCone(const Eye8& eye, const float (&anchor)[3][8], const __m256 (&axis)[3],
                                    __m256 cosine, __m256 margin) {
  const __m256 x = _mm256_sub_ps(eye.x, _mm256_mul_ps(_mm256_loadu_ps(anchor[0]), eye.w));
  const __m256 y = _mm256_sub_ps(eye.y, _mm256_mul_ps(_mm256_loadu_ps(anchor[1]), eye.w));
  const __m256 z = _mm256_sub_ps(eye.z, _mm256_mul_ps(_mm256_loadu_ps(anchor[2]), eye.w));
  const __m256 along =
      _mm256_add_ps(_mm256_add_ps(_mm256_mul_ps(x, axis[0]), _mm256_mul_ps(y, axis[1])), _mm256_mul_ps(z, axis[2]));
  const __m256 length =
      _mm256_sqrt_ps(_mm256_add_ps(_mm256_add_ps(_mm256_mul_ps(x, x), _mm256_mul_ps(y, y)), _mm256_mul_ps(z, z)));
  return _mm256_cmp_ps(_mm256_sub_ps(along, _mm256_mul_ps(cosine, length)), margin, _CMP_GT_OQ);
}

/// Facing of eight faces from `i` on.
BURIN_AVX2 inline __m256 Front8(const float (&planes)[4][SilhouetteTree::kLeafEdges], std::size_t i, const Eye8& eye) {
  const __m256 xy = _mm256_add_ps(_mm256_mul_ps(_mm256_loadu_ps(planes[0] + i), eye.x),
                                  _mm256_mul_ps(_mm256_loadu_ps(planes[1] + i), eye.y));
  const __m256 xyz = _mm256_add_ps(xy, _mm256_mul_ps(_mm256_loadu_ps(planes[2] + i), eye.z));
  const __m256 value = _mm256_add_ps(xyz, _mm256_mul_ps(_mm256_loadu_ps(planes[3] + i), eye.w));
  return _mm256_cmp_ps(value, _mm256_setzero_ps(), _CMP_GT_OQ);
}

}  // namespace

BURIN_AVX2 std::uint32_t SilhouetteTree::OpenChildrenAvx2(const Node& node, const glm::vec4& eye, float margin) {
  const __m256 axis[3] = {_mm256_loadu_ps(node.axis[0]), _mm256_loadu_ps(node.axis[1]), _mm256_loadu_ps(node.axis[2])};
  const __m256 flip = _mm256_set1_ps(-0.0f);
  const __m256 against[3] = {_mm256_xor_ps(axis[0], flip), _mm256_xor_ps(axis[1], flip), _mm256_xor_ps(axis[2], flip)};
  const __m256 cosine = _mm256_loadu_ps(node.cosine), margins = _mm256_set1_ps(margin);
  const Eye8 eyes = Spread(eye);
  const __m256 skipped = _mm256_or_ps(InsideCone(eyes, node.front, axis, cosine, margins),
                                      InsideCone(eyes, node.back, against, cosine, margins));
  return static_cast<std::uint32_t>(_mm256_movemask_ps(skipped)) ^ 0xFFu;
}

BURIN_AVX2 void SilhouetteTree::SearchLeafAvx2(const Leaf& leaf, const glm::vec4& eye, std::uint32_t first,
                                               std::vector<std::uint32_t>& found) {
  const Eye8 eyes = Spread(eye);
  for (std::uint32_t i = 0; i < kLeafEdges; i += 8) {
    const __m256 differ = _mm256_xor_ps(Front8(leaf.left, i, eyes), Front8(leaf.right, i, eyes));
    for (auto mask = static_cast<std::uint32_t>(_mm256_movemask_ps(differ)); mask != 0; mask &= mask - 1)
      found.push_back(first + i + static_cast<std::uint32_t>(std::countr_zero(mask)));
  }
}
#endif

std::size_t SilhouetteTree::Find(const glm::vec4& local_eye, bool uses_avx2, std::vector<std::uint32_t>& found) const {
  if (empty()) return 0;
  auto open_children = OpenChildren;
  auto search_leaf = SearchLeaf;
#if defined(__x86_64__)
  if (uses_avx2) {
    open_children = OpenChildrenAvx2;
    search_leaf = SearchLeafAvx2;
  }
#endif
  struct Open {
    std::uint32_t level, node;
  };
  // Every level leaves at most seven open siblings behind; 64-bit counts of edges have fewer than 22 levels.
  std::array<Open, 8 * 22> stack;
  std::size_t depth = 0, visited = 0;
  stack[depth++] = {static_cast<std::uint32_t>(levels_.size() - 1), 0};
  const float margin = MarginFor(local_eye, radius_);
  while (depth > 0) {
    const auto [level, node] = stack[--depth];
    const std::size_t children = (level == 0 ? leaves_.size() : levels_[level - 1].size()) - node * kChildren;
    std::uint32_t open = open_children(levels_[level][node], local_eye, margin);
    if (children < kChildren) open &= (1u << children) - 1;
    if (level > 0) {
      // Pushed from the last, so that the first comes next: edges are found in ascending order.
      while (open != 0) {
        const auto last = static_cast<std::uint32_t>(std::bit_width(open)) - 1;
        stack[depth++] = {level - 1, node * 8 + last};
        open ^= 1u << last;
      }
      continue;
    }
    for (; open != 0; open &= open - 1) {
      const std::uint32_t leaf = node * 8 + static_cast<std::uint32_t>(std::countr_zero(open));
      const std::size_t first = leaf * kLeafEdges;
      search_leaf(leaves_[leaf], local_eye, static_cast<std::uint32_t>(first), found);
      visited += std::min(kLeafEdges, edge_count_ - first);
    }
  }
  return visited;
}

}  // namespace burin::overdraw

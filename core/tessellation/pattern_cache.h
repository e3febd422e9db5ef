// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "core/tessellation/pattern.h"

namespace burin::tessellation {

/// What a pattern depends on, as one number: domain, pattern, the segments of each side and inside, which sides are
/// collapsed.
[[nodiscard]] std::uint64_t PatternKey(const PatchLayout& layout);

/// Indices that count from 0, kept for patches that are cut alike.
class PatternCache {
 public:
  using Indices = std::vector<std::uint32_t>;

  /// Patterns beyond this are not kept, and dropped by Trim.
  static constexpr std::size_t kMaxBytes = std::size_t{4} << 20;

  /// The pattern of this key, or null.
  [[nodiscard]] const Indices* Find(std::uint64_t key) const;
  [[nodiscard]] bool HasRoomFor(std::size_t indices) const { return bytes_ + 4 * indices <= kMaxBytes; }
  /// An empty pattern to fill, which must get `indices` at most. Stays where it is.
  [[nodiscard]] Indices& Add(std::uint64_t key, std::size_t indices);
  void Trim();

 private:
  std::unordered_map<std::uint64_t, std::unique_ptr<Indices>> patterns_;
  std::size_t bytes_ = 0;
};

/// Fills `indices` with the layout's pattern without the triangles of collapsed sides.
void MakePattern(const Kernels& kernels, const PatchLayout& layout, PatternCache::Indices& indices);

}  // namespace burin::tessellation

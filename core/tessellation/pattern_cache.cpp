// SPDX-License-Identifier: Apache-2.0
#include "core/tessellation/pattern_cache.h"

namespace burin::tessellation {

std::uint64_t PatternKey(const PatchLayout& layout) {
  std::uint64_t key = layout.domain == geometry::PatchDomain::kQuad ? 1 : 0;
  key = key << 1 | (layout.pattern == Pattern::kInteger ? 1u : 0u);
  for (std::uint32_t s = 0; s < 4; ++s) {
    static_assert(kMaxFactor < 512.0f, "a side's segments fit in 9 bits");
    key = key << 9 | (s < layout.side_count ? layout.sides[s].segments() : 0u);
    key = key << 1 | (layout.sides[s].is_collapsed() ? 1u : 0u);
  }
  if (layout.domain == geometry::PatchDomain::kQuad)
    key = key << 18 | layout.columns.segments() << 9 | layout.rows.segments();
  return key;
}

const PatternCache::Indices* PatternCache::Find(std::uint64_t key) const {
  const auto found = patterns_.find(key);
  return found == patterns_.end() ? nullptr : found->second.get();
}

PatternCache::Indices& PatternCache::Add(std::uint64_t key, std::size_t indices) {
  bytes_ += 4 * indices;
  return *patterns_.insert_or_assign(key, std::make_unique<Indices>()).first->second;
}

void PatternCache::Trim() {
  if (bytes_ <= kMaxBytes) return;
  patterns_.clear();
  bytes_ = 0;
}

void MakePattern(const Kernels& kernels, const PatchLayout& layout, PatternCache::Indices& indices) {
  indices.resize(std::size_t{3} * layout.triangle_count);
  WritePattern(kernels, layout, 0, indices.data());
  if (layout.HasCollapsedSide()) indices.resize(DropCollapsed(layout, indices.data(), indices.size()));
}

}  // namespace burin::tessellation

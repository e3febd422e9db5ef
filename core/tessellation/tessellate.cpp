// SPDX-License-Identifier: Apache-2.0
#include "core/tessellation/tessellate.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <memory>
#include <unordered_map>

#include "core/tessellation/boundary.h"
#include "core/tessellation/patch_evaluator.h"
#include "core/tessellation/pattern_cache.h"
#include "core/tessellation/stored_nets.h"

namespace burin::tessellation {
namespace {

using geometry::BezierPatch;
using geometry::BezierPatches;

/// What one patch writes, and from where on.
struct Share {
  std::uint32_t first_vertex = 0, vertex_count = 0;
  std::size_t first_index = 0, index_count = 0;
  std::uint64_t pattern_key = 0;
  std::array<SideShape, 4> shapes{};
  bool has_collapsed_side = false;
  const PatternCache::Indices* pattern = nullptr;  ///< null: the patch writes its own
};

float Clamped(float factor) {
  // The comparison is false for NaN.
  return factor >= 1.0f ? std::min(factor, kMaxFactor) : 1.0f;
}

PatchLayout LayoutOfPatch(const BezierPatch& patch, const std::array<SideShape, 4>& shapes, const Factors& factors,
                          Pattern pattern) {
  Factors clamped{};
  for (std::size_t k = 0; k < clamped.size(); ++k)
    clamped[k] = k < kInsideU || factors[k] > 0.0f ? Clamped(factors[k]) : 0.0f;
  return LayoutOf(patch.domain, pattern, clamped, shapes);
}

/// Layouts of one patch after the other, which often are alike.
class LayoutMaker {
 public:
  explicit LayoutMaker(Pattern pattern) : pattern_(pattern) {}

  /// Valid until the next call.
  [[nodiscard]] const PatchLayout& Make(const BezierPatch& patch, const std::array<SideShape, 4>& shapes,
                                        const Factors& factors) {
    if (!is_made_ || patch.domain != layout_.domain || factors != factors_ || shapes != shapes_) {
      layout_ = LayoutOfPatch(patch, shapes, factors, pattern_);
      factors_ = factors;
      shapes_ = shapes;
      is_made_ = true;
    }
    return layout_;
  }

 private:
  Pattern pattern_;
  PatchLayout layout_;
  Factors factors_{};
  std::array<SideShape, 4> shapes_{};
  bool is_made_ = false;
};

template <class Body>
void ForRange(std::size_t count, bool is_parallel, const Body& body) {
  if (!is_parallel) return body(std::size_t{0}, count);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count),
                    [&](const auto& range) { body(range.begin(), range.end()); });
}

/// What every patch needs but its place. Collapsed sides' triangles still count.
std::vector<Share> CountShares(const BezierPatches& patches, std::span<const Factors> factors, const Options& options) {
  std::vector<Share> shares(patches.patches.size());
  ForRange(shares.size(), options.is_parallel, [&](std::size_t begin, std::size_t end) {
    LayoutMaker layouts(options.pattern);
    for (std::size_t p = begin; p < end; ++p) {
      shares[p].shapes = SideShapes(patches, patches.patches[p]);
      const PatchLayout& layout = layouts.Make(patches.patches[p], shares[p].shapes, factors[p]);
      shares[p].vertex_count = layout.vertex_count;
      shares[p].index_count = std::size_t{3} * layout.triangle_count;
      shares[p].pattern_key = PatternKey(layout);
      shares[p].has_collapsed_side = layout.HasCollapsedSide();
    }
  });
  return shares;
}

/// Finds or makes the patterns that more than one patch has, and those of patches with collapsed sides, whose triangles
/// are counted by making them.
void SharePatterns(const BezierPatches& patches, std::span<const Factors> factors, const Options& options,
                   PatternCache& cache, std::vector<Share>& shares) {
  struct Missing {
    std::size_t patch;
    PatternCache::Indices* indices;
  };
  std::vector<Missing> missing;
  std::unordered_map<std::uint64_t, std::size_t> first_uses;
  for (std::size_t p = 0; p < shares.size(); ++p) {
    Share& share = shares[p];
    share.pattern = cache.Find(share.pattern_key);
    if (share.pattern != nullptr) continue;
    const auto [first, is_first] = first_uses.try_emplace(share.pattern_key, p);
    if (!share.has_collapsed_side && (is_first || !cache.HasRoomFor(share.index_count))) continue;
    missing.push_back({p, &cache.Add(share.pattern_key, share.index_count)});
    share.pattern = shares[first->second].pattern = missing.back().indices;
  }
  const Kernels& kernels = options.uses_avx2 ? Avx2Kernels() : PlainKernels();
  ForRange(missing.size(), options.is_parallel, [&](std::size_t begin, std::size_t end) {
    for (std::size_t m = begin; m < end; ++m) {
      const std::size_t p = missing[m].patch;
      MakePattern(kernels, LayoutOfPatch(patches.patches[p], shares[p].shapes, factors[p], options.pattern),
                  *missing[m].indices);
    }
  });
  for (Share& share : shares) {
    if (share.has_collapsed_side) share.index_count = share.pattern->size();
  }
}

SurfaceSize PlaceShares(std::vector<Share>& shares) {
  SurfaceSize size;
  for (Share& share : shares) {
    share.first_vertex = static_cast<std::uint32_t>(size.vertices);
    share.first_index = 3 * size.triangles;
    size.vertices += share.vertex_count;
    size.triangles += share.index_count / 3;
  }
  return size;
}

void WriteIndices(const Kernels& kernels, const PatchLayout& layout, const Share& share, std::uint32_t* indices) {
  if (share.pattern == nullptr) return WritePattern(kernels, layout, share.first_vertex, indices);
  kernels.shift_indices(share.pattern->data(), share.pattern->size(), share.first_vertex, indices);
}

void Resize(const BezierPatches& patches, const Options& options, const SurfaceSize& size, Surface& surface) {
  const auto resize = [&](auto& array, bool is_wanted) {
    const std::size_t count = is_wanted ? size.vertices : 0;
    // What an array held is of no use, so a larger one doesn't take it along.
    if (count > array.capacity()) array.clear();
    array.resize(count);
  };
  const auto any = [&](const auto& has) { return std::ranges::any_of(patches.patches, has); };
  resize(surface.positions, true);
  resize(surface.normals, true);
  resize(surface.tangents, options.wants_tangents);
  for (std::size_t t = 0; t < 2; ++t)
    resize(surface.texcoords[t], any([t](const BezierPatch& patch) { return static_cast<bool>(patch.texcoord[t]); }));
  resize(surface.colors, any([](const BezierPatch& patch) { return static_cast<bool>(patch.color); }));
  resize(surface.patch_uv, options.wants_patch_uv);
  resize(surface.patch_ids, options.wants_patch_ids);
  if (3 * size.triangles > surface.indices.capacity()) surface.indices.clear();
  surface.indices.resize(3 * size.triangles);
}

/// Some 300 KiB of nets and curves, kept for the next call.
PatchEvaluator& ThreadsEvaluator() {
  thread_local const auto evaluator = std::make_unique<PatchEvaluator>();
  return *evaluator;
}

}  // namespace

struct Tessellator::State {
  PatternCache patterns;
  StoredNets nets;
};

Tessellator::Tessellator() : state_(std::make_unique<State>()) {}
Tessellator::~Tessellator() = default;
Tessellator::Tessellator(Tessellator&&) noexcept = default;
Tessellator& Tessellator::operator=(Tessellator&&) noexcept = default;

void Tessellator::Tessellate(const BezierPatches& patches, std::span<const Factors> factors, const Options& options,
                             Surface& surface) {
  state_->patterns.Trim();
  state_->nets.Start(options.revision, patches.patches.size(), options.wants_tangents);
  std::vector<Share> shares = CountShares(patches, factors, options);
  SharePatterns(patches, factors, options, state_->patterns, shares);
  Resize(patches, options, PlaceShares(shares), surface);
  const Kernels& kernels = options.uses_avx2 ? Avx2Kernels() : PlainKernels();
  ForRange(shares.size(), options.is_parallel, [&](std::size_t begin, std::size_t end) {
    PatchEvaluator& evaluator = ThreadsEvaluator();
    evaluator.Configure(kernels, options.swatch_vertices, options.wants_tangents, surface);
    LayoutMaker layouts(options.pattern);
    for (std::size_t p = begin; p < end; ++p) {
      const PatchLayout& layout = layouts.Make(patches.patches[p], shares[p].shapes, factors[p]);
      evaluator.Evaluate(patches, p, layout, shares[p].first_vertex, state_->nets);
      WriteIndices(kernels, layout, shares[p], surface.indices.data() + shares[p].first_index);
    }
  });
}

void Tessellate(const BezierPatches& patches, std::span<const Factors> factors, const Options& options,
                Surface& surface) {
  Tessellator().Tessellate(patches, factors, options, surface);
}

SurfaceSize MeasureSurface(const BezierPatches& patches, std::span<const Factors> factors, Pattern pattern) {
  std::vector<Share> shares = CountShares(patches, factors, {.pattern = pattern});
  std::unordered_map<std::uint64_t, std::size_t> without_collapsed;
  PatternCache::Indices indices;
  for (std::size_t p = 0; p < shares.size(); ++p) {
    if (!shares[p].has_collapsed_side) continue;
    const auto [count, is_new] = without_collapsed.try_emplace(shares[p].pattern_key, 0);
    if (is_new) {
      MakePattern(PlainKernels(), LayoutOfPatch(patches.patches[p], shares[p].shapes, factors[p], pattern), indices);
      count->second = indices.size();
    }
    shares[p].index_count = count->second;
  }
  return PlaceShares(shares);
}

}  // namespace burin::tessellation

// SPDX-License-Identifier: Apache-2.0
#include "core/tessellation/tessellate.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <memory>

#include "core/tessellation/boundary.h"
#include "core/tessellation/patch_evaluator.h"
#include "core/tessellation/pattern.h"

namespace burin::tessellation {
namespace {

using geometry::BezierPatch;
using geometry::BezierPatches;

/// What one patch writes, and from where on.
struct Share {
  std::uint32_t first_vertex = 0, vertex_count = 0;
  std::size_t first_index = 0, index_count = 0;
};

float Clamped(float factor) {
  // The comparison is false for NaN.
  return factor >= 1.0f ? std::min(factor, kMaxFactor) : 1.0f;
}

PatchLayout LayoutOfPatch(const BezierPatches& patches, std::size_t p, const Factors& factors, Pattern pattern) {
  const BezierPatch& patch = patches.patches[p];
  const Factors clamped{Clamped(factors[0]), Clamped(factors[1]), Clamped(factors[2]), Clamped(factors[3])};
  return LayoutOf(patch.domain, pattern, clamped, CollapsedSides(patches, patch));
}

std::vector<std::uint32_t> IndicesWithoutCollapsed(const PatchLayout& layout) {
  std::vector<std::uint32_t> indices(std::size_t{3} * layout.triangle_count);
  WritePattern(layout, 0, indices.data());
  indices.resize(DropCollapsed(layout, indices.data(), indices.size()));
  return indices;
}

Share ShareOf(const PatchLayout& layout) {
  Share share{.vertex_count = layout.vertex_count, .index_count = std::size_t{3} * layout.triangle_count};
  if (layout.HasCollapsedSide()) share.index_count = IndicesWithoutCollapsed(layout).size();
  return share;
}

void WriteIndices(const PatchLayout& layout, const Share& share, std::uint32_t* indices) {
  if (!layout.HasCollapsedSide()) return WritePattern(layout, share.first_vertex, indices);
  const auto kept = IndicesWithoutCollapsed(layout);
  std::ranges::transform(kept, indices, [&](std::uint32_t index) { return share.first_vertex + index; });
}

template <class Body>
void ForRange(std::size_t count, bool is_parallel, const Body& body) {
  if (!is_parallel) return body(std::size_t{0}, count);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count),
                    [&](const auto& range) { body(range.begin(), range.end()); });
}

/// Also gives each share its place. The last one's ends are the sizes of the whole.
std::vector<Share> Shares(const BezierPatches& patches, std::span<const Factors> factors, Pattern pattern,
                          bool is_parallel) {
  std::vector<Share> shares(patches.patches.size());
  ForRange(shares.size(), is_parallel, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) shares[p] = ShareOf(LayoutOfPatch(patches, p, factors[p], pattern));
  });
  return shares;
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

/// Some 200 KiB of nets and curves, kept for the next call.
PatchEvaluator& ThreadsEvaluator() {
  thread_local const auto evaluator = std::make_unique<PatchEvaluator>();
  return *evaluator;
}

}  // namespace

SurfaceSize MeasureSurface(const BezierPatches& patches, std::span<const Factors> factors, Pattern pattern) {
  std::vector<Share> shares = Shares(patches, factors, pattern, true);
  return PlaceShares(shares);
}

void Tessellate(const BezierPatches& patches, std::span<const Factors> factors, const Options& options,
                Surface& surface) {
  std::vector<Share> shares = Shares(patches, factors, options.pattern, options.is_parallel);
  Resize(patches, options, PlaceShares(shares), surface);
  const Kernels& kernels = options.uses_avx2 ? Avx2Kernels() : PlainKernels();
  ForRange(shares.size(), options.is_parallel, [&](std::size_t begin, std::size_t end) {
    PatchEvaluator& evaluator = ThreadsEvaluator();
    evaluator.Configure(kernels, options.swatch_vertices, options.wants_tangents, surface);
    for (std::size_t p = begin; p < end; ++p) {
      const PatchLayout layout = LayoutOfPatch(patches, p, factors[p], options.pattern);
      evaluator.Evaluate(patches, patches.patches[p], layout, shares[p].first_vertex);
      WriteIndices(layout, shares[p], surface.indices.data() + shares[p].first_index);
    }
  });
}

}  // namespace burin::tessellation

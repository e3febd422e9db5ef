// SPDX-License-Identifier: Apache-2.0
#include "core/scene/item_tessellator.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>

#include "core/scene/item_geometry.h"

namespace burin::scene {
namespace {

/// Over a gigabyte of vertices and indices.
constexpr std::size_t kMostTriangles = 32'000'000;

const Material* MaterialOf(const Scene& scene, const Primitive& primitive) {
  return primitive.material == kNone ? nullptr : &scene.materials[static_cast<std::size_t>(primitive.material)];
}

bool WantsTangents(const Scene& scene, const Primitive& primitive) {
  if (!primitive.tangents.empty()) return true;
  const Material* const material = MaterialOf(scene, primitive);
  return material != nullptr && material->normal_texture && !material->unlit;
}

Result<void> CheckSize(std::size_t triangles) {
  if (triangles <= kMostTriangles) return {};
  return Fail(ErrorKind::kFailed,
              fmt::format("tessellation: {} triangles in a frame, over the limit of {}; a longer --edge-length or a "
                          "smaller --tessellation-factor gives fewer",
                          triangles, kMostTriangles));
}

void Renumber(const Scene& scene, std::vector<DrawItem>& items) {
  std::uint32_t next = 1;
  for (DrawItem& item : items) {
    const ItemGeometry geometry = GeometryOf(scene, item);
    item.first_primitive_id = next;
    next += ElementCount(geometry.mode, geometry.indices.size());
  }
}

}  // namespace

bool ItemTessellator::Curves(const Primitive& primitive) const {
  return primitive.mode == PrimitiveMode::kTriangles && !primitive.patches && !primitive.indices.empty() &&
         options_.curves_meshes();
}

tessellation::Pattern ItemTessellator::pattern() const {
  return options_.mode == TessellationMode::kInteger ? tessellation::Pattern::kInteger
                                                     : tessellation::Pattern::kFractional;
}

bool ItemTessellator::is_active() const {
  if (options_.mode == TessellationMode::kOff) return false;
  return std::ranges::any_of(scene_->meshes, [&](const Mesh& mesh) {
    return std::ranges::any_of(mesh.primitives, [&](const Primitive& p) { return p.patches || Curves(p); });
  });
}

void ItemTessellator::PoseCurved(Items of_space) {
  std::vector<const DrawItem*> items;
  for (const DrawItem& item : of_space) {
    if (Curves(PrimitiveOf(*scene_, item))) items.push_back(&item);
  }
  if (items.empty()) return;
  Curved& curved = curved_[SpaceOf(*items.front())];
  const bool is_deformed = items.front()->is_deformed;
  if (!curved.now) {
    std::vector<geometry::PnPart> parts;
    for (const DrawItem* item : items) {
      const Primitive& p = PrimitiveOf(*scene_, *item);
      parts.push_back({.indices = p.indices,
                       .positions = p.positions,
                       .has_normals = !p.has_made_normals,
                       .texcoords = {p.texcoords[0], p.texcoords[1]},
                       .colors = p.colors});
      curved.primitives.push_back(item->primitive);
    }
    curved.now = std::make_unique<geometry::PnSurface>(parts, options_.crease_angle_deg);
    if (is_deformed) curved.before = std::make_unique<geometry::PnSurface>(*curved.now);
  }
  if (curved.is_posed && !is_deformed) return;
  curved.is_posed = true;
  std::vector<geometry::PnPose> now, before;
  for (const DrawItem* item : items) {
    const ItemGeometry geometry = GeometryOf(*scene_, *item);
    now.push_back({geometry.positions, geometry.normals});
    before.push_back({item->deformed.previous_positions, item->deformed.previous_normals});
  }
  curved.now->Pose(now);
  if (is_deformed) curved.before->Pose(before);
}

ItemTessellator::Source ItemTessellator::SourceOf(const DrawItem& item) const {
  if (const auto& patches = PrimitiveOf(*scene_, item).patches) return {.now = patches.get(), .before = nullptr};
  const auto found = curved_.find(SpaceOf(item));
  if (found == curved_.end()) return {};
  const Curved& curved = found->second;
  const auto part = std::ranges::find(curved.primitives, item.primitive) - curved.primitives.begin();
  if (part == static_cast<std::ptrdiff_t>(curved.primitives.size())) return {};
  const auto index = static_cast<std::size_t>(part);
  return {.now = &curved.now->parts()[index], .before = curved.before ? &curved.before->parts()[index] : nullptr};
}

std::shared_ptr<ItemSurface> ItemTessellator::TakeSurface() {
  const auto is_free = [](const std::shared_ptr<ItemSurface>& surface) { return surface.use_count() == 1; };
  const auto found = std::ranges::find_if(surfaces_, is_free);
  // The last reader let go on another thread.
  std::atomic_thread_fence(std::memory_order_acquire);
  return found != surfaces_.end() ? *found : surfaces_.emplace_back(std::make_shared<ItemSurface>());
}

void ItemTessellator::Refine(const Source& source, FactorList factors, DrawItem& item) {
  Kept& kept = kept_[{item.node, item.primitive}];
  if (kept.patch_ids == 0) {
    for (const geometry::BezierPatch& patch : source.now->patches)
      kept.patch_ids = std::max(kept.patch_ids, patch.face + 1);
  }
  const bool is_still = source.before == nullptr;
  if (is_still && kept.surface && kept.factors == factors) {
    item.surface = kept.surface;
    return;
  }
  tessellation::Options options;
  options.pattern = pattern();
  options.wants_tangents = WantsTangents(*scene_, PrimitiveOf(*scene_, item));
  const std::shared_ptr<ItemSurface> surface = TakeSurface();
  // What is deformed has other control points in every frame.
  options.revision = is_still ? 1 : 0;
  kept.now.Tessellate(*source.now, factors, options, surface->triangles);
  surface->previous_positions.clear();
  if (!is_still && item.deformed.previous_positions != item.deformed.positions) {
    options.wants_tangents = false;
    kept.before.Tessellate(*source.before, factors, options, scratch_);
    // A side that collapses in one of the poses has other vertices there; such a frame's item stands still.
    if (scratch_.patch_uv == surface->triangles.patch_uv) surface->previous_positions = scratch_.positions;
  }
  kept.factors = std::move(factors);
  kept.surface = surface;
  item.surface = surface;
}

template <class FactorsOf>
Result<TessellationCounts> ItemTessellator::Run(std::vector<DrawItem>& items, const FactorsOf& factors_of) {
  TessellationCounts counts;
  for (std::size_t begin = 0, end = 0; begin < items.size(); begin = end) {
    const DrawItem& first = items[begin];
    while (end < items.size() && items[end].node == first.node && items[end].is_deformed == first.is_deformed) ++end;
    PoseCurved(Items(items).subspan(begin, end - begin));
  }
  std::uint32_t next_patch_id = 1;
  for (DrawItem& item : items) {
    const Source source = SourceOf(item);
    if (source.now == nullptr || source.now->patches.empty()) continue;
    FactorList factors = factors_of(*source.now, item, counts);
    counts.triangles += tessellation::MeasureSurface(*source.now, factors, pattern()).triangles;
    if (Result<void> fits = CheckSize(counts.triangles); !fits) return std::unexpected(fits.error());
    Refine(source, std::move(factors), item);
    item.first_patch_id = next_patch_id;
    next_patch_id += kept_.at({item.node, item.primitive}).patch_ids;
    counts.patches += source.now->patches.size();
  }
  Renumber(*scene_, items);
  return counts;
}

Result<TessellationCounts> ItemTessellator::TessellateEvenly(float factor, std::vector<DrawItem>& items) {
  return Run(items, [&](const geometry::BezierPatches& patches, const DrawItem&, TessellationCounts&) {
    return FactorList(patches.patches.size(), {factor, factor, factor, factor});
  });
}

Result<TessellationCounts> ItemTessellator::Tessellate(const View& view, int width, int height,
                                                       std::vector<DrawItem>& items) {
  if (options_.factor) return TessellateEvenly(*options_.factor, items);
  return Run(items, [&](const geometry::BezierPatches& patches, const DrawItem& item, TessellationCounts& counts) {
    tessellation::ScreenMetric metric;
    metric.clip_from_object = view.clip_from_view * view.view_from_world * item.world_from_object;
    metric.width = width;
    metric.height = height;
    metric.edge_length_px = options_.edge_length_px.value_or(metric.edge_length_px);
    std::size_t clamped = 0;
    FactorList factors = tessellation::ScreenFactors(patches, metric, &clamped);
    counts.clamped += clamped;
    return factors;
  });
}

}  // namespace burin::scene

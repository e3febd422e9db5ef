// SPDX-License-Identifier: Apache-2.0
#include "core/overdraw/scene_edges.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <numeric>
#include <optional>

#include "core/scene/item_geometry.h"

namespace burin::overdraw {
namespace {

using Items = std::span<const scene::DrawItem>;

template <class T>
void AppendPadded(std::vector<T>& all, std::span<const T> some, std::size_t size, const T& missing) {
  all.insert(all.end(), some.begin(), some.end());
  all.resize(size, missing);
}

/// The triangles of several primitives in a row, as MeshInput wants them.
struct JoinedMesh {
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::vec4> colors;
  std::array<std::vector<glm::vec2>, 2> texcoords;
  std::vector<std::uint32_t> triangles;
  std::vector<int> materials;
  std::vector<std::uint8_t> double_sided;

  bool is_curved = false;

  void Add(const scene::ItemGeometry& geometry, int material, bool is_double_sided) {
    const auto base = static_cast<std::uint32_t>(positions.size());
    positions.insert(positions.end(), geometry.positions.begin(), geometry.positions.end());
    const std::size_t size = positions.size();
    AppendPadded(normals, geometry.normals, size, glm::vec3(0.0f));
    AppendPadded(colors, geometry.colors, size, glm::vec4(1.0f));
    for (std::size_t set = 0; set < 2; ++set) {
      AppendPadded(texcoords[set], geometry.texcoords[set], size, glm::vec2(0.0f));
    }
    for (const std::uint32_t index : geometry.indices) triangles.push_back(base + index);
    const std::size_t faces = triangles.size() / 3;
    materials.resize(faces, material);
    double_sided.resize(faces, is_double_sided ? 1 : 0);
    is_curved |= !geometry.patch_ids.empty();
  }

  [[nodiscard]] MeshInput Input(std::string_view name) const {
    return {.name = name,
            .positions = positions,
            .normals = normals,
            .colors = colors,
            .texcoords = {texcoords[0], texcoords[1]},
            .triangles = triangles,
            .face_materials = materials,
            .face_double_sided = double_sided,
            .is_curved = is_curved};
  }
};

/// Where an object is seen from.
EdgeView ViewOf(const scene::View& view, const glm::mat4& world_from_object, const EdgeOptions& options) {
  const glm::dmat4 world_from_view = glm::inverse(glm::dmat4(view.view_from_world));
  const glm::dmat4 object_from_world = glm::inverse(glm::dmat4(world_from_object));
  EdgeView seen;
  seen.eye = glm::vec4(object_from_world * (view.orthographic ? world_from_view[2] : world_from_view[3]));
  seen.normal_matrix = glm::mat3(glm::transpose(glm::dmat3(object_from_world)));
  seen.eye_distance = -static_cast<float>((glm::dmat4(view.view_from_world) * glm::dmat4(world_from_object)[3]).z);
  seen.tau = options.tau;
  seen.sorted = options.mode == EdgeMode::kSorted;
  return seen;
}

std::string Describe(const EdgeMesh& mesh, bool is_curved) {
  const char* const way = is_curved           ? "a scan, as its triangles change"
                          : mesh.is_deformed  ? "a scan, as it moves"
                          : mesh.tree.empty() ? "a scan, as it is small"
                                              : "a tree";
  return fmt::format("mesh \"{}\": {} faces, {} edges, {} sharp, {} at boundaries; silhouettes by {}", mesh.name,
                     mesh.face_count(), mesh.edges.size(), mesh.sharp.size(), mesh.boundaries.size(), way);
}

bool HasSurface(Items items) {
  return std::ranges::any_of(items, [](const scene::DrawItem& item) { return item.surface != nullptr; });
}

}  // namespace

Result<SceneEdges::Object> SceneEdges::Build(Items items) {
  const scene::DrawItem& first = items.front();
  const std::string& mesh_name = scene_->meshes[static_cast<std::size_t>(first.mesh)].name;
  Object object;
  JoinedMesh joined;
  for (const scene::DrawItem& item : items) {
    const scene::Primitive& primitive = scene::PrimitiveOf(*scene_, item);
    object.surfaces.push_back(item.surface);
    object.first_vertex.push_back(static_cast<std::uint32_t>(joined.positions.size()));
    object.first_triangle.push_back(static_cast<std::uint32_t>(joined.triangles.size() / 3));
    if (primitive.mode != scene::PrimitiveMode::kTriangles) continue;
    const bool is_double_sided = primitive.material != scene::kNone &&
                                 scene_->materials[static_cast<std::size_t>(primitive.material)].double_sided;
    // Kinds, paths and concavity are those of the pose that the file holds, whatever frame is drawn first. Surfaces
    // have other triangles in every frame, and so all of it anew.
    scene::DrawItem at_rest;
    at_rest.mesh = item.mesh;
    at_rest.primitive = item.primitive;
    joined.Add(scene::GeometryOf(*scene_, item.surface ? item : at_rest), primitive.material, is_double_sided);
  }
  const std::string name = mesh_name.empty() ? fmt::format("#{}", first.mesh) : mesh_name;
  EdgeMeshOptions options;
  options.crease_angle_deg = options_.crease_angle_deg;
  options.keeps_concave = options_.mode == EdgeMode::kResolve;
  if (first.is_deformed || HasSurface(items)) options.least_tree_edges = kNoTree;
  Result<EdgeMesh> mesh = BuildEdgeMesh(joined.Input(name), options);
  if (!mesh) return std::unexpected(mesh.error());
  object.mesh = std::move(*mesh);
  return object;
}

Result<SceneEdges::Object*> SceneEdges::Prepare(Items items) {
  const scene::DrawItem& first = items.front();
  const bool has_surface = HasSurface(items);
  const bool is_of_node = first.is_deformed || has_surface;
  const std::pair key(is_of_node, is_of_node ? first.node : first.mesh);
  auto found = objects_.find(key);
  const bool is_new = found == objects_.end();
  if (is_new || (has_surface && !std::ranges::equal(items, found->second.surfaces, {}, &scene::DrawItem::surface))) {
    Result<Object> built = Build(items);
    if (!built) return std::unexpected(built.error());
    found = objects_.insert_or_assign(key, std::move(*built)).first;
  }
  Object& object = found->second;
  if (first.is_deformed && !has_surface) {
    std::vector<glm::vec3> positions;
    positions.reserve(object.mesh.positions.size());
    for (const scene::DrawItem& item : items) {
      if (scene::PrimitiveOf(*scene_, item).mode != scene::PrimitiveMode::kTriangles) continue;
      const std::vector<glm::vec3>& moved = item.deformed.positions;
      positions.insert(positions.end(), moved.begin(), moved.end());
    }
    UpdateDeformed(object.mesh, positions);
  }
  if (is_new && object.mesh.face_count() > 0) notes_.push_back(Describe(object.mesh, has_surface));
  return &object;
}

void SceneEdges::Append(const Object& object, Items items, std::uint32_t first_item, const scene::View& view) {
  const EdgeMesh& mesh = object.mesh;
  const glm::mat4& world_from_object = items.front().world_from_object;
  const EdgeView seen = ViewOf(view, world_from_object, options_);
  EdgeStatistics statistics;
  ExtractEdges(mesh, seen, rendered_, statistics);
  frame_.statistics += statistics;
  const auto world = [&](std::uint32_t vertex) {
    return glm::vec3(world_from_object * glm::vec4(mesh.positions[vertex], 1.0f));
  };
  const auto primitive_of = [&](std::uint32_t face) {
    const auto after = std::ranges::upper_bound(object.first_triangle, face);
    return static_cast<std::size_t>(after - object.first_triangle.begin()) - 1;
  };
  for (const RenderedEdge& rendered : rendered_) {
    const geometry::Edge& edge = mesh.edges[rendered.edge];
    const bool has_right = edge.right != geometry::kNoFace;
    EdgeSegment segment;
    segment.ends = {world(edge.corners_left[0]), world(edge.corners_left[1])};
    const std::size_t left = primitive_of(edge.left);
    const std::size_t right = has_right ? primitive_of(edge.right) : left;
    const auto vertices_of = [&](std::size_t primitive, std::uint32_t face,
                                 const std::array<std::uint32_t, 2>& corners) -> std::array<std::uint32_t, 3> {
      const std::uint32_t base = object.first_vertex[primitive];
      return {corners[0] - base, corners[1] - base, mesh.ThirdCorner(face, corners) - base};
    };
    segment.left_vertices = vertices_of(left, edge.left, edge.corners_left);
    segment.right_vertices = has_right ? vertices_of(right, edge.right, edge.corners_right) : segment.left_vertices;
    segment.left_corner = world(segment.left_vertices[2] + object.first_vertex[left]);
    segment.right_corner = world(segment.right_vertices[2] + object.first_vertex[right]);
    segment.left_item = first_item + static_cast<std::uint32_t>(left);
    segment.right_item = first_item + static_cast<std::uint32_t>(right);
    segment.edge_class = rendered.cls;
    segment.is_smooth = mesh.kinds[rendered.edge] == EdgeKind::kSmooth;
    segment.beta = rendered.beta;
    segment.is_left_front = rendered.is_front_left;
    segment.is_right_front = rendered.is_front_right;
    segment.shows_left = rendered.is_front_left || mesh.ShowsBack(edge.left);
    segment.shows_right = has_right && (rendered.is_front_right || mesh.ShowsBack(edge.right));
    frame_.segments.push_back(segment);
    keys_.emplace_back(rendered.is_sorted, rendered.distance2);
  }
}

void SceneEdges::Order() {
  std::vector<std::uint32_t> order(keys_.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, [&](std::uint32_t a, std::uint32_t b) {
    if (keys_[a].first != keys_[b].first) return !keys_[a].first;
    return keys_[a].first && keys_[a].second > keys_[b].second;
  });
  std::vector<EdgeSegment> ordered;
  ordered.reserve(order.size());
  for (const std::uint32_t i : order) ordered.push_back(frame_.segments[i]);
  frame_.segments = std::move(ordered);
}

Result<const FrameEdges*> SceneEdges::Extract(std::span<const scene::DrawItem> items, const scene::View& view) {
  frame_.segments.clear();
  frame_.statistics = {};
  keys_.clear();
  for (std::size_t begin = 0, end = 0; begin < items.size(); begin = end) {
    const auto shares_space = [&](const scene::DrawItem& item) {
      return item.node == items[begin].node && item.is_deformed == items[begin].is_deformed;
    };
    while (end < items.size() && shares_space(items[end])) ++end;
    const Items of_node = items.subspan(begin, end - begin);
    Result<Object*> object = Prepare(of_node);
    if (!object) return std::unexpected(object.error());
    Append(**object, of_node, static_cast<std::uint32_t>(begin), view);
  }
  if (options_.mode == EdgeMode::kSorted && options_.sorts_whole_scene) Order();
  return &frame_;
}

}  // namespace burin::overdraw

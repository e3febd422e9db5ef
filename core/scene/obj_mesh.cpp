// SPDX-License-Identifier: Apache-2.0
#include "core/scene/obj_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>
#include <unordered_map>
#include <unordered_set>

#include "core/geometry/polygon.h"

namespace burin::scene {
namespace {

/// Places among the vertices that were met before, in order of first use.
class Compactor {
 public:
  std::uint32_t operator()(std::uint32_t key) {
    const auto [found, is_new] = places_.try_emplace(key, static_cast<std::uint32_t>(keys_.size()));
    if (is_new) keys_.push_back(key);
    return found->second;
  }
  /// Where a key went, kNoIndex when it did not come.
  [[nodiscard]] std::uint32_t Find(std::uint32_t key) const {
    const auto found = places_.find(key);
    return found == places_.end() ? kNoIndex : found->second;
  }
  [[nodiscard]] const std::vector<std::uint32_t>& keys() const { return keys_; }

 private:
  std::unordered_map<std::uint32_t, std::uint32_t> places_;
  std::vector<std::uint32_t> keys_;
};

std::span<const ObjCorner> CornersOf(const ObjFile& file, const ObjPolygon& polygon) {
  return {&file.corners[polygon.first_corner], polygon.corners};
}

std::vector<glm::vec3> PointsOf(const ObjFile& file, const ObjPolygon& polygon) {
  std::vector<glm::vec3> points;
  for (const ObjCorner& corner : CornersOf(file, polygon)) points.push_back(file.positions[corner.position]);
  return points;
}

glm::vec3 UnitOrUp(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0.0 ? glm::vec3(v / length) : glm::vec3(0.0f, 0.0f, 1.0f);
}

double AngleAt(std::span<const glm::vec3> points, std::size_t k) {
  const std::size_t n = points.size();
  const glm::dvec3 at(points[k]);
  const glm::dvec3 a = glm::dvec3(points[(k + 1) % n]) - at, b = glm::dvec3(points[(k + n - 1) % n]) - at;
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// The normals of a group's faces: those of the file, the smoothing groups' and flat ones, by number.
class NormalTable {
 public:
  NormalTable(const ObjFile& file, const ObjGroup& group) : file_(file) {
    for (const std::uint32_t p : group.polygons) AddSmooth(file.polygons[p]);
    for (const std::size_t n : smooth_order_) normals_[n] = UnitOrUp(glm::dvec3(sums_[n]));
  }

  /// The number of a corner's normal.
  std::uint32_t NumberOf(const ObjPolygon& polygon, std::size_t k, const glm::vec3& flat) {
    const ObjCorner& corner = file_.corners[polygon.first_corner + k];
    if (HasNormal(corner)) return FromFile(corner.normal);
    if (polygon.smoothing_group > 0) return smooth_.at({corner.position, polygon.smoothing_group});
    if (flat_of_ != &polygon) {
      flat_of_ = &polygon;
      normals_.push_back(flat);
    }
    return static_cast<std::uint32_t>(normals_.size() - 1);
  }
  [[nodiscard]] const glm::vec3& Get(std::uint32_t number) const { return normals_[number]; }
  [[nodiscard]] bool has_given() const { return !given_.empty(); }
  [[nodiscard]] bool has_smooth() const { return !smooth_.empty(); }

 private:
  [[nodiscard]] bool HasNormal(const ObjCorner& corner) const {
    return corner.normal != kNoIndex && file_.normals[corner.normal] != glm::vec3(0.0f);
  }

  std::uint32_t FromFile(std::uint32_t index) {
    const auto [found, is_new] = given_.try_emplace(index, static_cast<std::uint32_t>(normals_.size()));
    if (is_new) {
      normals_.push_back(UnitOrUp(glm::dvec3(file_.normals[index])));
      flat_of_ = nullptr;
    }
    return found->second;
  }

  void AddSmooth(const ObjPolygon& polygon) {
    if (polygon.element != ObjElement::kFace || polygon.smoothing_group == 0) return;
    const std::vector<glm::vec3> points = PointsOf(file_, polygon);
    const glm::dvec3 normal = geometry::PolygonNormal(points);
    const double length = glm::length(normal);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const std::pair key(file_.corners[polygon.first_corner + k].position, polygon.smoothing_group);
      const auto [found, is_new] = smooth_.try_emplace(key, static_cast<std::uint32_t>(normals_.size()));
      if (is_new) {
        smooth_order_.push_back(normals_.size());
        normals_.emplace_back(0.0f);
        sums_.emplace_back(0.0);
      }
      if (length > 0.0) sums_[found->second] += normal / length * AngleAt(points, k);
    }
  }

  const ObjFile& file_;
  std::vector<glm::vec3> normals_;
  std::vector<glm::dvec3> sums_;  ///< one a smooth normal; those come first
  std::vector<std::size_t> smooth_order_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> smooth_;  ///< by position and group
  std::unordered_map<std::uint32_t, std::uint32_t> given_;                   ///< by the file's number
  const ObjPolygon* flat_of_ = nullptr;  ///< the polygon whose flat normal is the last of normals_
};

PrimitiveMode ModeOf(ObjElement element) {
  return element == ObjElement::kFace   ? PrimitiveMode::kTriangles
         : element == ObjElement::kLine ? PrimitiveMode::kLines
                                        : PrimitiveMode::kPoints;
}

class PrimitiveMaker {
 public:
  PrimitiveMaker(const ObjFile& file, const ObjGroup& group) : file_(file), normals_(file, group) {
    primitive_.mode = ModeOf(group.element);
  }

  void Add(const ObjPolygon& polygon) {
    const std::vector<glm::vec3> points = PointsOf(file_, polygon);
    const bool is_face = polygon.element == ObjElement::kFace;
    const glm::vec3 flat = is_face ? UnitOrUp(geometry::PolygonNormal(points)) : glm::vec3(0.0f);
    std::vector<std::uint32_t> vertices;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const std::uint32_t normal = is_face ? normals_.NumberOf(polygon, k, flat) : kNoIndex;
      vertices.push_back(Vertex(file_.corners[polygon.first_corner + k], normal));
    }
    std::vector<std::uint32_t> order;
    if (is_face) {
      geometry::TriangulatePolygon(points, order);
    } else {
      for (std::uint32_t k = 0; k < vertices.size(); ++k) {
        if (polygon.element == ObjElement::kLine && k > 0) order.push_back(k - 1);
        if (polygon.element == ObjElement::kPoint || k > 0) order.push_back(k);
      }
    }
    for (const std::uint32_t k : order) primitive_.indices.push_back(vertices[k]);
  }

  Primitive Finish() {
    primitive_.has_made_normals =
        primitive_.mode == PrimitiveMode::kTriangles && !normals_.has_given() && !normals_.has_smooth();
    if (!has_texcoords_) primitive_.texcoords[0].clear();
    return std::move(primitive_);
  }

 private:
  std::uint32_t Vertex(const ObjCorner& corner, std::uint32_t normal) {
    const auto [found, is_new] = vertices_.try_emplace(std::tuple(corner.position, corner.texcoord, normal),
                                                       static_cast<std::uint32_t>(primitive_.positions.size()));
    if (!is_new) return found->second;
    primitive_.positions.push_back(file_.positions[corner.position]);
    if (normal != kNoIndex) primitive_.normals.push_back(normals_.Get(normal));
    if (!file_.colors.empty()) primitive_.colors.emplace_back(file_.colors[corner.position], 1.0f);
    // glTF counts v from the picture's top.
    const bool has_texcoord = corner.texcoord != kNoIndex;
    const glm::vec2 t = has_texcoord ? file_.texcoords[corner.texcoord] : glm::vec2(0.0f, 1.0f);
    primitive_.texcoords[0].emplace_back(t.x, 1.0f - t.y);
    has_texcoords_ |= has_texcoord;
    return found->second;
  }

  const ObjFile& file_;
  NormalTable normals_;
  Primitive primitive_;
  std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>, std::uint32_t> vertices_;
  bool has_texcoords_ = false;
};

template <class See>
void ForFaces(const ObjFile& file, std::span<const ObjGroup> groups, const See& see) {
  std::uint32_t number = 0;
  for (const ObjGroup& group : groups) {
    if (group.element != ObjElement::kFace) continue;
    for (const std::uint32_t p : group.polygons) see(file.polygons[p], number);
    ++number;
  }
}

}  // namespace

std::vector<std::vector<ObjGroup>> GroupByObject(const ObjFile& file) {
  std::vector<std::vector<ObjGroup>> objects(file.objects.size());
  std::map<std::tuple<std::uint32_t, ObjElement, std::uint32_t>, std::size_t> places;
  for (std::uint32_t p = 0; p < file.polygons.size(); ++p) {
    const ObjPolygon& polygon = file.polygons[p];
    std::vector<ObjGroup>& groups = objects[polygon.object];
    const auto [found, is_new] = places.try_emplace({polygon.object, polygon.element, polygon.material}, groups.size());
    if (is_new) groups.push_back({polygon.element, polygon.material, {}});
    groups[found->second].polygons.push_back(p);
  }
  return objects;
}

Primitive MakePrimitive(const ObjFile& file, const ObjGroup& group) {
  PrimitiveMaker maker(file, group);
  for (const std::uint32_t p : group.polygons) maker.Add(file.polygons[p]);
  return maker.Finish();
}

bool IsCage(const ObjFile& file, std::span<const ObjGroup> groups) {
  bool has_faces = false, is_quads = true, is_tagged = false;
  std::unordered_set<std::uint32_t> tagged;
  for (const ObjFile::Crease& crease : file.creases) tagged.insert(crease.positions[0]);
  for (const ObjFile::SharpVertex& sharp : file.sharp_vertices) tagged.insert(sharp.position);
  ForFaces(file, groups, [&](const ObjPolygon& polygon, std::uint32_t) {
    has_faces = true;
    is_quads &= polygon.corners == 4;
    for (const ObjCorner& corner : CornersOf(file, polygon)) {
      is_quads &= corner.normal == kNoIndex;
      is_tagged = is_tagged || tagged.contains(corner.position);
    }
  });
  return has_faces && (is_quads || is_tagged);
}

geometry::SubdivisionCage MakeCage(const ObjFile& file, std::span<const ObjGroup> groups) {
  geometry::SubdivisionCage cage;
  Compactor positions, texcoords;
  bool has_texcoords = true;
  ForFaces(file, groups, [&](const ObjPolygon& polygon, std::uint32_t group) {
    cage.face_sizes.push_back(polygon.corners);
    cage.face_groups.push_back(group);
    for (const ObjCorner& corner : CornersOf(file, polygon)) {
      cage.corners.push_back(positions(corner.position));
      has_texcoords &= corner.texcoord != kNoIndex;
      if (has_texcoords) cage.texcoord_corners.push_back(texcoords(corner.texcoord));
    }
  });
  for (const std::uint32_t position : positions.keys()) cage.positions.push_back(file.positions[position]);
  if (has_texcoords) {
    for (const std::uint32_t t : texcoords.keys()) {
      cage.texcoords.emplace_back(file.texcoords[t].x, 1.0f - file.texcoords[t].y);
    }
  } else {
    cage.texcoord_corners.clear();
  }
  for (const ObjFile::Crease& crease : file.creases) {
    const std::uint32_t a = positions.Find(crease.positions[0]), b = positions.Find(crease.positions[1]);
    if (a != kNoIndex && b != kNoIndex) cage.creases.push_back({{a, b}, crease.sharpness});
  }
  for (const ObjFile::SharpVertex& sharp : file.sharp_vertices) {
    if (const std::uint32_t v = positions.Find(sharp.position); v != kNoIndex) {
      cage.sharp_vertices.push_back({v, sharp.sharpness});
    }
  }
  return cage;
}

}  // namespace burin::scene

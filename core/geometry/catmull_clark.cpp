// SPDX-License-Identifier: Apache-2.0
// Catmull and Clark 1978; irregular faces as in Loop, Schaefer, Ni, Castano, "Approximating Subdivision Surfaces with
// Gregory Patches" (2009), which OpenSubdiv evaluates. Uniform refinement instead of feature-adaptive: patches of two
// levels would meet in T-junctions, and the tessellator needs the same control points on both sides of every boundary.
#include "core/geometry/catmull_clark.h"

#include <fmt/format.h>
#include <opensubdiv/far/error.h>
#include <opensubdiv/far/patchMap.h>
#include <opensubdiv/far/patchTableFactory.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <optional>
#include <span>

namespace burin::geometry {
namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

constexpr std::size_t kMostPatches = 4'000'000;
/// Refined this far, an irregular face's patch is within 3e-4 of the cage's size of the surface (tests/unit/geometry).
constexpr int kGoodLevel = 2;
constexpr int kMostLevels = 4;
constexpr std::size_t kPatchesForDetail = 20'000;

struct Point {
  glm::dvec3 p{0.0};
  void Clear(void* = nullptr) { p = glm::dvec3(0.0); }
  void AddWithWeight(const Point& other, double weight) { p += other.p * weight; }
};

struct Texcoord {
  glm::dvec2 t{0.0};
  void Clear(void* = nullptr) { t = glm::dvec2(0.0); }
  void AddWithWeight(const Texcoord& other, double weight) { t += other.t * weight; }
};

using RefinerPointer = std::unique_ptr<Far::TopologyRefiner>;

/// Index arrays as OpenSubdiv takes them, alive while a refiner is made.
struct Topology {
  std::vector<int> sizes, corners, texcoord_corners, crease_pairs, sharp_vertices;
  std::vector<float> crease_sharpness, vertex_sharpness;
  int vertex_count = 0, texcoord_count = 0;
};

void Ignore(Far::ErrorType, const char*) {}
void IgnoreWarning(const char*) {}

RefinerPointer MakeRefiner(const Topology& topology) {
  Far::SetErrorCallback(Ignore);  // the return value says it; the library would print
  Far::SetWarningCallback(IgnoreWarning);
  Far::TopologyDescriptor descriptor;
  descriptor.numVertices = topology.vertex_count;
  descriptor.numFaces = static_cast<int>(topology.sizes.size());
  descriptor.numVertsPerFace = topology.sizes.data();
  descriptor.vertIndicesPerFace = topology.corners.data();
  descriptor.numCreases = static_cast<int>(topology.crease_sharpness.size());
  descriptor.creaseVertexIndexPairs = topology.crease_pairs.data();
  descriptor.creaseWeights = topology.crease_sharpness.data();
  descriptor.numCorners = static_cast<int>(topology.vertex_sharpness.size());
  descriptor.cornerVertexIndices = topology.sharp_vertices.data();
  descriptor.cornerWeights = topology.vertex_sharpness.data();
  Far::TopologyDescriptor::FVarChannel channel;
  channel.numValues = topology.texcoord_count;
  channel.valueIndices = topology.texcoord_corners.data();
  if (!topology.texcoord_corners.empty()) {
    descriptor.numFVarChannels = 1;
    descriptor.fvarChannels = &channel;
  }
  Sdc::Options options;
  options.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
  options.SetFVarLinearInterpolation(Sdc::Options::FVAR_LINEAR_CORNERS_ONLY);
  using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
  Factory::Options creation(Sdc::SCHEME_CATMARK, options);
  creation.validateFullTopology = true;
  return RefinerPointer(Factory::Create(descriptor, creation));
}

Topology TopologyOf(const SubdivisionCage& cage) {
  Topology topology;
  topology.vertex_count = static_cast<int>(cage.positions.size());
  topology.texcoord_count = static_cast<int>(cage.texcoords.size());
  topology.sizes.assign(cage.face_sizes.begin(), cage.face_sizes.end());
  topology.corners.assign(cage.corners.begin(), cage.corners.end());
  topology.texcoord_corners.assign(cage.texcoord_corners.begin(), cage.texcoord_corners.end());
  for (const SubdivisionCage::Crease& crease : cage.creases) {
    topology.crease_pairs.insert(topology.crease_pairs.end(), crease.vertices.begin(), crease.vertices.end());
    topology.crease_sharpness.push_back(crease.sharpness);
  }
  for (const SubdivisionCage::SharpVertex& sharp : cage.sharp_vertices) {
    topology.sharp_vertices.push_back(static_cast<int>(sharp.vertex));
    topology.vertex_sharpness.push_back(sharp.sharpness);
  }
  return topology;
}

/// How often the cage is refined; deep enough for its semi-sharp creases to wear off, as far as that stays small.
int LevelOf(const SubdivisionCage& cage) {
  float sharpest = 0.0f;
  for (const SubdivisionCage::Crease& crease : cage.creases) {
    if (crease.sharpness < Sdc::Crease::SHARPNESS_INFINITE) sharpest = std::max(sharpest, crease.sharpness);
  }
  const int wanted = std::clamp(static_cast<int>(std::ceil(sharpest)), kGoodLevel, kMostLevels);
  int level = 1;
  for (std::size_t patches = 4 * cage.corners.size(); level < wanted && patches <= kPatchesForDetail; patches *= 4) {
    ++level;
  }
  return level;
}

/// The cage after uniform refinement: quads only.
struct RefinedMesh {
  Topology topology;
  std::vector<Point> points;
  std::vector<Texcoord> texcoords;
  std::vector<std::uint32_t> control_faces;  ///< one a quad
};

Topology TopologyOf(const Far::TopologyLevel& level, bool has_texcoords) {
  Topology topology;
  topology.vertex_count = level.GetNumVertices();
  for (int f = 0; f < level.GetNumFaces(); ++f) {
    const Far::ConstIndexArray vertices = level.GetFaceVertices(f);
    topology.sizes.push_back(vertices.size());
    topology.corners.insert(topology.corners.end(), vertices.begin(), vertices.end());
    if (!has_texcoords) continue;
    const Far::ConstIndexArray values = level.GetFaceFVarValues(f, 0);
    topology.texcoord_corners.insert(topology.texcoord_corners.end(), values.begin(), values.end());
  }
  if (has_texcoords) topology.texcoord_count = level.GetNumFVarValues(0);
  for (int e = 0; e < level.GetNumEdges(); ++e) {
    if (!(level.GetEdgeSharpness(e) > 0.0f)) continue;
    const Far::ConstIndexArray ends = level.GetEdgeVertices(e);
    topology.crease_pairs.insert(topology.crease_pairs.end(), ends.begin(), ends.end());
    topology.crease_sharpness.push_back(level.GetEdgeSharpness(e));
  }
  for (int v = 0; v < level.GetNumVertices(); ++v) {
    if (!(level.GetVertexSharpness(v) > 0.0f)) continue;
    topology.sharp_vertices.push_back(v);
    topology.vertex_sharpness.push_back(level.GetVertexSharpness(v));
  }
  return topology;
}

std::optional<RefinedMesh> Refine(const SubdivisionCage& cage) {
  const RefinerPointer refiner = MakeRefiner(TopologyOf(cage));
  if (!refiner) return std::nullopt;
  const int levels = LevelOf(cage);
  Far::TopologyRefiner::UniformOptions options(levels);
  options.fullTopologyInLastLevel = true;
  refiner->RefineUniform(options);
  const Far::PrimvarRefinerReal<double> primvar(*refiner);
  const bool has_texcoords = !cage.texcoord_corners.empty();
  RefinedMesh mesh;
  for (const glm::vec3& p : cage.positions) mesh.points.push_back({glm::dvec3(p)});
  for (const glm::vec2& t : cage.texcoords) mesh.texcoords.push_back({glm::dvec2(t)});
  for (std::uint32_t f = 0; f < cage.face_sizes.size(); ++f) mesh.control_faces.push_back(f);
  for (int l = 1; l <= levels; ++l) {
    const Far::TopologyLevel level = refiner->GetLevel(l);
    std::vector<Point> points(static_cast<std::size_t>(level.GetNumVertices()));
    primvar.Interpolate(l, mesh.points, points);
    mesh.points = std::move(points);
    if (has_texcoords) {
      std::vector<Texcoord> texcoords(static_cast<std::size_t>(level.GetNumFVarValues(0)));
      primvar.InterpolateFaceVarying(l, mesh.texcoords, texcoords, 0);
      mesh.texcoords = std::move(texcoords);
    }
    std::vector<std::uint32_t> faces(static_cast<std::size_t>(level.GetNumFaces()));
    for (int f = 0; f < level.GetNumFaces(); ++f) {
      faces[static_cast<std::size_t>(f)] = mesh.control_faces[static_cast<std::size_t>(level.GetFaceParentFace(f))];
    }
    mesh.control_faces = std::move(faces);
  }
  mesh.topology = TopologyOf(refiner->GetLevel(levels), has_texcoords);
  return mesh;
}

/// A point of the limit surface with its derivatives.
struct Limit {
  glm::dvec3 p{0.0}, du{0.0}, dv{0.0};
};

/// Limit evaluation of the refined mesh, face by face.
class LimitSurface {
 public:
  [[nodiscard]] bool Build(const RefinedMesh& mesh) {
    Topology topology = mesh.topology;
    topology.texcoord_corners.clear();
    refiner_ = MakeRefiner(topology);
    if (!refiner_) return false;
    Far::PatchTableFactory::Options options(0);
    options.SetEndCapType(Far::PatchTableFactory::Options::ENDCAP_GREGORY_BASIS);
    options.useInfSharpPatch = true;
    options.SetPatchPrecision<double>();
    refiner_->RefineAdaptive(options.GetRefineAdaptiveOptions());
    table_.reset(Far::PatchTableFactory::Create(*refiner_, options));
    if (!table_) return false;
    map_ = std::make_unique<Far::PatchMap>(*table_);
    points_ = mesh.points;
    const std::size_t refined = static_cast<std::size_t>(refiner_->GetNumVerticesTotal());
    points_.resize(refined + static_cast<std::size_t>(table_->GetNumLocalPoints()));
    if (table_->GetNumLocalPoints() > 0) {
      Point* const local = &points_[refined];
      table_->GetLocalPointStencilTable<double>()->UpdateValues(points_.data(), local);
    }
    return true;
  }

  [[nodiscard]] Limit At(int face, double u, double v) const {
    const Far::PatchTable::PatchHandle* const handle = map_->FindPatch(face, u, v);
    Limit limit;
    if (handle == nullptr) return limit;
    double wp[20], wu[20], wv[20];
    table_->EvaluateBasis(*handle, u, v, wp, wu, wv);
    const Far::ConstIndexArray vertices = table_->GetPatchVertices(*handle);
    for (int i = 0; i < vertices.size(); ++i) {
      const glm::dvec3& p = points_[static_cast<std::size_t>(vertices[i])].p;
      limit.p += wp[i] * p;
      limit.du += wu[i] * p;
      limit.dv += wv[i] * p;
    }
    return limit;
  }

  [[nodiscard]] bool IsRegular(int face) const {
    const Far::PatchTable::PatchHandle* const handle = map_->FindPatch(face, 0.5, 0.5);
    return handle != nullptr && table_->GetPatchDescriptor(*handle).GetType() == Far::PatchDescriptor::REGULAR;
  }

  [[nodiscard]] Far::TopologyLevel mesh() const { return refiner_->GetLevel(0); }

 private:
  RefinerPointer refiner_;
  std::unique_ptr<Far::PatchTable> table_;
  std::unique_ptr<Far::PatchMap> map_;
  std::vector<Point> points_;
};

// A face's corners in its own (u, v), counterclockwise, and where they are in a 4 x 4 net.
constexpr std::array<std::array<int, 2>, 4> kCorners = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
constexpr std::array<std::size_t, 4> kCornerPoints = {0, 3, 15, 12};
// On the side from corner k to k + 1.
constexpr std::array<std::array<std::size_t, 2>, 4> kSidePoints = {{{1, 2}, {7, 11}, {14, 13}, {8, 4}}};

constexpr std::uint32_t kNetSize = 16;

class PatchMaker {
 public:
  PatchMaker(const LimitSurface& surface, const RefinedMesh& mesh)
      : surface_(surface),
        mesh_(mesh),
        corners_(static_cast<std::size_t>(surface.mesh().GetNumVertices())),
        near_ends_(static_cast<std::size_t>(surface.mesh().GetNumEdges())) {}

  void Add(int face, BezierPatches& out) {
    BezierPatch patch;
    patch.face = mesh_.control_faces[static_cast<std::size_t>(face)];
    patch.position = {.first = static_cast<std::uint32_t>(out.positions.size()), .u_order = 4, .v_order = 4};
    const std::array<glm::dvec3, kNetSize> net = NetOf(face);
    for (const glm::dvec3& p : net) out.positions.emplace_back(glm::vec3(p) + 0.0f, 1.0f);
    if (!surface_.IsRegular(face)) AddNormals(face, patch, out);
    if (!mesh_.texcoords.empty()) AddTexcoords(face, patch, out);
    out.patches.push_back(patch);
  }

 private:
  /// What two patches share is computed by the first and taken over by the other: the same bits.
  std::array<glm::dvec3, kNetSize> NetOf(int face) {
    std::array<glm::dvec3, kNetSize> net{};
    const Far::ConstIndexArray vertices = surface_.mesh().GetFaceVertices(face);
    const Far::ConstIndexArray edges = surface_.mesh().GetFaceEdges(face);
    for (int k = 0; k < 4; ++k) {
      const auto [u, v] = kCorners[static_cast<std::size_t>(k)];
      const Limit limit = surface_.At(face, u, v);
      std::optional<glm::dvec3>& corner = corners_[static_cast<std::size_t>(vertices[k])];
      if (!corner) corner = limit.p;
      net[kCornerPoints[static_cast<std::size_t>(k)]] = *corner;
      // The derivatives along the side that leaves the corner and the one that arrives in it, both pointing away.
      const glm::dvec3 leaving = u == v ? (u == 0 ? limit.du : -limit.du) : (u == 1 ? limit.dv : -limit.dv);
      const glm::dvec3 arriving = u == v ? (u == 0 ? limit.dv : -limit.dv) : (u == 1 ? -limit.du : limit.du);
      const int before = (k + 3) % 4;
      net[kSidePoints[static_cast<std::size_t>(k)][0]] = NearEnd(edges[k], vertices[k], *corner + leaving / 3.0);
      net[kSidePoints[static_cast<std::size_t>(before)][1]] =
          NearEnd(edges[before], vertices[k], *corner + arriving / 3.0);
    }
    FillInside(face, net);
    return net;
  }

  glm::dvec3 NearEnd(int edge, int vertex, const glm::dvec3& computed) {
    const bool is_first = surface_.mesh().GetEdgeVertices(edge)[0] == vertex;
    std::optional<glm::dvec3>& point = near_ends_[static_cast<std::size_t>(edge)][is_first ? 0 : 1];
    if (!point) point = computed;
    return *point;
  }

  /// The four inner points from the surface at thirds: exact where the surface is bicubic.
  void FillInside(int face, std::array<glm::dvec3, kNetSize>& net) const {
    constexpr std::array<std::array<double, 4>, 2> kAtThirds = {
        {{8 / 27.0, 12 / 27.0, 6 / 27.0, 1 / 27.0}, {1 / 27.0, 6 / 27.0, 12 / 27.0, 8 / 27.0}}};
    std::array<std::array<glm::dvec3, 2>, 2> rest{};
    for (std::size_t b = 0; b < 2; ++b) {
      for (std::size_t a = 0; a < 2; ++a) {
        rest[b][a] = surface_.At(face, static_cast<double>(a + 1) / 3.0, static_cast<double>(b + 1) / 3.0).p;
        for (std::size_t i = 0; i < kNetSize; ++i) {
          const bool is_inner = i == 5 || i == 6 || i == 9 || i == 10;
          if (!is_inner) rest[b][a] -= kAtThirds[a][i % 4] * kAtThirds[b][i / 4] * net[i];
        }
      }
    }
    // The inverse of ((4, 2), (2, 4)) / 9, along u and then along v.
    const auto solve = [](const glm::dvec3& x, const glm::dvec3& y) {
      return std::pair(3.0 * x - 1.5 * y, 3.0 * y - 1.5 * x);
    };
    for (auto& row : rest) std::tie(row[0], row[1]) = solve(row[0], row[1]);
    std::tie(net[5], net[9]) = solve(rest[0][0], rest[1][0]);
    std::tie(net[6], net[10]) = solve(rest[0][1], rest[1][1]);
  }

  /// A bicubic through the surface's unit normals at thirds: the patch follows an irregular face in position only.
  void AddNormals(int face, BezierPatch& patch, BezierPatches& out) const {
    std::array<glm::dvec3, kNetSize> normals{};
    for (std::size_t i = 0; i < kNetSize; ++i) {
      const Limit limit = surface_.At(face, static_cast<double>(i % 4) / 3.0, static_cast<double>(i / 4) / 3.0);
      const glm::dvec3 normal = glm::cross(limit.du, limit.dv);
      const double length = glm::length(normal);
      if (!(length > 0.0) || !std::isfinite(length)) return;  // the derivatives of the patch must do
      normals[i] = normal / length;
    }
    const auto interpolate = [&](std::size_t first, std::size_t step) {
      const glm::dvec3 f0 = normals[first], f1 = normals[first + step], f2 = normals[first + 2 * step];
      const glm::dvec3 f3 = normals[first + 3 * step];
      normals[first + step] = (-5.0 * f0 + 18.0 * f1 - 9.0 * f2 + 2.0 * f3) / 6.0;
      normals[first + 2 * step] = (2.0 * f0 - 9.0 * f1 + 18.0 * f2 - 5.0 * f3) / 6.0;
    };
    for (std::size_t row = 0; row < 4; ++row) interpolate(4 * row, 1);
    for (std::size_t column = 0; column < 4; ++column) interpolate(column, 4);
    patch.normal = {.first = static_cast<std::uint32_t>(out.normals.size()), .u_order = 4, .v_order = 4};
    for (const glm::dvec3& normal : normals) out.normals.emplace_back(normal);
  }

  void AddTexcoords(int face, BezierPatch& patch, BezierPatches& out) const {
    patch.texcoord[0] = {.first = static_cast<std::uint32_t>(out.texcoords[0].size()), .u_order = 2, .v_order = 2};
    for (const std::size_t k : {0u, 1u, 3u, 2u}) {
      const int value = mesh_.topology.texcoord_corners[4 * static_cast<std::size_t>(face) + k];
      out.texcoords[0].emplace_back(mesh_.texcoords[static_cast<std::size_t>(value)].t);
    }
  }

  const LimitSurface& surface_;
  const RefinedMesh& mesh_;
  std::vector<std::optional<glm::dvec3>> corners_;                   ///< one a vertex
  std::vector<std::array<std::optional<glm::dvec3>, 2>> near_ends_;  ///< one an edge: near its first and second end
};

}  // namespace

Result<std::vector<BezierPatches>> MakeCatmullClarkPatches(const SubdivisionCage& cage, std::uint32_t group_count) {
  if (4 * cage.corners.size() > kMostPatches) {
    return Fail(ErrorKind::kInput, fmt::format("a subdivision surface of {} corners gives more than {} patches",
                                               cage.corners.size(), kMostPatches));
  }
  const std::optional<RefinedMesh> mesh = Refine(cage);
  LimitSurface surface;
  if (!mesh || !surface.Build(*mesh)) {
    return Fail(ErrorKind::kInput, "the faces make no surface that can be subdivided");
  }
  std::vector<BezierPatches> groups(std::max(group_count, 1u));
  PatchMaker maker(surface, *mesh);
  for (int face = 0; face < surface.mesh().GetNumFaces(); ++face) {
    const std::uint32_t control = mesh->control_faces[static_cast<std::size_t>(face)];
    maker.Add(face, groups[cage.face_groups.empty() ? 0 : cage.face_groups[control]]);
  }
  return groups;
}

}  // namespace burin::geometry

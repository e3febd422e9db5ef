// SPDX-License-Identifier: Apache-2.0
// Our patches against OpenSubdiv's own limit surface, evaluated after much deeper adaptive refinement.
#include "core/geometry/catmull_clark.h"

#include <gtest/gtest.h>
#include <opensubdiv/far/patchMap.h>
#include <opensubdiv/far/patchTableFactory.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <map>
#include <memory>

#include "core/geometry/bezier_check.h"
#include "core/geometry/bezier_evaluate.h"

namespace burin::geometry {
namespace {

namespace Far = OpenSubdiv::Far;

SubdivisionCage Cube() {
  SubdivisionCage cage;
  for (int i = 0; i < 8; ++i) cage.positions.emplace_back(i & 1, (i >> 1) & 1, (i >> 2) & 1);
  cage.face_sizes.assign(6, 4);
  cage.corners = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
  return cage;
}

/// A bent sheet with boundaries, its faces of one kind.
SubdivisionCage Sheet(int n) {
  SubdivisionCage cage;
  for (int y = 0; y <= n; ++y) {
    for (int x = 0; x <= n; ++x) {
      cage.positions.emplace_back(x, y, 0.3f * static_cast<float>(((x * 7 + y * 5) % 4)));
    }
  }
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const auto at = static_cast<std::uint32_t>(y * (n + 1) + x), up = at + static_cast<std::uint32_t>(n) + 1;
      cage.corners.insert(cage.corners.end(), {at, at + 1, up + 1, up});
      cage.face_sizes.push_back(4);
    }
  }
  return cage;
}

struct Point {
  glm::dvec3 p{0.0};
  void Clear(void* = nullptr) { p = glm::dvec3(0.0); }
  void AddWithWeight(const Point& other, double weight) { p += weight * other.p; }
};

/// The limit surface of a cage of quads as OpenSubdiv evaluates it, refined `levels` times around what is irregular.
class Reference {
 public:
  Reference(const SubdivisionCage& cage, int levels) {
    const std::vector<int> sizes(cage.face_sizes.begin(), cage.face_sizes.end());
    const std::vector<int> corners(cage.corners.begin(), cage.corners.end());
    std::vector<int> pairs;
    std::vector<float> weights;
    for (const auto& crease : cage.creases) {
      pairs.insert(pairs.end(), crease.vertices.begin(), crease.vertices.end());
      weights.push_back(crease.sharpness);
    }
    Far::TopologyDescriptor descriptor;
    descriptor.numVertices = static_cast<int>(cage.positions.size());
    descriptor.numFaces = static_cast<int>(sizes.size());
    descriptor.numVertsPerFace = sizes.data();
    descriptor.vertIndicesPerFace = corners.data();
    descriptor.numCreases = static_cast<int>(weights.size());
    descriptor.creaseVertexIndexPairs = pairs.data();
    descriptor.creaseWeights = weights.data();
    OpenSubdiv::Sdc::Options options;
    options.SetVtxBoundaryInterpolation(OpenSubdiv::Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    refiner_.reset(Factory::Create(descriptor, Factory::Options(OpenSubdiv::Sdc::SCHEME_CATMARK, options)));
    Far::PatchTableFactory::Options table(static_cast<unsigned>(levels));
    table.SetEndCapType(Far::PatchTableFactory::Options::ENDCAP_GREGORY_BASIS);
    table.useInfSharpPatch = true;
    table.SetPatchPrecision<double>();
    refiner_->RefineAdaptive(table.GetRefineAdaptiveOptions());
    table_.reset(Far::PatchTableFactory::Create(*refiner_, table));
    map_ = std::make_unique<Far::PatchMap>(*table_);
    points_.resize(static_cast<std::size_t>(refiner_->GetNumVerticesTotal() + table_->GetNumLocalPoints()));
    for (std::size_t i = 0; i < cage.positions.size(); ++i) points_[i].p = glm::dvec3(cage.positions[i]);
    const Far::PrimvarRefinerReal<double> primvar(*refiner_);
    Point* source = points_.data();
    for (int l = 1; l <= refiner_->GetMaxLevel(); ++l) {
      Point* const next = source + refiner_->GetLevel(l - 1).GetNumVertices();
      primvar.Interpolate(l, source, next);
      source = next;
    }
    Point* const local = &points_[static_cast<std::size_t>(refiner_->GetNumVerticesTotal())];
    if (table_->GetNumLocalPoints() > 0) {
      table_->GetLocalPointStencilTable<double>()->UpdateValues(points_.data(), local);
    }
  }

  [[nodiscard]] std::pair<glm::dvec3, glm::dvec3> At(int face, double u, double v) const {
    const auto* const handle = map_->FindPatch(face, u, v);
    double wp[20], wu[20], wv[20];
    table_->EvaluateBasis(*handle, u, v, wp, wu, wv);
    const Far::ConstIndexArray vertices = table_->GetPatchVertices(*handle);
    glm::dvec3 p(0.0), du(0.0), dv(0.0);
    for (int i = 0; i < vertices.size(); ++i) {
      const glm::dvec3 c = points_[static_cast<std::size_t>(vertices[i])].p;
      p += wp[i] * c;
      du += wu[i] * c;
      dv += wv[i] * c;
    }
    return {p, glm::normalize(glm::cross(du, dv))};
  }

 private:
  std::unique_ptr<Far::TopologyRefiner> refiner_;
  std::unique_ptr<Far::PatchTable> table_;
  std::unique_ptr<Far::PatchMap> map_;
  std::vector<Point> points_;
};

std::vector<BezierPatches> Make(const SubdivisionCage& cage) {
  auto groups = MakeCatmullClarkPatches(cage);
  EXPECT_TRUE(groups) << groups.error().message;
  for (const BezierPatches& patches : *groups) {
    const auto checked = CheckPatches(patches, "cage");
    EXPECT_TRUE(checked) << checked.error().message;
  }
  return *std::move(groups);
}

/// How far the patches are off the reference's tangent planes at the nearest of many points of the same control face.
double Distance(const SubdivisionCage& cage, const BezierPatches& patches) {
  constexpr int kSamples = 64;
  const Reference reference(cage, 7);
  std::map<std::uint32_t, std::vector<std::pair<glm::dvec3, glm::dvec3>>> points;
  double worst = 0.0;
  for (const BezierPatch& patch : patches.patches) {
    auto& dense = points[patch.face];
    for (int k = 0; dense.size() < (kSamples + 1) * (kSamples + 1); ++k) {
      dense.push_back(reference.At(static_cast<int>(patch.face), static_cast<double>(k % (kSamples + 1)) / kSamples,
                                   static_cast<double>(k / (kSamples + 1)) / kSamples));
    }
    for (int k = 0; k < 25; ++k) {
      const glm::dvec3 p = EvaluateBezier(patches, patch, 0.25 * (k % 5), 0.25 * (k / 5)).position;
      const auto nearest =
          std::ranges::min_element(dense, {}, [&](const auto& q) { return glm::distance(p, q.first); });
      worst = std::max(worst, std::abs(glm::dot(p - nearest->first, nearest->second)));
    }
  }
  return worst;
}

TEST(CatmullClark, ABentSheetIsTheLimitSurface) {
  const SubdivisionCage cage = Sheet(5);
  EXPECT_LT(Distance(cage, Make(cage)[0]), 2e-6) << "regular faces are exact up to floats";
}

TEST(CatmullClark, ACubeIsNearTheLimitSurface) { EXPECT_LT(Distance(Cube(), Make(Cube())[0]), 4e-4); }

TEST(CatmullClark, CreasesAreNearTheLimitSurface) {
  for (const float sharpness : {1.0f, 2.0f, 10.0f}) {
    SubdivisionCage cage = Cube();
    cage.creases = {{{4, 5}, sharpness}, {{5, 7}, sharpness}, {{7, 6}, sharpness}, {{6, 4}, sharpness}};
    EXPECT_LT(Distance(cage, Make(cage)[0]), 1e-3) << sharpness;
  }
}

std::array<std::array<std::uint32_t, 3>, 4> Bits(const std::array<glm::vec4, 4>& row) {
  std::array<std::array<std::uint32_t, 3>, 4> bits{};
  for (std::size_t i = 0; i < 4; ++i) std::memcpy(bits[i].data(), &row[i], 12);
  return bits;
}

TEST(CatmullClark, PatchesShareTheirSidesBitForBit) {
  SubdivisionCage cage = Cube();
  cage.face_groups = {0, 1, 0, 1, 0, 1};
  const auto groups = MakeCatmullClarkPatches(cage, 2);
  ASSERT_TRUE(groups);
  std::map<std::array<std::array<std::uint32_t, 3>, 4>, int> sides;
  std::size_t count = 0;
  for (const BezierPatches& patches : *groups) {
    for (const BezierPatch& patch : patches.patches) {
      ++count;
      const glm::vec4* const net = &patches.positions[patch.position.first];
      for (const auto& side : {std::array{0, 1, 2, 3}, {3, 7, 11, 15}, {15, 14, 13, 12}, {12, 8, 4, 0}}) {
        const auto forward = Bits({net[side[0]], net[side[1]], net[side[2]], net[side[3]]});
        const auto backward = Bits({net[side[3]], net[side[2]], net[side[1]], net[side[0]]});
        sides[std::min(forward, backward)] += forward < backward ? 1 : 1000;
      }
    }
  }
  EXPECT_EQ(count, 96u);
  EXPECT_EQ(sides.size(), 2 * count);
  for (const auto& [side, uses] : sides) EXPECT_EQ(uses, 1001) << "once each way";
}

TEST(CatmullClark, NormalsAreThoseOfTheLimitSurface) {
  const SubdivisionCage cage = Cube();
  const BezierPatches patches = Make(cage)[0];
  const Reference reference(cage, 7);
  // The middle of a control face is a corner of refined ones.
  for (const BezierPatch& patch : patches.patches) {
    const auto [p, n] = reference.At(static_cast<int>(patch.face), 0.5, 0.5);
    for (const auto& [u, v] : {std::pair(0.0, 0.0), {1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}}) {
      const BezierPoint point = EvaluateBezier(patches, patch, u, v);
      if (glm::distance(point.position, p) > 1e-5) continue;
      EXPECT_GT(glm::dot(point.normal, n), std::cos(glm::radians(0.5)));
    }
  }
}

TEST(CatmullClark, TexcoordsStayOnTheirFaces) {
  SubdivisionCage cage = Sheet(1);
  cage.texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  cage.texcoord_corners = {0, 1, 2, 3};
  const BezierPatches patches = Make(cage)[0];
  ASSERT_EQ(patches.texcoords[0].size(), 4 * patches.patches.size());
  double area = 0.0;
  for (const BezierPatch& patch : patches.patches) {
    const glm::vec2* const t = &patches.texcoords[0][patch.texcoord[0].first];
    const glm::vec2 a = t[1] - t[0], b = t[2] - t[0];
    area += static_cast<double>(a.x * b.y - a.y * b.x);
  }
  EXPECT_NEAR(area, 1.0, 1e-5);
}

}  // namespace
}  // namespace burin::geometry

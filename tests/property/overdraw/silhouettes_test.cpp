// SPDX-License-Identifier: Apache-2.0
// Random meshes and views: every way of searching finds the same edges, and what is drawn is what a plain walk over
// pairs of faces says.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <random>
#include <set>
#include <tuple>

#include "core/overdraw/extract_edges.h"
#include "core/overdraw/silhouette_scan.h"
#include "tests/support/triangle_mesh.h"

namespace burin::overdraw {
namespace {

using test::TriangleMesh;

constexpr std::uint32_t kSeed = 60417;
constexpr float kCreaseDeg = 60.0f;

using Place = std::tuple<float, float, float>;
using Ends = std::pair<Place, Place>;  ///< the lower one first

Place PlaceOf(const glm::vec3& p) { return {p.x, p.y, p.z}; }
Ends EndsOf(const glm::vec3& a, const glm::vec3& b) { return std::minmax(PlaceOf(a), PlaceOf(b)); }

struct Case {
  std::string name;
  TriangleMesh mesh;
  bool is_closed = true;
};

void RemoveTriangles(std::size_t count, std::mt19937& random, TriangleMesh& mesh) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto at = mesh.triangles.begin() + static_cast<std::ptrdiff_t>(random() % (mesh.triangles.size() / 3) * 3);
    mesh.triangles.erase(at, at + 3);
  }
}

/// Triangles on random vertices and copies of others: fans, clashes and duplicates.
void AddDisorder(std::size_t count, std::mt19937& random, TriangleMesh& mesh) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t from = random() % (mesh.triangles.size() / 3) * 3;
    std::array<std::uint32_t, 3> t = {mesh.triangles[from], mesh.triangles[from + 1], mesh.triangles[from + 2]};
    if (i % 3 == 0) t[random() % 3] = static_cast<std::uint32_t>(random() % mesh.positions.size());
    if (i % 3 == 1) std::swap(t[0], t[1]);
    mesh.triangles.insert(mesh.triangles.end(), t.begin(), t.end());
  }
}

std::vector<Case> Cases(std::mt19937& random) {
  std::vector<Case> cases;
  const auto add = [&](const char* name, TriangleMesh mesh, float amount, bool is_closed = true) {
    test::Perturb(amount, random, mesh);
    cases.push_back({name, std::move(mesh), is_closed});
  };
  add("tetrahedron",
      {.positions = {{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}},
       .triangles = {0, 1, 3, 0, 2, 1, 0, 3, 2, 1, 2, 3}},
      0.1f);
  add("sphere", test::Icosphere(3), 0.0f);
  add("rough sphere", test::Icosphere(3), 0.03f);
  add("fine sphere", test::Icosphere(5), 0.0f);
  add("torus", test::Torus(60, 31), 0.004f);
  TriangleMesh joined = test::Torus(30, 17);
  TriangleMesh other = test::Torus(21, 40, 0.7f, 0.2f);
  for (glm::vec3& p : other.positions) p = {p.z, p.x + 1.0f, p.y};
  test::Append(other, joined);
  add("two tori", joined, 0.002f);
  TriangleMesh far = test::Torus(40, 20);
  for (glm::vec3& p : far.positions) p = p * glm::vec3(3.0f, 0.1f, 1.0f) + glm::vec3(500.0f, -300.0f, 1e3f);
  add("flat torus far away", far, 0.0f);
  TriangleMesh holes = test::Icosphere(3);
  RemoveTriangles(40, random, holes);
  add("holes", holes, 0.01f, false);
  TriangleMesh half_open = test::Torus(30, 17);
  RemoveTriangles(3, random, half_open);
  test::Append(other, half_open);
  add("an open and a closed torus", half_open, 0.002f, false);
  TriangleMesh disorder = test::Torus(20, 15);
  AddDisorder(50, random, disorder);
  add("fans and duplicates", disorder, 0.01f, false);
  return cases;
}

/// Eyes far, near, inside, in vertices and in planes of faces, where roundings decide; directions too.
std::vector<glm::vec4> Eyes(const TriangleMesh& mesh, std::mt19937& random) {
  std::normal_distribution<float> normal;
  const auto vector = [&] { return glm::vec3(normal(random), normal(random), normal(random)); };
  const auto vertex = [&] { return mesh.positions[random() % mesh.positions.size()]; };
  glm::vec3 low = mesh.positions[0], high = low;
  for (const glm::vec3& p : mesh.positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const glm::vec3 centre = 0.5f * (low + high);
  const float radius = 0.5f * glm::length(high - low);
  std::vector<glm::vec4> eyes;
  for (int i = 0; i < 8; ++i) {
    for (const float distance : {0.3f, 1.1f, 3.0f, 100.0f})
      eyes.emplace_back(centre + glm::normalize(vector()) * radius * distance, 1);
    eyes.emplace_back(vertex(), 1);
    const std::size_t t = random() % (mesh.triangles.size() / 3) * 3;
    const glm::vec3 a = mesh.positions[mesh.triangles[t]], b = mesh.positions[mesh.triangles[t + 1]],
                    c = mesh.positions[mesh.triangles[t + 2]];
    eyes.emplace_back(a + 20.0f * normal(random) * (b - a) + 20.0f * normal(random) * (c - a), 1);
    eyes.emplace_back(b - a, 0);
    eyes.emplace_back(vector() * 3.0f, 0);
  }
  eyes.emplace_back(1, 0, 0, 0);
  return eyes;
}

EdgeMesh Build(const TriangleMesh& mesh, EdgeMeshOptions options = {.least_tree_edges = 1}) {
  options.crease_angle_deg = kCreaseDeg;
  Result<EdgeMesh> built = BuildEdgeMesh(
      {.name = "random", .positions = mesh.positions, .normals = mesh.normals, .triangles = mesh.triangles}, options);
  EXPECT_TRUE(built.has_value());
  return *std::move(built);
}

/// What is drawn, by the definitions, over all pairs of sides between the same places.
class Reference {
 public:
  Reference(const TriangleMesh& mesh, const EdgeMesh& built) : mesh_(mesh), built_(built) {
    for (std::uint32_t f = 0; f < mesh.triangles.size() / 3; ++f) {
      const auto [a, b, c] = Corners(f);
      if (glm::length(glm::cross(b - a, c - a)) == 0.0) continue;
      sides_[EndsOf(a, b)].push_back({f, PlaceOf(a) < PlaceOf(b), c});
      sides_[EndsOf(b, c)].push_back({f, PlaceOf(b) < PlaceOf(c), a});
      sides_[EndsOf(c, a)].push_back({f, PlaceOf(c) < PlaceOf(a), b});
    }
  }

  struct Counts {
    std::size_t silhouettes = 0, sharp = 0;
  };

  /// `is_open`: concave edges count. Only for meshes that are one surface, or closed ones.
  std::set<Ends> Rendered(const glm::vec4& eye, bool is_open, Counts& counts) const {
    std::set<Ends> rendered;
    const glm::vec4 local = built_.planes.LocalEye(eye);
    const auto is_front = [&](std::uint32_t f) { return FacingValue(built_.planes.Plane(f), local) > 0.0f; };
    for (const auto& [ends, sides] : sides_) {
      const bool is_boundary = sides.size() != 2 || sides[0].runs_up == sides[1].runs_up ||
                               PlaceOf(sides[0].opposite) == PlaceOf(sides[1].opposite);
      const std::uint32_t left = sides[0].face, right = sides[sides.size() > 1 ? 1 : 0].face;
      const bool front_left = is_front(left), front_right = is_front(right);
      if (!front_left && !front_right) continue;
      const bool is_sharp = !is_boundary && Angle(left, right) > kCreaseDeg;
      const bool is_silhouette =
          is_boundary || (!is_sharp && front_left != front_right && (is_open || !IsConcave(sides[0], sides[1])));
      if (!is_sharp && !is_silhouette) continue;
      rendered.insert(ends);
      ++(is_sharp ? counts.sharp : counts.silhouettes);
    }
    return rendered;
  }

 private:
  struct Side {
    std::uint32_t face;
    bool runs_up;
    glm::vec3 opposite;
  };
  std::array<glm::dvec3, 3> Corners(std::uint32_t f) const {
    return {mesh_.positions[mesh_.triangles[3 * f]], mesh_.positions[mesh_.triangles[3 * f + 1]],
            mesh_.positions[mesh_.triangles[3 * f + 2]]};
  }
  glm::dvec3 Normal(std::uint32_t f) const {
    const auto [a, b, c] = Corners(f);
    return glm::normalize(glm::cross(b - a, c - a));
  }
  double Angle(std::uint32_t f, std::uint32_t g) const {
    return std::acos(std::clamp(glm::dot(Normal(f), Normal(g)), -1.0, 1.0)) * 57.295779513;
  }
  bool IsConcave(const Side& a, const Side& b) const {
    return glm::dot(Normal(a.face), glm::dvec3(b.opposite) - Corners(a.face)[0]) >= 0.0;
  }

  const TriangleMesh& mesh_;
  const EdgeMesh& built_;
  std::map<Ends, std::vector<Side>> sides_;
};

TEST(Silhouettes, EveryWayOfSearchingFindsTheSameEdges) {
  std::printf("seed %u\n", kSeed);
  std::mt19937 random(kSeed);
  std::size_t found_in_all = 0;
  for (const Case& c : Cases(random)) {
    SCOPED_TRACE(c.name);
    const EdgeMesh mesh = Build(c.mesh);
    if (mesh.silhouettes.size() == 0) continue;
    ASSERT_FALSE(mesh.tree.empty());
    for (const glm::vec4& eye : Eyes(c.mesh, random)) {
      const glm::vec4 local = mesh.planes.LocalEye(eye);
      std::vector<std::uint32_t> expected;
      for (std::uint32_t i = 0; i < mesh.silhouettes.size(); ++i) {
        if ((FacingValue(mesh.planes.Plane(mesh.silhouettes.left[i]), local) > 0) !=
            (FacingValue(mesh.planes.Plane(mesh.silhouettes.right[i]), local) > 0))
          expected.push_back(i);
      }
      found_in_all += expected.size();
      for (const bool uses_avx2 : {false, HasAvx2()}) {
        std::vector<std::uint32_t> tree, scan, parallel;
        const std::size_t visited = mesh.tree.Find(local, uses_avx2, tree);
        ASSERT_EQ(tree, expected) << "tree, avx2 " << uses_avx2;
        ASSERT_LE(visited, mesh.silhouettes.size());
        ScanSilhouettes(mesh.planes, mesh.silhouettes, local, {uses_avx2, false}, scan);
        ASSERT_EQ(scan, expected) << "scan, avx2 " << uses_avx2;
        ScanSilhouettes(mesh.planes, mesh.silhouettes, local, {uses_avx2, true}, parallel);
        ASSERT_EQ(parallel, expected) << "parallel scan, avx2 " << uses_avx2;
      }
    }
  }
  EXPECT_GT(found_in_all, 10'000u) << "the views must see silhouettes for this to test anything";
}

/// Finer than the random meshes, so that roundings come close to a leaf's extent, with eyes in planes of faces.
TEST(Silhouettes, TreeMissesNothingOnAFineMesh) {
  std::printf("seed %u\n", kSeed);
  std::mt19937 random(kSeed);
  TriangleMesh torus = test::Torus(700, 300);  // 420 000 triangles
  for (glm::vec3& p : torus.positions) p += glm::vec3(40, -7, 3);
  const EdgeMesh mesh = Build(torus);
  for (const glm::vec4& eye : Eyes(torus, random)) {
    const glm::vec4 local = mesh.planes.LocalEye(eye);
    std::vector<std::uint32_t> tree, scan, parallel;
    mesh.tree.Find(local, HasAvx2(), tree);
    ScanSilhouettes(mesh.planes, mesh.silhouettes, local, {}, scan);
    ScanSilhouettes(mesh.planes, mesh.silhouettes, local, {.is_parallel = true}, parallel);
    ASSERT_EQ(tree, scan);
    ASSERT_EQ(parallel, scan);
  }
}

/// A flat sheet's faces have one plane but for roundings, so its edges are silhouettes at random for an eye in it; in
/// the middle of a leaf's edges, where its cones begin, nothing but the margin keeps the tree from skipping them.
TEST(Silhouettes, TreeMissesNothingWhereConesBegin) {
  std::printf("seed %u\n", kSeed);
  std::mt19937 random(kSeed);
  constexpr std::uint32_t kSide = 80;
  TriangleMesh sheet;
  const glm::vec3 u = glm::normalize(glm::vec3(1, 0.7f, -0.3f)), v = glm::normalize(glm::vec3(0.2f, -1, 0.8f));
  for (std::uint32_t i = 0; i < kSide * kSide; ++i)
    sheet.positions.push_back(static_cast<float>(i % kSide) * 0.017f * u + static_cast<float>(i / kSide) * 0.013f * v);
  for (std::uint32_t i = 0; i + kSide < kSide * kSide; ++i) {
    if (i % kSide == kSide - 1) continue;
    sheet.triangles.insert(sheet.triangles.end(), {i, i + 1, i + kSide, i + 1, i + kSide + 1, i + kSide});
  }
  const EdgeMesh mesh = Build(sheet);
  std::size_t found = 0;
  for (std::size_t first = 0; first < mesh.silhouettes.size(); first += SilhouetteTree::kLeafEdges) {
    const std::size_t end = std::min(first + SilhouetteTree::kLeafEdges, mesh.silhouettes.size());
    glm::vec3 middle(0);
    for (std::size_t i = first; i < end; ++i)
      middle += mesh.Midpoint(mesh.edges[mesh.silhouettes.edge[i]]) - mesh.planes.origin;
    middle /= static_cast<float>(end - first);
    for (int offset = 0; offset < 8; ++offset) {
      const auto moved = [&](float x) { return x + 3e-8f * (static_cast<float>(random() % 5) - 2.0f); };
      const glm::vec4 local(moved(middle.x), moved(middle.y), moved(middle.z), 1);
      std::vector<std::uint32_t> tree, scan;
      mesh.tree.Find(local, HasAvx2(), tree);
      ScanSilhouettes(mesh.planes, mesh.silhouettes, local, {}, scan);
      ASSERT_EQ(tree, scan);
      found += scan.size();
    }
  }
  EXPECT_GT(found, 10'000u);
}

TEST(Silhouettes, RenderedAreSilhouettesAndSharpEdgesWithAFrontFace) {
  std::printf("seed %u\n", kSeed);
  std::mt19937 random(kSeed);
  for (const Case& c : Cases(random)) {
    if (c.name == "an open and a closed torus") continue;  // the reference knows one surface only
    SCOPED_TRACE(c.name);
    const EdgeMesh mesh = Build(c.mesh);
    ASSERT_EQ(mesh.is_closed, c.is_closed);
    const Reference reference(c.mesh, mesh);
    for (const glm::vec4& eye : Eyes(c.mesh, random)) {
      Reference::Counts counts;
      const std::set<Ends> expected = reference.Rendered(eye, !c.is_closed, counts);
      for (const SilhouetteWay way : {SilhouetteWay::kScan, SilhouetteWay::kTree}) {
        std::vector<RenderedEdge> edges;
        EdgeStatistics statistics;
        ExtractEdges(mesh, {.eye = eye}, edges, statistics, {.way = way});
        std::set<Ends> rendered;
        for (const RenderedEdge& e : edges) {
          const geometry::Edge& edge = mesh.edges[e.edge];
          rendered.insert(EndsOf(mesh.positions[edge.corners_left[0]], mesh.positions[edge.corners_left[1]]));
          ASSERT_TRUE(e.beta >= 0.0f && e.beta <= 1.0f);
        }
        ASSERT_EQ(rendered.size(), edges.size());
        ASSERT_EQ(rendered, expected);
        ASSERT_EQ(statistics.silhouettes, counts.silhouettes);
        ASSERT_EQ(statistics.rendered, counts.silhouettes + counts.sharp);
        ASSERT_LE(statistics.sorted, statistics.rendered);
        ASSERT_LE(statistics.blended, statistics.sharp);
      }
    }
  }
}

TEST(Silhouettes, DrawnEdgesAndTheirSidesDontDependOnTheOrderOfTriangles) {
  std::printf("seed %u\n", kSeed);
  std::mt19937 random(kSeed);
  for (const Case& c : Cases(random)) {
    if (c.name == "fans and duplicates") continue;  // of three faces, the first two in the file count
    SCOPED_TRACE(c.name);
    TriangleMesh shuffled = c.mesh;
    std::vector<std::uint32_t> order(c.mesh.triangles.size() / 3);
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::ranges::shuffle(order, random);
    for (std::size_t f = 0; f < order.size(); ++f) {
      const std::size_t turn = random() % 3;
      for (std::size_t k = 0; k < 3; ++k)
        shuffled.triangles[3 * f + k] = c.mesh.triangles[3 * order[f] + (k + turn) % 3];
    }
    // A small crease angle, so that most edges are sharp.
    const auto drawn = [&](const TriangleMesh& triangles) {
      const EdgeMesh mesh =
          *BuildEdgeMesh({.name = "random", .positions = triangles.positions, .triangles = triangles.triangles},
                         {.crease_angle_deg = 10, .least_tree_edges = 1});
      std::vector<RenderedEdge> edges;
      EdgeStatistics statistics;
      ExtractEdges(mesh, {.eye = {9, 5, -7, 1}}, edges, statistics);
      std::set<std::tuple<std::uint32_t, std::uint32_t, EdgeClass>> result;
      for (const RenderedEdge& e : edges) {
        std::array<std::uint32_t, 2> ends = mesh.edges[e.edge].corners_left;
        if (!IsSharp(mesh.kinds[e.edge])) std::ranges::sort(ends);  // smooth edges have no orientation of their own
        result.insert({ends[0], ends[1], e.cls});
      }
      return result;
    };
    EXPECT_EQ(drawn(c.mesh), drawn(shuffled));
  }
}

TEST(Silhouettes, DeformedMeshDrawsWhatItsNewShapeWouldDraw) {
  std::printf("seed %u\n", kSeed);
  std::mt19937 random(kSeed);
  const TriangleMesh rest = test::Torus(50, 25);
  EdgeMesh mesh = *BuildEdgeMesh({.name = "torus", .positions = rest.positions, .triangles = rest.triangles},
                                 {.crease_angle_deg = 180, .least_tree_edges = 1});
  for (int pose = 0; pose < 3; ++pose) {
    TriangleMesh moved = rest;
    test::Perturb(0.02f, random, moved);
    for (glm::vec3& p : moved.positions) p = {p.x + p.y * 0.4f, p.y + std::sin(3 * p.x), p.z - 2.0f * p.x};
    UpdateDeformed(mesh, moved.positions);
    const EdgeMesh fresh = *BuildEdgeMesh({.name = "torus", .positions = moved.positions, .triangles = moved.triangles},
                                          {.crease_angle_deg = 180, .least_tree_edges = kNoTree});
    for (const glm::vec4& eye : Eyes(moved, random)) {
      std::vector<RenderedEdge> edges, expected;
      EdgeStatistics statistics, fresh_statistics;
      ExtractEdges(mesh, {.eye = eye}, edges, statistics);
      ExtractEdges(fresh, {.eye = eye}, expected, fresh_statistics);
      EXPECT_EQ(statistics.way, SilhouetteWay::kScan);
      ASSERT_EQ(edges.size(), expected.size());
      for (std::size_t i = 0; i < edges.size(); ++i) {
        ASSERT_EQ(edges[i].edge, expected[i].edge);
        ASSERT_EQ(edges[i].beta, expected[i].beta);
        ASSERT_EQ(edges[i].distance2, expected[i].distance2);
      }
    }
  }
}

}  // namespace
}  // namespace burin::overdraw

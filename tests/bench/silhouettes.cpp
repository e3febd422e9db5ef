// SPDX-License-Identifier: Apache-2.0
// Silhouette search: the tree against linear scans on one model subdivided to several sizes, and the counts of the
// paper's Table 1. Usage: bench_silhouettes [MODEL.obj...]; without arguments spot.obj of the shared data, or a sphere.

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/overdraw/extract_edges.h"
#include "core/overdraw/silhouette_scan.h"
#include "tests/support/triangle_mesh.h"

namespace {

using burin::overdraw::EdgeMesh;
using burin::test::TriangleMesh;

constexpr int kViews = 100;
constexpr std::uint32_t kSeed = 20011;

double NowMs() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double Median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

/// Eyes on the sphere of three radii, the distance of the paper's silhouette counts.
std::vector<glm::vec4> Eyes(const burin::overdraw::FacePlanes& planes) {
  std::mt19937 random(kSeed);
  std::normal_distribution<float> normal;
  std::vector<glm::vec4> eyes;
  for (int i = 0; i < kViews; ++i) {
    const glm::vec3 direction = glm::normalize(glm::vec3(normal(random), normal(random), normal(random)));
    eyes.emplace_back(planes.origin + 3.0f * planes.radius * direction, 1.0f);
  }
  return eyes;
}

burin::Result<EdgeMesh> Build(const TriangleMesh& mesh, std::size_t least_tree_edges) {
  return burin::overdraw::BuildEdgeMesh(
      {.name = "bench", .positions = mesh.positions, .normals = mesh.normals, .triangles = mesh.triangles},
      {.least_tree_edges = least_tree_edges});
}

/// Median time of a search over all views, in ms.
template <class Search>
double SearchMs(const EdgeMesh& mesh, const Search& search) {
  std::vector<double> times;
  std::vector<std::uint32_t> found;
  for (const glm::vec4& eye : Eyes(mesh.planes)) {
    found.clear();
    const double begin = NowMs();
    search(mesh.planes.LocalEye(eye), found);
    times.push_back(NowMs() - begin);
  }
  return Median(times);
}

void PrintRow(const TriangleMesh& model) {
  double build_ms = 0, tree_build_ms = 0;
  auto built = Build(model, ~std::size_t{0});
  {
    const double begin = NowMs();
    auto tree = Build(model, 1);
    build_ms = NowMs() - begin;
    built = std::move(tree);
  }
  if (!built) {
    fmt::print(stderr, "error: {}\n", built.error().message);
    return;
  }
  const EdgeMesh& mesh = *built;
  {
    auto silhouettes = mesh.silhouettes;
    std::vector<glm::vec3> midpoints;
    for (const std::uint32_t e : silhouettes.edge) midpoints.push_back(mesh.Midpoint(mesh.edges[e]));
    const double begin = NowMs();
    const auto tree = burin::overdraw::SilhouetteTree::Build(mesh.planes, midpoints, silhouettes);
    tree_build_ms = NowMs() - begin;
  }
  const auto scan = [&](bool avx2, bool parallel) {
    return SearchMs(mesh, [&, avx2, parallel](const glm::vec4& eye, std::vector<std::uint32_t>& found) {
      burin::overdraw::ScanSilhouettes(mesh.planes, mesh.silhouettes, eye, {avx2, parallel}, found);
    });
  };
  const double portable = scan(false, false), one = scan(burin::overdraw::HasAvx2(), false),
               two = scan(burin::overdraw::HasAvx2(), true);
  std::size_t visited = 0, found_count = 0;
  const double tree = SearchMs(mesh, [&](const glm::vec4& eye, std::vector<std::uint32_t>& found) {
    visited += mesh.tree.Find(eye, burin::overdraw::HasAvx2(), found);
    found_count += found.size();
  });
  fmt::print("{:>9} {:>9} {:>9} {:>8.3f} {:>8.3f} {:>8.3f} {:>8.3f} {:>7.2f} {:>8} {:>8} {:>7.2f} {:>8.1f} {:>8.1f}\n",
             mesh.face_count(), mesh.edges.size(), mesh.silhouettes.size(), portable, one, two, tree, one / tree,
             found_count / kViews, visited / kViews,
             static_cast<double>(visited) / static_cast<double>(std::max<std::size_t>(found_count, 1)), tree_build_ms,
             build_ms);
  std::fflush(stdout);
}

void PrintTable1(const std::string& name, const TriangleMesh& model) {
  auto mesh = Build(model, burin::overdraw::kLeastTreeEdges);
  if (!mesh) {
    fmt::print(stderr, "error: {}\n", mesh.error().message);
    return;
  }
  burin::overdraw::EdgeStatistics sum, statistics;
  std::vector<burin::overdraw::RenderedEdge> edges;
  std::vector<double> times;
  for (const glm::vec4& eye : Eyes(mesh->planes)) {
    const double begin = NowMs();
    burin::overdraw::ExtractEdges(*mesh, {.eye = eye}, edges, statistics);
    times.push_back(NowMs() - begin);
    sum += statistics;
  }
  const auto mean = [](std::size_t total) { return static_cast<double>(total) / kViews; };
  fmt::print("{:<22} {:>8} {:>8} {:>8} {:>8.1f} {:>8.1f} {:>8.1f} {:>8.1f} {:>8.3f} {}\n", name, statistics.faces,
             statistics.edges, statistics.sharp, mean(sum.silhouettes), mean(sum.rendered), mean(sum.sorted),
             mean(sum.blended), Median(times),
             statistics.way == burin::overdraw::SilhouetteWay::kTree ? "tree" : "scan");
}

std::vector<std::string> Models(int argc, char** argv) {
  if (argc > 1) return {argv + 1, argv + argc};
  const char* data = std::getenv("BURIN_SHARED_DATA");
  const char* source = std::getenv("BURIN_SOURCE_DIR");
  if (data != nullptr) return {std::string(data) + "/mesh/spot.obj"};
  return {std::string(source != nullptr ? source : ".") + "/../shared/data/mesh/spot.obj"};
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> paths = Models(argc, argv);
  std::vector<std::pair<std::string, TriangleMesh>> models;
  for (const std::string& path : paths) {
    auto model = burin::test::ReadObjPositions(path);
    if (model) models.emplace_back(path.substr(path.rfind('/') + 1), *std::move(model));
    if (!model) fmt::print(stderr, "{} can't be read\n", path);
  }
  if (models.empty()) models.emplace_back("icosphere", burin::test::Icosphere(4));
  fmt::print("{} subdivided (Loop), {} views at 3 radii, seed {}; medians in ms\n", models[0].first, kViews, kSeed);
  fmt::print("{:>9} {:>9} {:>9} {:>8} {:>8} {:>8} {:>8} {:>7} {:>8} {:>8} {:>7} {:>8} {:>8}\n", "faces", "edges",
             "searched", "portable", "avx2", "2 thr", "tree", "speedup", "found", "visited", "vis/fnd", "tree bld",
             "all bld");
  TriangleMesh model = models[0].second;
  PrintRow(model);
  while (model.triangles.size() / 3 < 1'000'000) {
    model = burin::test::LoopSubdivided(model);
    PrintRow(model);
  }
  fmt::print("bounds: speedup >= 3 at 1.5M faces; vis/fnd <= 13; all bld < 500 ms at 375k faces\n\n");
  fmt::print("{:<22} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} way\n", "Table 1: model", "faces", "edges",
             "sharp", "silh.", "rendered", "sorted", "blended", "ms");
  for (auto& [name, mesh] : models) {
    burin::test::SmoothNormals(mesh);
    PrintTable1(name, mesh);
  }
  PrintTable1("cube", burin::test::Cube());
  return 0;
}

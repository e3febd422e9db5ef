// SPDX-License-Identifier: Apache-2.0
#include "core/overdraw/scene_edges.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "core/scene/item_tessellator.h"
#include "tests/support/patch_models.h"
#include "tests/support/triangle_mesh.h"

namespace burin::overdraw {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

scene::Primitive PrimitiveOf(const test::TriangleMesh& mesh, int material = scene::kNone) {
  scene::Primitive primitive;
  primitive.positions = mesh.positions;
  primitive.normals = mesh.normals;
  primitive.indices = mesh.triangles;
  primitive.material = material;
  return primitive;
}

/// A smooth sphere: nothing but silhouettes.
scene::Primitive Sphere(int levels = 2) {
  test::TriangleMesh mesh = test::Icosphere(levels);
  test::SmoothNormals(mesh);
  return PrimitiveOf(mesh);
}

/// A square of the plane z = 0 from x0 to x1 and -1 to 1, seen from +z.
scene::Primitive Sheet(float x0, float x1, int material) {
  scene::Primitive sheet;
  sheet.positions = {{x0, -1, 0}, {x1, -1, 0}, {x1, 1, 0}, {x0, 1, 0}};
  sheet.normals.assign(4, {0, 0, 1});
  sheet.indices = {0, 1, 2, 0, 2, 3};
  sheet.material = material;
  return sheet;
}

class SceneEdgesTest : public ::testing::Test {
 protected:
  int AddMesh(std::string name, std::vector<scene::Primitive> primitives) {
    scene_.meshes.push_back({std::move(name), std::move(primitives), {}});
    return static_cast<int>(scene_.meshes.size()) - 1;
  }
  int AddNode(int mesh, const glm::mat4& world = glm::mat4(1.0f)) {
    scene::Node node;
    node.mesh = mesh;
    node.matrix = world;
    scene_.nodes.push_back(std::move(node));
    scene_.roots.push_back(static_cast<int>(scene_.nodes.size()) - 1);
    return scene_.roots.back();
  }
  void AddMaterials(int count) { scene_.materials.resize(static_cast<std::size_t>(count)); }

  static glm::mat4 At(float x, float y, float z) { return glm::translate(glm::mat4(1.0f), glm::vec3(x, y, z)); }
  /// Along -z from (0, 0, distance).
  static scene::View From(float distance) {
    scene::View view;
    view.view_from_world = At(0, 0, -distance);
    view.clip_from_view = glm::perspectiveRH_ZO(0.8f, 1.0f, 0.1f, 100.0f);
    return view;
  }
  static scene::View Orthographic() {
    scene::View view = From(10);
    view.clip_from_view = glm::orthoRH_ZO(-3.0f, 3.0f, -3.0f, 3.0f, 0.1f, 100.0f);
    view.orthographic = true;
    return view;
  }
  [[nodiscard]] std::vector<scene::DrawItem> Items() const {
    const scene::Pose pose = scene::EvaluatePose(scene_, {}, 0.0);
    return scene::BuildDrawItems(scene_, pose, pose);
  }
  std::vector<EdgeSegment> Extract(SceneEdges& edges, const scene::View& view) {
    items_ = Items();
    Result<const FrameEdges*> found = edges.Extract(items_, view);
    EXPECT_TRUE(found.has_value()) << found.error().message;
    if (!found) return {};
    statistics_ = (*found)->statistics;
    return (*found)->segments;
  }
  std::vector<EdgeSegment> Extract(const scene::View& view, EdgeMode mode = EdgeMode::kSorted,
                                   bool sorts_whole_scene = true) {
    EdgeOptions options;
    options.mode = mode;
    options.sorts_whole_scene = sorts_whole_scene;
    SceneEdges edges(scene_, options);
    return Extract(edges, view);
  }
  /// Where the segment's vertices say it is, by the item's primitive.
  [[nodiscard]] glm::vec3 VertexOf(std::uint32_t item_index, std::uint32_t vertex) const {
    const scene::DrawItem& item = items_.at(item_index);
    const scene::Primitive& primitive =
        scene_.meshes[static_cast<std::size_t>(item.mesh)].primitives[static_cast<std::size_t>(item.primitive)];
    const auto& positions = item.is_deformed ? item.deformed.positions : primitive.positions;
    return glm::vec3(item.world_from_object * glm::vec4(positions.at(vertex), 1.0f));
  }
  void ExpectVerticesAtTheEnds(const std::vector<EdgeSegment>& segments) const {
    for (const EdgeSegment& s : segments) {
      for (std::size_t end = 0; end < 2; ++end) {
        ASSERT_LT(glm::distance(VertexOf(s.left_item, s.left_vertices[end]), s.ends[end]), 1e-5f);
        ASSERT_LT(glm::distance(VertexOf(s.right_item, s.right_vertices[end]), s.ends[end]), 1e-5f);
      }
    }
  }

  scene::Scene scene_;
  std::vector<scene::DrawItem> items_;
  EdgeStatistics statistics_;
};

float DistanceFrom(const glm::vec3& eye, const EdgeSegment& s) {
  return glm::distance(eye, 0.5f * (s.ends[0] + s.ends[1]));
}

std::size_t CountOf(const std::vector<EdgeSegment>& segments, EdgeClass edge_class) {
  return static_cast<std::size_t>(std::ranges::count(segments, edge_class, &EdgeSegment::edge_class));
}

TEST_F(SceneEdgesTest, PrimitivesOfOneMeshMeetInMaterialEdges) {
  AddMaterials(2);
  AddNode(AddMesh("flag", {Sheet(-1, 0, 0), Sheet(0, 1, 1)}));
  const auto segments = Extract(From(5));
  EXPECT_EQ(segments.size(), 7u) << "six at the boundary, one between";
  ASSERT_EQ(CountOf(segments, EdgeClass::kMaterial), 1u);
  const auto between = std::ranges::find(segments, EdgeClass::kMaterial, &EdgeSegment::edge_class);
  EXPECT_EQ(between->ends[0].x, 0.0f);
  EXPECT_EQ(between->ends[1].x, 0.0f);
  EXPECT_NE(between->left_item, between->right_item);
  EXPECT_LT(between->left_item == 0 ? between->left_corner.x : between->right_corner.x, 0.0f);
  ExpectVerticesAtTheEnds(segments);
}

TEST_F(SceneEdgesTest, PrimitivesOfOneMaterialMeetInNoEdge) {
  AddMaterials(1);
  AddNode(AddMesh("flag", {Sheet(-1, 0, 0), Sheet(0, 1, 0)}));
  const auto segments = Extract(From(5));
  EXPECT_EQ(segments.size(), 6u);
  EXPECT_EQ(CountOf(segments, EdgeClass::kBoundary), 6u);
}

TEST_F(SceneEdgesTest, InstancesShareAMesh) {
  const int ball = AddMesh("ball", {Sphere()});
  AddNode(ball, At(-1.5f, 0, 0));
  AddNode(ball, At(1.5f, 0, 0) * glm::scale(glm::mat4(1.0f), glm::vec3(0.5f)));
  SceneEdges edges(scene_, {});
  const auto segments = Extract(edges, From(8));
  const auto notes = edges.TakeNotes();
  ASSERT_THAT(notes, SizeIs(1));
  EXPECT_THAT(notes[0], HasSubstr("ball"));
  EXPECT_THAT(notes[0], HasSubstr("320 faces, 480 edges, 0 sharp"));
  std::size_t counts[2] = {};
  for (const EdgeSegment& s : segments) {
    ASSERT_LT(s.left_item, 2u);
    ++counts[s.left_item];
    const bool is_right = s.left_item == 1;
    for (const glm::vec3& end : s.ends)
      EXPECT_NEAR(glm::distance(end, glm::vec3(is_right ? 1.5f : -1.5f, 0, 0)), is_right ? 0.5f : 1.0f, 1e-5f);
  }
  EXPECT_GT(counts[0], 10u);
  EXPECT_GT(counts[1], 10u);
  ExpectVerticesAtTheEnds(segments);
  EXPECT_EQ(statistics_.faces, 640u) << "the sum over both";
  Extract(edges, From(9));
  EXPECT_THAT(edges.TakeNotes(), IsEmpty()) << "each is said once";
}

TEST_F(SceneEdgesTest, AMorphedMeshIsScannedWhereItIs) {
  scene::Primitive ball = Sphere();
  ball.targets.push_back({ball.positions, {}, {}});  // twice as large at weight 1
  const int node = AddNode(AddMesh("balloon", {ball}));
  scene_.meshes[0].weights = {0.0f};
  SceneEdges edges(scene_, {});
  for (const float weight : {0.0f, 0.5f, 1.0f}) {
    scene_.nodes[static_cast<std::size_t>(node)].weights = {weight};
    const auto segments = Extract(edges, From(8));
    ASSERT_GT(segments.size(), 10u);
    for (const EdgeSegment& s : segments) ASSERT_NEAR(glm::length(s.ends[0]), 1 + weight, 1e-4f);
    ExpectVerticesAtTheEnds(segments);
    ASSERT_TRUE(items_[0].is_deformed);
  }
  const auto notes = edges.TakeNotes();
  ASSERT_THAT(notes, SizeIs(1));
  EXPECT_THAT(notes[0], HasSubstr("silhouettes by a scan, as it moves"));
}

TEST_F(SceneEdgesTest, ASkinnedMeshIsScannedInWorldSpaceAndEachNodeForItself) {
  scene::Primitive ball = Sphere();
  ball.joints[0].assign(ball.positions.size(), {0, 0, 0, 0});
  ball.weights[0].assign(ball.positions.size(), {1, 0, 0, 0});
  const int mesh = AddMesh("skinned", {ball});
  const int joint = AddNode(scene::kNone, At(0, 1, 0));
  const int other_joint = AddNode(scene::kNone, At(2, 0, 0));
  for (const int j : {joint, other_joint}) {
    scene::Skin skin;
    skin.joints = {j};
    skin.inverse_bind_matrices = {glm::mat4(1.0f)};
    scene_.skins.push_back(skin);
    const int node = AddNode(mesh, At(50, 50, 50));  // a skin ignores its node's own transform
    scene_.nodes[static_cast<std::size_t>(node)].skin = static_cast<int>(scene_.skins.size()) - 1;
  }
  SceneEdges edges(scene_, {});
  const auto segments = Extract(edges, From(8));
  ASSERT_GT(segments.size(), 20u);
  for (const EdgeSegment& s : segments)
    ASSERT_NEAR(glm::distance(s.ends[0], s.left_item == 0 ? glm::vec3(0, 1, 0) : glm::vec3(2, 0, 0)), 1.0f, 1e-4f);
  EXPECT_THAT(edges.TakeNotes(), SizeIs(2));
}

TEST_F(SceneEdgesTest, SortedEdgesOfTheWholeSceneRunBackToFront) {
  const int ball = AddMesh("ball", {Sphere()});
  for (const float z : {-1.0f, 2.0f, -4.0f, 1.5f}) AddNode(ball, At(0.3f * z, 0.2f, z));  // they interleave
  for (const auto& [view, eye] : {std::pair(From(10), glm::vec3(0, 0, 10)), {Orthographic(), glm::vec3(0, 0, 10)}}) {
    const auto segments = Extract(view);
    ASSERT_GT(segments.size(), 40u);
    const auto distance = [&](const EdgeSegment& s) {
      return view.orthographic ? eye.z - 0.5f * (s.ends[0].z + s.ends[1].z) : DistanceFrom(eye, s);
    };
    std::set<std::uint32_t> changes;
    for (std::size_t i = 1; i < segments.size(); ++i) {
      ASSERT_GE(distance(segments[i - 1]), distance(segments[i]) - 1e-4f);
      if (segments[i].left_item != segments[i - 1].left_item) changes.insert(segments[i].left_item);
    }
    EXPECT_THAT(changes, SizeIs(testing::Ge(3u))) << "not object by object";
    EXPECT_EQ(segments.front().left_item, 2u);
  }
}

TEST_F(SceneEdgesTest, EdgesThatHideNothingComeBeforeAllSortedOnes) {
  AddMaterials(2);
  const int flag = AddMesh("flag", {Sheet(-1, 0, 0), Sheet(0, 1, 1)});
  AddNode(AddMesh("ball", {Sphere()}), At(0, 0, -5));
  AddNode(flag, At(0, 0, 2));
  const auto segments = Extract(From(10));
  EXPECT_EQ(segments.front().edge_class, EdgeClass::kMaterial) << "beta is 0.5, so it is nowhere near a silhouette";
}

TEST_F(SceneEdgesTest, PerObjectOrderSortsWithinEachObjectOnly) {
  const int ball = AddMesh("ball", {Sphere()});
  for (const float z : {2.0f, -4.0f, 1.5f}) AddNode(ball, At(0, 0, z));
  const auto segments = Extract(From(10), EdgeMode::kSorted, false);
  const glm::vec3 eye(0, 0, 10);
  for (std::size_t i = 1; i < segments.size(); ++i) {
    ASSERT_LE(segments[i - 1].left_item, segments[i].left_item);
    if (segments[i - 1].left_item == segments[i].left_item) {
      ASSERT_GE(DistanceFrom(eye, segments[i - 1]), DistanceFrom(eye, segments[i]) - 1e-4f);
    }
  }
}

TEST_F(SceneEdgesTest, UnsortedModesStayObjectByObject) {
  const int ball = AddMesh("ball", {Sphere()});
  for (const float z : {2.0f, -4.0f}) AddNode(ball, At(0, 0, z));
  for (const EdgeMode mode : {EdgeMode::kUnsorted, EdgeMode::kResolve}) {
    const auto segments = Extract(From(10), mode);
    EXPECT_TRUE(std::ranges::is_sorted(segments, {}, &EdgeSegment::left_item));
    EXPECT_EQ(segments.size(), Extract(From(10)).size()) << "the same edges";
  }
}

TEST_F(SceneEdgesTest, NothingHasNoEdges) {
  EXPECT_THAT(Extract(From(5)), IsEmpty()) << "an empty scene";
  AddNode(AddMesh("hollow", {}));
  AddNode(AddMesh("no triangles", {scene::Primitive()}));
  scene::Primitive points = Sphere(), lines = Sphere();
  points.mode = scene::PrimitiveMode::kPoints;
  points.indices = {0, 1, 2, 3};
  lines.mode = scene::PrimitiveMode::kLines;
  lines.indices = {0, 1, 2, 3};
  AddNode(AddMesh("dust", {points}));
  AddNode(AddMesh("hair", {lines}));
  scene::Primitive needles;
  needles.positions = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
  needles.normals.assign(3, {0, 0, 1});
  needles.indices = {0, 1, 2, 0, 0, 1};
  AddNode(AddMesh("needles", {needles}));
  for (const EdgeMode mode : {EdgeMode::kUnsorted, EdgeMode::kSorted, EdgeMode::kResolve}) {
    EXPECT_THAT(Extract(From(5), mode), IsEmpty());
  }
}

TEST_F(SceneEdgesTest, PointsAndLinesBesideTrianglesKeepTheirPlace) {
  AddMaterials(2);
  scene::Primitive points = Sphere();
  points.mode = scene::PrimitiveMode::kPoints;
  points.indices = {0, 1, 2, 3};
  AddNode(AddMesh("mixed", {points, Sheet(-1, 0, 0), points, Sheet(0, 1, 1)}));
  const auto segments = Extract(From(5));
  ASSERT_EQ(segments.size(), 7u);
  std::set<std::uint32_t> items;
  for (const EdgeSegment& s : segments) items.insert({s.left_item, s.right_item});
  EXPECT_THAT(items, ElementsAre(1, 3));
  ExpectVerticesAtTheEnds(segments);
}

using Key = std::tuple<int, int, int, int, int, int, EdgeClass>;

/// A segment without regard to its direction, places to a thousandth; x mirrored by `sign`.
Key KeyOf(const EdgeSegment& s, float sign) {
  const auto whole = [](float x) { return static_cast<int>(std::lround(1000 * x)); };
  std::array<std::array<int, 3>, 2> ends;
  for (std::size_t i = 0; i < 2; ++i) ends[i] = {whole(sign * s.ends[i].x), whole(s.ends[i].y), whole(s.ends[i].z)};
  std::ranges::sort(ends);
  return {ends[0][0], ends[0][1], ends[0][2], ends[1][0], ends[1][1], ends[1][2], s.edge_class};
}

TEST_F(SceneEdgesTest, AMirroredNodeHasTheMirrorsEdges) {
  test::TriangleMesh mesh = test::Torus(14, 9);
  for (glm::vec3& p : mesh.positions) p = {p.x + 0.3f * p.y, p.y * 0.7f, p.z + 0.2f * p.x};
  test::SmoothNormals(mesh);
  mesh.triangles.resize(mesh.triangles.size() - 9);  // torn, so that there are boundaries too
  AddNode(AddMesh("ring", {PrimitiveOf(mesh)}));
  const auto straight = Extract(From(6));
  scene_.nodes[0].matrix = glm::scale(glm::mat4(1.0f), glm::vec3(-1, 1, 1));
  const auto mirrored = Extract(From(6));
  std::set<Key> straight_keys, mirrored_keys;
  for (const EdgeSegment& s : straight) straight_keys.insert(KeyOf(s, 1));
  for (const EdgeSegment& s : mirrored) mirrored_keys.insert(KeyOf(s, -1));
  EXPECT_GT(straight_keys.size(), 20u);
  EXPECT_EQ(straight_keys, mirrored_keys);
  const auto fronts = [](const EdgeSegment& s) { return s.is_left_front + s.is_right_front; };
  int straight_fronts = 0, mirrored_fronts = 0;
  for (const EdgeSegment& s : straight) straight_fronts += fronts(s);
  for (const EdgeSegment& s : mirrored) mirrored_fronts += fronts(s);
  EXPECT_EQ(straight_fronts, mirrored_fronts);
}

TEST_F(SceneEdgesTest, DoubleSidedMaterialsShowTheirBacks) {
  AddMaterials(2);
  scene_.materials[1].double_sided = true;
  const glm::mat4 turned = glm::rotate(glm::mat4(1.0f), 3.0f, glm::vec3(0, 1, 0));
  AddNode(AddMesh("single", {Sheet(-1, 1, 0)}), turned);
  EXPECT_THAT(Extract(From(5)), IsEmpty()) << "culled, so it has no edges either";
  AddNode(AddMesh("double", {Sheet(-1, 1, 1)}), turned);
  const auto segments = Extract(From(5));
  ASSERT_THAT(segments, SizeIs(4));
  for (const EdgeSegment& s : segments) {
    EXPECT_EQ(s.left_item, 1u);
    EXPECT_FALSE(s.is_left_front);
    EXPECT_TRUE(s.shows_left);
    EXPECT_FALSE(s.shows_right) << "a boundary has no other face";
  }
}

TEST_F(SceneEdgesTest, TheCreaseAngleIsTheOptions) {
  test::TriangleMesh mesh = test::Icosahedron();  // faces at 41.8 degrees
  test::SmoothNormals(mesh);
  AddNode(AddMesh("die", {PrimitiveOf(mesh)}));
  const auto creases = [&](float angle) {
    EdgeOptions options;
    options.crease_angle_deg = angle;
    SceneEdges edges(scene_, options);
    Extract(edges, From(5));
    return statistics_.sharp;
  };
  EXPECT_EQ(creases(43), 0u);
  EXPECT_EQ(creases(40), 30u);
}

TEST_F(SceneEdgesTest, PositionsThatAreNoNumbersAreRefusedWithTheMeshsName) {
  scene::Primitive bad = Sphere();
  bad.positions[7].y = std::numeric_limits<float>::quiet_NaN();
  AddNode(AddMesh("fine", {Sphere()}));
  AddNode(AddMesh("teapot", {bad}));
  const auto message = [&] {
    SceneEdges edges(scene_, {});
    const auto items = Items();
    const Result<const FrameEdges*> found = edges.Extract(items, From(5));
    EXPECT_FALSE(found.has_value());
    if (found) return std::string();
    EXPECT_EQ(found.error().kind, ErrorKind::kInput);
    return found.error().message;
  };
  EXPECT_THAT(message(), testing::StartsWith("mesh \"teapot\": vertex 7 is at ("));
  scene_.meshes[1].name.clear();
  EXPECT_THAT(message(), testing::StartsWith("mesh \"#1\": vertex 7 is at (")) << "without a name, its index";
}

TEST_F(SceneEdgesTest, TheSameFrameGivesTheSameEdges) {
  AddMaterials(2);
  const int ball = AddMesh("ball", {Sphere(3)});
  const int flag = AddMesh("flag", {Sheet(-1, 0, 0), Sheet(0, 1, 1)});
  for (int i = 0; i < 5; ++i) {
    const float a = static_cast<float>(i);
    AddNode(ball, At(a - 2, 0, -a));
    AddNode(flag, glm::rotate(At(2 - a, 1, 0), 0.4f * a, glm::vec3(0, 1, 0)));
  }
  SceneEdges edges(scene_, {.mode = EdgeMode::kSorted});
  const auto first = Extract(edges, From(9));
  Extract(edges, From(3));
  const auto again = Extract(edges, From(9));
  const auto fresh = Extract(From(9));
  ASSERT_EQ(first.size(), again.size());
  ASSERT_EQ(first.size(), fresh.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    for (const EdgeSegment& other : {again[i], fresh[i]}) {
      ASSERT_EQ(first[i].ends, other.ends);
      ASSERT_EQ(first[i].left_item, other.left_item);
      ASSERT_EQ(first[i].left_vertices, other.left_vertices);
      ASSERT_EQ(first[i].right_vertices, other.right_vertices);
      ASSERT_EQ(first[i].beta, other.beta);
      ASSERT_EQ(first[i].edge_class, other.edge_class);
    }
  }
}

TEST_F(SceneEdgesTest, ATessellatedClosedSurfaceHasSilhouettesOnly) {
  AddNode(AddMesh("pot", {test::Pot()}));
  EdgeOptions options;
  options.mode = EdgeMode::kResolve;
  // Just above even factors there are slivers that floats can hardly tell from lines.
  for (const float factor : {1.0f, 2.00001f, 3.0f, 4.0001f, 4.7f, 6.000001f}) {
    for (const auto mode : {scene::TessellationMode::kFractional, scene::TessellationMode::kInteger}) {
      scene::ItemTessellator tessellator(scene_, {.mode = mode, .edge_length_px = {}, .factor = factor});
      items_ = Items();
      ASSERT_TRUE(tessellator.TessellateEvenly(factor, items_));
      SceneEdges edges(scene_, options);
      const Result<const FrameEdges*> found = edges.Extract(items_, From(7));
      ASSERT_TRUE(found);
      EXPECT_EQ((*found)->statistics.boundaries, 0u) << factor;
      EXPECT_EQ((*found)->statistics.sharp, 0u) << factor;
      EXPECT_GT((*found)->segments.size(), 20u);
      // Silhouettes are closed lines: each end is one of an even number of segments.
      std::map<std::tuple<float, float, float>, int> ends;
      for (const EdgeSegment& segment : (*found)->segments) {
        for (const glm::vec3& end : segment.ends) ++ends[{end.x, end.y, end.z}];
      }
      for (const auto& [end, uses] : ends) EXPECT_EQ(uses % 2, 0) << factor;
    }
  }
}

TEST_F(SceneEdgesTest, SliversAddNoSilhouettes) {
  AddNode(AddMesh("pot", {test::Pot()}));
  const auto length = [&](float factor, float turn) {
    scene::ItemTessellator tessellator(scene_, {});
    items_ = Items();
    EXPECT_TRUE(tessellator.TessellateEvenly(factor, items_));
    SceneEdges edges(scene_, {});
    scene::View view = From(7);
    view.view_from_world = view.view_from_world * glm::rotate(glm::mat4(1.0f), turn, glm::vec3(0.6f, 0.8f, 0.0f));
    const Result<const FrameEdges*> found = edges.Extract(items_, view);
    float sum = 0.0f;
    for (const EdgeSegment& segment : (*found)->segments) sum += glm::distance(segment.ends[0], segment.ends[1]);
    return sum;
  };
  // Just above an even factor the new triangles are so thin that rounding turns their planes any way.
  for (const float even : {2.0f, 4.0f, 6.0f}) {
    for (const float turn : {0.3f, 1.1f, 2.3f}) {
      EXPECT_NEAR(length(even * 1.000002f, turn), length(even, turn), 0.02f * length(even, turn)) << even;
    }
  }
}

TEST_F(SceneEdgesTest, ANewSurfaceIsLookedAtAnew) {
  AddNode(AddMesh("pot", {test::Pot()}));
  scene::ItemTessellator tessellator(scene_, {});
  SceneEdges edges(scene_, {});
  std::vector<std::size_t> faces;
  for (const float factor : {1.0f, 3.0f, 1.0f}) {
    items_ = Items();
    ASSERT_TRUE(tessellator.TessellateEvenly(factor, items_));
    const Result<const FrameEdges*> found = edges.Extract(items_, From(7));
    ASSERT_TRUE(found);
    faces.push_back((*found)->statistics.faces);
  }
  EXPECT_THAT(faces, ElementsAre(8 * 512, 32 * 512, 8 * 512));
  EXPECT_THAT(edges.TakeNotes(), ElementsAre(HasSubstr("silhouettes by a scan, as its triangles change")));
}

TEST_F(SceneEdgesTest, SeamsOfTextureCoordinatesAndCreasesAreFoundOnSurfacesToo) {
  // Two sheets that meet at a right angle, with normals of their own: curved, the edge between them is a crease.
  scene::Primitive bent;
  bent.positions = {{0, -1, 0}, {1, -1, 0}, {1, 1, 0}, {0, 1, 0}, {0, -1, 0}, {0, 1, 0}, {0, 1, -1}, {0, -1, -1}};
  bent.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {-1, 0, 0}, {-1, 0, 0}, {-1, 0, 0}, {-1, 0, 0}};
  bent.indices = {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};
  AddNode(AddMesh("bent", {bent}));
  scene::ItemTessellator tessellator(scene_,
                                     {.mode = scene::TessellationMode::kInteger, .edge_length_px = {}, .factor = 4.0f});
  items_ = Items();
  ASSERT_TRUE(tessellator.TessellateEvenly(4.0f, items_));
  SceneEdges edges(scene_, {});
  const Result<const FrameEdges*> found = edges.Extract(items_, From(7));
  ASSERT_TRUE(found);
  EXPECT_EQ((*found)->statistics.sharp, 4u) << "the crease's four pieces";
}

}  // namespace
}  // namespace burin::overdraw

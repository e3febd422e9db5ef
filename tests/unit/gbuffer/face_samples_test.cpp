// SPDX-License-Identifier: Apache-2.0
#include "core/gbuffer/face_samples.h"

#include <gmock/gmock.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <set>

#include "core/gbuffer/frame_blocks.h"

namespace burin::gbuffer {
namespace {

constexpr int kSize = 200;

FaceEdge Of(std::uint32_t item, std::uint32_t points) {
  FaceEdge edge;
  edge.item = item;
  edge.vertices = {0, 1, 2};
  edge.points = points;
  return edge;
}

TEST(SamplePlan, EverySampleHasAPlaceAndItemsHaveBlocksOfTheirOwn) {
  const std::vector<FaceEdge> edges = {Of(4, 3), Of(0, 20), Of(4, 14), Of(7, 1), Of(0, 1)};
  SamplePlan plan;
  plan.first.assign(9, 1);
  PlanSamples(edges, plan);
  ASSERT_EQ(plan.first.size(), edges.size());
  std::set<std::uint32_t> places;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::uint32_t k = 0; k < edges[i].points; ++k) EXPECT_TRUE(places.insert(plan.first[i] + k).second);
  }
  ASSERT_EQ(plan.ranges.size(), 3u);
  EXPECT_EQ(plan.blocks(), 2u + 2u + 1u);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto range = std::ranges::find(plan.ranges, edges[i].item, &SampleRange::item);
    ASSERT_NE(range, plan.ranges.end());
    EXPECT_GE(plan.first[i], range->first_block * kSampleBlock);
    EXPECT_LE(plan.first[i] + edges[i].points, (range->first_block + range->blocks) * kSampleBlock);
  }
  PlanSamples({}, plan);
  EXPECT_EQ(plan.blocks(), 0u);
}

/// A triangle in perspective and what it has at its corners.
struct Face {
  std::vector<glm::vec3> positions = {{-1, -0.5f, 0}, {1.2f, 0.3f, -1}, {0.1f, 1, 0.5f}};
  std::vector<glm::vec3> normals = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}};
  std::vector<glm::vec4> colors = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}};
  std::vector<glm::vec2> texcoords = {{0, 0}, {3, 1}, {-1, 2}};
  glm::mat4 world_from_object = glm::rotate(glm::mat4(1.0f), 0.4f, glm::vec3(1, 2, 3));
  SampleView view{glm::perspective(0.9f, 1.0f, 0.1f, 50.0f) *
                      glm::lookAt(glm::vec3(0.3f, 0.2f, 4), glm::vec3(0), glm::vec3(0, 1, 0)),
                  kSize, kSize};

  [[nodiscard]] scene::ItemGeometry Geometry() const {
    scene::ItemGeometry geometry;
    geometry.positions = positions;
    geometry.normals = normals;
    geometry.colors = colors;
    geometry.texcoords[0] = texcoords;
    return geometry;
  }
  [[nodiscard]] DrawBlock Draw() const {
    scene::DrawItem item;
    item.world_from_object = world_from_object;
    return MakeDrawBlock(item);
  }
  [[nodiscard]] glm::dvec2 Pixel(const glm::dvec3& world) const {
    const glm::dvec4 clip = glm::dmat4(view.clip_from_world) * glm::dvec4(world, 1.0);
    return {(clip.x / clip.w + 1.0) * kSize / 2, (1.0 - clip.y / clip.w) * kSize / 2};
  }
  [[nodiscard]] std::vector<FaceSample> Sample(const FaceEdge& edge) const {
    std::vector<FaceSample> samples(edge.points);
    SampleEdge(edge, Geometry(), Draw(), view, samples.data());
    return samples;
  }
  [[nodiscard]] glm::vec3 World(std::size_t corner) const {
    return glm::vec3(world_from_object * glm::vec4(positions[corner], 1.0f));
  }
  [[nodiscard]] FaceEdge Edge(std::uint32_t points) const {
    FaceEdge edge = Of(0, points);
    for (int end = 0; end < 2; ++end) {
      edge.w[end] = (view.clip_from_world * glm::vec4(World(static_cast<std::size_t>(end)), 1.0f)).w;
    }
    return edge;
  }
};

TEST(FaceSamples, AreEvenlySpacedInThePictureFromEndToEnd) {
  const Face face;
  const std::vector<FaceSample> samples = face.Sample(face.Edge(9));
  const glm::dvec2 first = face.Pixel(face.World(0));
  const glm::dvec2 last = face.Pixel(face.World(1));
  for (int i = 0; i < 9; ++i) {
    const FaceSample& sample = samples[static_cast<std::size_t>(i)];
    const glm::dvec2 at = face.Pixel(glm::vec3(sample.position));
    EXPECT_LT(glm::length(at - (first + (last - first) * (i / 8.0))), 0.01) << i;
    // Attributes go with the position, not with the place in the picture.
    const float t =
        glm::length(glm::vec3(sample.position) - face.World(0)) / glm::length(face.World(1) - face.World(0));
    EXPECT_NEAR(sample.color.r, 1.0f - t, 1e-5f);
    EXPECT_NEAR(sample.color.g, t, 1e-5f);
    EXPECT_NEAR(sample.texcoords.x, 3.0f * t, 1e-5f);
  }
}

TEST(FaceSamples, OnePointIsTheMiddle) {
  const Face face;
  const FaceSample sample = face.Sample(face.Edge(1)).at(0);
  const glm::dvec2 middle = 0.5 * (face.Pixel(face.World(0)) + face.Pixel(face.World(1)));
  EXPECT_LT(glm::length(face.Pixel(glm::vec3(sample.position)) - middle), 0.01);
}

TEST(FaceSamples, ChangesAreThoseToTheNextPixel) {
  // Against intersections of the face's plane with the rays through the neighbouring places, in double precision.
  const Face face;
  const glm::dmat4 world_from_clip = glm::inverse(glm::dmat4(face.view.clip_from_world));
  const glm::dvec3 a = face.World(0), b = face.World(1), c = face.World(2);
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  const auto on_plane = [&](const glm::dvec2& pixel) {
    const glm::dvec2 ndc(pixel.x * 2 / kSize - 1, 1 - pixel.y * 2 / kSize);
    const glm::dvec4 near = world_from_clip * glm::dvec4(ndc, -0.9, 1), far = world_from_clip * glm::dvec4(ndc, 0.9, 1);
    const glm::dvec3 p = glm::dvec3(near) / near.w, q = glm::dvec3(far) / far.w;
    return p + (q - p) * (glm::dot(a - p, normal) / glm::dot(q - p, normal));
  };
  const auto texcoord = [&](const glm::dvec3& p) {
    const double whole = glm::dot(normal, normal);
    const double t = glm::dot(glm::cross(p - a, c - a), normal) / whole;
    const double s = glm::dot(glm::cross(b - a, p - a), normal) / whole;
    return glm::dvec2(face.texcoords[1]) * t + glm::dvec2(face.texcoords[2]) * s;
  };
  for (const FaceSample& sample : face.Sample(face.Edge(5))) {
    const glm::dvec2 pixel = face.Pixel(glm::vec3(sample.position));
    constexpr double kStep = 1e-3;
    const glm::dvec3 right = on_plane(pixel + glm::dvec2(kStep, 0)), here = on_plane(pixel),
                     below = on_plane(pixel + glm::dvec2(0, kStep));
    const glm::dvec3 dx = (right - here) / kStep, dy = (below - here) / kStep;
    EXPECT_LT(glm::length(dx - glm::dvec3(glm::vec3(sample.position_dx))), 1e-3 * glm::length(dx));
    EXPECT_LT(glm::length(dy - glm::dvec3(glm::vec3(sample.position_dy))), 1e-3 * glm::length(dy));
    const glm::dvec2 uv_dx = (texcoord(right) - texcoord(here)) / kStep;
    const glm::dvec2 uv_dy = (texcoord(below) - texcoord(here)) / kStep;
    EXPECT_LT(glm::length(uv_dx - glm::dvec2(glm::vec2(sample.texcoords_dx))), 1e-3 * glm::length(uv_dx));
    EXPECT_LT(glm::length(uv_dy - glm::dvec2(glm::vec2(sample.texcoords_dy))), 1e-3 * glm::length(uv_dy));
  }
}

TEST(FaceSamples, AFaceSeenEdgeOnOrWithoutAreaGivesNumbers) {
  Face face;
  for (const glm::vec3 corner : {glm::vec3(0.1f, -0.1f, -0.5f), glm::vec3(-1, -0.5f, 0), glm::vec3(1e30f)}) {
    face.positions[2] = corner;
    for (const FaceSample& sample : face.Sample(face.Edge(4))) {
      EXPECT_TRUE(
          std::isfinite(glm::dot(sample.texcoords_dx, glm::vec4(1)) + glm::dot(sample.texcoords_dy, glm::vec4(1))));
    }
  }
}

TEST(FaceSamples, WhatAMeshLacksHasTheSameValuesAsInTheGeometryPass) {
  Face face;
  scene::ItemGeometry geometry;
  geometry.positions = face.positions;
  FaceEdge edge = face.Edge(2);
  edge.is_back = true;
  std::vector<FaceSample> samples(2);
  SampleEdge(edge, geometry, face.Draw(), face.view, samples.data());
  EXPECT_EQ(samples[0].color, glm::vec4(1));
  EXPECT_EQ(samples[0].texcoords, glm::vec4(0));
  EXPECT_EQ(samples[0].position.w, 1.0f);
}

}  // namespace
}  // namespace burin::gbuffer

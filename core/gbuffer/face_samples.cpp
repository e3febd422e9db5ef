// SPDX-License-Identifier: Apache-2.0
#include "core/gbuffer/face_samples.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/mat2x2.hpp>
#include <glm/mat3x3.hpp>

namespace burin::gbuffer {
namespace {

// Faces seen edge on change without bound from pixel to pixel; more than this share of a face is all of it.
constexpr float kMostChange = 64.0f;

template <class T>
T At(std::span<const T> values, std::uint32_t index, const T& missing) {
  return values.empty() ? missing : values[index];
}

/// What the three corners of the face have.
template <class T>
struct Corners {
  T a, b, c;
  Corners(std::span<const T> values, const FaceEdge& edge, const T& missing)
      : a(At(values, edge.vertices[0], missing)),
        b(At(values, edge.vertices[1], missing)),
        c(At(values, edge.vertices[2], missing)) {}
  [[nodiscard]] T Along(float t) const { return a + (b - a) * t; }
  [[nodiscard]] T Change(const glm::vec2& share) const { return (b - a) * share.x + (c - a) * share.y; }
};

/// How far one pixel to the right, and one down, goes along the face's sides from its first corner: as shares of them.
struct PixelSteps {
  glm::vec2 right{0.0f}, down{0.0f};
};

PixelSteps StepsAt(const glm::vec3& point, const Corners<glm::vec3>& world, const SampleView& view) {
  const glm::vec4 at = view.clip_from_world * glm::vec4(point, 1.0f);
  const glm::vec2 scale = glm::vec2(0.5f, -0.5f) * glm::vec2(view.width, view.height) / at.w;
  const auto moved = [&](const glm::vec3& side) {
    const glm::vec4 d = view.clip_from_world * glm::vec4(side, 0.0f);
    return scale * (glm::vec2(d) - glm::vec2(at) * (d.w / at.w));
  };
  const glm::vec2 p = moved(world.b - world.a);
  const glm::vec2 q = moved(world.c - world.a);
  const float area = p.x * q.y - q.x * p.y;
  const auto bounded = [](const glm::vec2& v) {
    const glm::vec2 limited = glm::clamp(v, glm::vec2(-kMostChange), glm::vec2(kMostChange));
    return std::isfinite(limited.x + limited.y) ? limited : glm::vec2(0.0f);
  };
  return {bounded(glm::vec2(q.y, -p.y) / area), bounded(glm::vec2(-q.x, p.x) / area)};
}

/// Where the points lie, as `range` counts: even steps in the picture.
float PlaceOf(const FaceEdge& edge, std::uint32_t i) {
  const float s = edge.points == 1 ? 0.5f : static_cast<float>(i) / static_cast<float>(edge.points - 1);
  const float share = s * edge.w.x / (s * edge.w.x + (1.0f - s) * edge.w.y);
  return edge.range.x + (edge.range.y - edge.range.x) * share;
}

}  // namespace

void PlanSamples(std::span<const FaceEdge> edges, SamplePlan& plan) {
  plan.first.resize(edges.size());
  plan.ranges.clear();
  std::vector<std::uint32_t> points;  // by item
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const FaceEdge& edge = edges[i];
    if (edge.item >= points.size()) points.resize(edge.item + std::size_t{1}, 0);
    plan.first[i] = points[edge.item];
    points[edge.item] += edge.points;
  }
  std::vector<std::uint32_t> offsets(points.size(), 0);
  std::uint32_t block = 0;
  for (std::uint32_t item = 0; item < points.size(); ++item) {
    if (points[item] == 0) continue;
    const std::uint32_t blocks = (points[item] + kSampleBlock - 1) / kSampleBlock;
    plan.ranges.push_back({item, block, blocks});
    offsets[item] = block * kSampleBlock;
    block += blocks;
  }
  for (std::size_t i = 0; i < edges.size(); ++i) plan.first[i] += offsets[edges[i].item];
}

void SampleEdge(const FaceEdge& edge, const scene::ItemGeometry& geometry, const DrawBlock& draw,
                const SampleView& view, FaceSample* samples) {
  const Corners<glm::vec3> position(geometry.positions, edge, glm::vec3(0.0f));
  const Corners<glm::vec3> normal(geometry.normals, edge, glm::vec3(0.0f));
  const Corners<glm::vec4> tangent(geometry.tangents, edge, glm::vec4(0.0f));
  const Corners<glm::vec4> color(geometry.colors, edge, glm::vec4(1.0f));
  const std::array texcoords = {Corners<glm::vec2>(geometry.texcoords[0], edge, glm::vec2(0.0f)),
                                Corners<glm::vec2>(geometry.texcoords[1], edge, glm::vec2(0.0f))};
  Corners<glm::vec3> world = position;
  for (glm::vec3* corner : {&world.a, &world.b, &world.c}) {
    *corner = glm::vec3(draw.world_from_object * glm::vec4(*corner, 1.0f));
  }
  const glm::mat3 normal_matrix(draw.normal_columns[0], draw.normal_columns[1], draw.normal_columns[2]);
  const bool has_texcoords = !geometry.texcoords[0].empty() || !geometry.texcoords[1].empty();
  for (std::uint32_t i = 0; i < edge.points; ++i) {
    const float t = PlaceOf(edge, i);
    FaceSample& sample = samples[i];
    const glm::vec3 point = world.Along(t);
    sample.position = glm::vec4(point, edge.is_back ? 1.0f : 0.0f);
    sample.normal = glm::vec4(normal_matrix * normal.Along(t), 0.0f);
    sample.tangent = glm::vec4(glm::mat3(draw.world_from_object) * glm::vec3(tangent.Along(t)),
                               tangent.a.w * draw.normal_columns[0].w);
    sample.color = color.Along(t);
    sample.texcoords = glm::vec4(texcoords[0].Along(t), texcoords[1].Along(t));
    const PixelSteps steps = has_texcoords ? StepsAt(point, world, view) : PixelSteps{};
    sample.position_dx = glm::vec4(world.Change(steps.right), 0.0f);
    sample.position_dy = glm::vec4(world.Change(steps.down), 0.0f);
    sample.texcoords_dx = glm::vec4(texcoords[0].Change(steps.right), texcoords[1].Change(steps.right));
    sample.texcoords_dy = glm::vec4(texcoords[0].Change(steps.down), texcoords[1].Change(steps.down));
  }
}

std::string_view FaceSampleIndex() {
  return "((int(gl_FragCoord.y) / 4 * 256 + int(gl_FragCoord.x) / 4) * 16 + int(gl_FragCoord.y) % 4 * 4 + "
         "int(gl_FragCoord.x) % 4)";
}

}  // namespace burin::gbuffer

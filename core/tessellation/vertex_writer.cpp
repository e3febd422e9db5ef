// SPDX-License-Identifier: Apache-2.0
#include "core/tessellation/vertex_writer.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/vector_double3.hpp>
#include <glm/geometric.hpp>

#include "core/geometry/bezier_evaluate.h"

namespace burin::tessellation {
namespace {

// A tangent whose part across the normal is shorter than this share of it has no usable direction.
constexpr double kUsableTangent = 1e-6;

glm::dvec3 AnyPerpendicular(const glm::dvec3& n) {
  const glm::dvec3 axis = std::abs(n.x) < 0.9 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
  return glm::normalize(axis - n * glm::dot(n, axis));
}

glm::dvec3 Xyz(const Lanes& value) { return {value[0], value[1], value[2]}; }

/// Of P / w, without the positive factor 1 / w^2.
glm::dvec3 QuotientDerivative(const Lanes& position, const Lanes& derivative) {
  return Xyz(derivative) * position[3] - Xyz(position) * derivative[3];
}

/// The direction in which the first texture coordinate grows, and on which side the second one does, as
/// scene::MakeTangents has them: w is -1 where texture coordinates turn counterclockwise with the surface.
glm::vec4 TangentOf(const glm::dvec3& du, const glm::dvec3& dv, const glm::dvec2& st_du, const glm::dvec2& st_dv,
                    const glm::dvec3& normal) {
  const double area = st_du.x * st_dv.y - st_dv.x * st_du.y;
  glm::dvec3 direction = du * st_dv.y - dv * st_du.y;
  if (area < 0.0) direction = -direction;
  const glm::dvec3 across = direction - normal * glm::dot(normal, direction);
  const double length = glm::length(across);
  const glm::dvec3 unit = length > kUsableTangent * glm::length(direction) ? across / length : AnyPerpendicular(normal);
  return {glm::vec3(unit), area < 0.0 ? 1.0f : -1.0f};
}

}  // namespace

void VertexWriter::Write(const ChannelValues& values, const VertexRun& run) const {
  if (run.count == 0) return;
  const auto channel = [&](Channel c) { return values[static_cast<std::size_t>(c)]; };
  float* const positions = &surface->positions[run.first].x;
  if (patch->is_rational) {
    kernels->store_projected(channel(Channel::kPosition), run.count, positions);
  } else {
    kernels->store_xyz(channel(Channel::kPosition), run.count, positions);
  }
  WriteNormals(values, run);
  if (!surface->patch_uv.empty())
    kernels->store_line(run.parameters, run.count, &run.from.x, &run.to.x, &surface->patch_uv[run.first].x);
  if (!surface->patch_ids.empty()) std::fill_n(&surface->patch_ids[run.first], run.count, patch->face);
  WriteTexcoords(0, channel(Channel::kTexcoord0), run);
  WriteTexcoords(1, channel(Channel::kTexcoord1), run);
  WriteColors(channel(Channel::kColor), run);
  if (!surface->tangents.empty()) WriteTangents(values, run);
}

void VertexWriter::WriteNormals(const ChannelValues& values, const VertexRun& run) const {
  const Lanes* const stepped = values[static_cast<std::size_t>(Channel::kNormal)];
  if (!kernels->store_units(stepped, run.count, &surface->normals[run.first].x)) return;
  for (std::uint32_t i = 0; i < run.count; ++i) {
    if (!IsShortNormal(stepped[i])) continue;
    const glm::dvec2 at = run.from + run.parameters[i] * (run.to - run.from);
    surface->normals[run.first + i] = geometry::EvaluateBezier(*patches, *patch, at.x, at.y).normal;
  }
}

void VertexWriter::WriteTexcoords(std::size_t set, const Lanes* values, const VertexRun& run) const {
  auto& texcoords = surface->texcoords[set];
  if (texcoords.empty()) return;
  if (patch->texcoord[set]) {
    kernels->store_xy(values, run.count, &texcoords[run.first].x);
  } else {
    std::fill_n(&texcoords[run.first], run.count, glm::vec2(0.0f));
  }
}

void VertexWriter::WriteColors(const Lanes* values, const VertexRun& run) const {
  if (surface->colors.empty()) return;
  if (patch->color) {
    kernels->store_xyzw(values, run.count, &surface->colors[run.first].x);
  } else {
    std::fill_n(&surface->colors[run.first], run.count, glm::vec4(1.0f));
  }
}

void VertexWriter::WriteTangents(const ChannelValues& values, const VertexRun& run) const {
  const auto at = [&](Channel c, std::uint32_t i) -> const Lanes& { return values[static_cast<std::size_t>(c)][i]; };
  for (std::uint32_t i = 0; i < run.count; ++i) {
    glm::dvec3 du = Xyz(at(Channel::kPositionDu, i)), dv = Xyz(at(Channel::kPositionDv, i));
    if (patch->is_rational) {
      du = QuotientDerivative(at(Channel::kPosition, i), at(Channel::kPositionDu, i));
      dv = QuotientDerivative(at(Channel::kPosition, i), at(Channel::kPositionDv, i));
    }
    glm::dvec2 st_du(1.0, 0.0), st_dv(0.0, 1.0);
    if (patch->texcoord[0]) {
      st_du = {at(Channel::kTexcoordDu, i)[0], at(Channel::kTexcoordDu, i)[1]};
      st_dv = {at(Channel::kTexcoordDv, i)[0], at(Channel::kTexcoordDv, i)[1]};
    }
    surface->tangents[run.first + i] = TangentOf(du, dv, st_du, st_dv, glm::dvec3(surface->normals[run.first + i]));
  }
}

}  // namespace burin::tessellation

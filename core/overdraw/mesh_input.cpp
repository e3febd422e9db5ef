// SPDX-License-Identifier: Apache-2.0
#include "core/overdraw/mesh_input.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <limits>

namespace burin::overdraw {
namespace {

/// Corners (three a triangle) are counted in 32 bits, one value kept for "none".
constexpr std::size_t kMostCorners = std::numeric_limits<std::uint32_t>::max() - 1;

Result<void> CheckLengths(const MeshInput& input) {
  if (input.triangles.size() % 3 != 0)
    return Fail(ErrorKind::kInput, fmt::format("mesh \"{}\": {} triangle indices, expected a multiple of three",
                                               input.name, input.triangles.size()));
  if (input.positions.size() > kMostCorners || input.triangles.size() > kMostCorners)
    return Fail(ErrorKind::kInput,
                fmt::format("mesh \"{}\": {} vertices and {} triangles, expected at most {} and {}", input.name,
                            input.positions.size(), input.triangles.size() / 3, kMostCorners, kMostCorners / 3));
  const std::size_t vertices = input.positions.size(), faces = input.triangles.size() / 3;
  const struct {
    std::string_view what;
    std::size_t found, expected;
    std::string_view each;
  } arrays[] = {{"normals", input.normals.size(), vertices, "vertices"},
                {"colours", input.colors.size(), vertices, "vertices"},
                {"texture coordinates", input.texcoords[0].size(), vertices, "vertices"},
                {"texture coordinates", input.texcoords[1].size(), vertices, "vertices"},
                {"face materials", input.face_materials.size(), faces, "triangles"},
                {"face sides", input.face_double_sided.size(), faces, "triangles"}};
  for (const auto& array : arrays) {
    if (array.found == 0 || array.found == array.expected) continue;
    return Fail(ErrorKind::kInput, fmt::format("mesh \"{}\": {} {}, expected one for each of its {} {}", input.name,
                                               array.found, array.what, array.expected, array.each));
  }
  return {};
}

}  // namespace

Result<void> CheckMeshInput(const MeshInput& input) {
  if (Result<void> lengths = CheckLengths(input); !lengths) return lengths;
  for (std::size_t i = 0; i < input.triangles.size(); ++i) {
    if (input.triangles[i] >= input.positions.size())
      return Fail(ErrorKind::kInput, fmt::format("mesh \"{}\": triangle {} has vertex {}, expected less than {}",
                                                 input.name, i / 3, input.triangles[i], input.positions.size()));
  }
  for (std::size_t i = 0; i < input.positions.size(); ++i) {
    const glm::vec3& p = input.positions[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      return Fail(ErrorKind::kInput, fmt::format("mesh \"{}\": vertex {} is at ({}, {}, {}), expected finite numbers",
                                                 input.name, i, p.x, p.y, p.z));
  }
  return {};
}

}  // namespace burin::overdraw

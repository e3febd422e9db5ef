// SPDX-License-Identifier: Apache-2.0
#pragma once
// Bézier patches as plain arrays: control nets in, whatever evaluates them out. No view, no GL.

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace burin::geometry {

/// Quads: (u, v) in the unit square. Triangles: u, v >= 0 and u + v <= 1.
enum class PatchDomain : std::uint8_t { kQuad, kTriangle };

/// One attribute's control net. Orders are degrees + 1, 1 to 8; of a triangle both are the same. The value of index
/// (i along u, j along v) is at `first` + j * u_order + i for quads and `first` + j * u_order + i - j * (j - 1) / 2
/// for triangles (GL_NV_evaluators' packing).
struct ControlNet {
  std::uint32_t first = 0;
  std::uint8_t u_order = 0;  ///< 0: the patch has no such attribute
  std::uint8_t v_order = 0;
  explicit operator bool() const { return u_order != 0; }
};

/// How many values a net has.
[[nodiscard]] constexpr std::uint32_t ValueCount(PatchDomain domain, const ControlNet& net) {
  return domain == PatchDomain::kQuad ? std::uint32_t{net.u_order} * net.v_order
                                      : std::uint32_t{net.u_order} * (net.u_order + 1u) / 2u;
}

/// Where, from `first` on, the value of index i along u, j along v is.
[[nodiscard]] constexpr std::uint32_t ValueIndex(PatchDomain domain, const ControlNet& net, std::uint32_t i,
                                                 std::uint32_t j) {
  return j * net.u_order + i - (domain == PatchDomain::kQuad ? 0 : (j * j - j) / 2);
}

struct BezierPatch {
  PatchDomain domain = PatchDomain::kQuad;
  bool is_rational = false;  ///< positions are homogeneous: (w x, w y, w z, w); orders up to 4
  ControlNet position;       ///< in BezierPatches::positions
  ControlNet normal;         ///< in `normals`; absent: the cross product of the position's derivatives, u then v
  std::array<ControlNet, 2> texcoord;
  ControlNet color;
  std::uint32_t face = 0;  ///< what `patchid` says: which face of the model it came from
};

/// Patches of one material. Two patches that share a boundary have the same control positions there, in either
/// direction; nothing else says that they are neighbours.
struct BezierPatches {
  std::vector<BezierPatch> patches;
  std::vector<glm::vec4> positions;  ///< w is 1 where a patch is not rational
  std::vector<glm::vec3> normals;    ///< any length; an order of their own
  std::array<std::vector<glm::vec2>, 2> texcoords;
  std::vector<glm::vec4> colors;
};

}  // namespace burin::geometry

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "core/geometry/bezier_patches.h"

namespace burin::tessellation {

[[nodiscard]] inline std::uint32_t SideCount(geometry::PatchDomain domain) {
  return domain == geometry::PatchDomain::kQuad ? 4 : 3;
}

/// Control points along a side (in the order of Factors).
[[nodiscard]] std::uint32_t SideOrder(const geometry::BezierPatch& patch, std::uint32_t side);

/// Which of BezierPatches::positions is point k of a side, in the side's own direction.
[[nodiscard]] std::uint32_t SidePoint(const geometry::BezierPatch& patch, std::uint32_t side, std::uint32_t k);

enum class SideShape : std::uint8_t {
  kOpen,   ///< from one place to another
  kLoop,   ///< back to where it starts
  kPoint,  ///< all control points at one place
};

/// A neighbour along a side sees the same shape.
[[nodiscard]] std::array<SideShape, 4> SideShapes(const geometry::BezierPatches& patches,
                                                  const geometry::BezierPatch& patch);

/// Whether a side stays so close to where it starts that, seen at the patch's size, it is a point: models have such
/// loops where their authors wanted a normal at a pole.
[[nodiscard]] bool IsNearlyPoint(const geometry::BezierPatches& patches, const geometry::BezierPatch& patch,
                                 std::uint32_t side);

}  // namespace burin::tessellation

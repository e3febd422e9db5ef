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

/// Which sides have all their control points at one place.
[[nodiscard]] std::array<bool, 4> CollapsedSides(const geometry::BezierPatches& patches,
                                                 const geometry::BezierPatch& patch);

}  // namespace burin::tessellation

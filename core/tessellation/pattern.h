// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/tessellation/kernels.h"
#include "core/tessellation/patch_layout.h"

namespace burin::tessellation {

/// Writes layout.triangle_count triangles, three indices each, counterclockwise in (u, v), of the layout's vertices
/// counted from `first_vertex`.
void WritePattern(const Kernels& kernels, const PatchLayout& layout, std::uint32_t first_vertex,
                  std::uint32_t* indices);

/// Drops the triangles of `count` indices that have two corners on one collapsed side; the others keep their order.
/// Returns how many indices are left. Indices count from 0.
[[nodiscard]] std::size_t DropCollapsed(const PatchLayout& layout, std::uint32_t* indices, std::size_t count);

}  // namespace burin::tessellation

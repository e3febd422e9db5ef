// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace burin::overdraw {

/// TilePass's body for EdgeRecords of areas: each pixel that a visible edge crosses is mixed, in linear light, with
/// what lies across the edge by the exact area that it has. Nothing grows, and nothing but those pixels is touched.
/// After Persson, "Geometric Post-process Anti-Aliasing" (2011), with areas instead of distances.
[[nodiscard]] std::string_view ResolveBody();

}  // namespace burin::overdraw

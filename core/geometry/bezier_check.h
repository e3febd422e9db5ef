// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "core/base/error.h"
#include "core/geometry/bezier_patches.h"

namespace burin::geometry {

inline constexpr int kMaxBezierOrder = 8;
inline constexpr int kMaxRationalOrder = 4;

/// Whether every patch can be evaluated: orders of GL_NV_evaluators (positions 2 to 8, rational ones up to 4, other
/// attributes 1 to 8), nets that lie within their arrays, finite values, weights above zero. The error names `name`
/// (the model), the first faulty patch and its control point, both counted from 1.
[[nodiscard]] Result<void> CheckPatches(const BezierPatches& patches, std::string_view name);

}  // namespace burin::geometry

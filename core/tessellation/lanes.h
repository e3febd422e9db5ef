// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace burin::tessellation {

/// One value of any attribute: up to four components, unused ones 0.
using Lanes = double __attribute__((vector_size(32)));

/// Normals of order 8 patches have degree 2 * 7 - 1 along each side.
inline constexpr int kMaxNetOrder = 14;

}  // namespace burin::tessellation

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/bench/edge_quality/stand.h"

namespace burin::bench {

/// The pixels within two pixels of a visible discontinuity edge: outlines, occlusions, creases, borders of materials
/// and seams of vertex colours, as attributes at four times the size show them. Where textures change is no edge.
[[nodiscard]] Mask EdgeMask(Stand& stand, const Method& plain, const Place& place);

}  // namespace burin::bench

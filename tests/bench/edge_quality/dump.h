// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tests/bench/edge_quality/picture.h"

namespace burin::bench {

/// Writes `picture` as an sRGB-encoded PPM, to be looked at; pixels outside `mask`, if there is one, are darkened.
/// False when the file cannot be written.
[[nodiscard]] bool WritePpm(const std::string& path, const Picture& picture, const Mask* mask);

}  // namespace burin::bench

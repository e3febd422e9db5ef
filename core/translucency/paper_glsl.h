// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace burin::translucency {

/// GLSL: `Sum Gather(vec3 unit, int face, bool is_asked)` as the paper gathers (sections 4.3 and 4.4), to be compared
/// with the whole dipole. `kernel`: samples across it.
[[nodiscard]] std::string PaperGatherFunctions(int kernel);

}  // namespace burin::translucency

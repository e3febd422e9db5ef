// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "core/effect/render_states.h"

namespace burin::effect {

/// What a draw needs to know besides the states themselves.
struct DrawTargets {
  /// Components that may be written of each colour target, as ColorWriteEnable's bits: 7 where the format has no alpha, 0
  /// where the shader writes no such target.
  std::span<const int> writable;
  bool has_depth_stencil = false;
};

/// Sets every GL state that a pass depends on. `front_is_clockwise`: which winding on the screen is a front face, to
/// Direct3D's eyes clockwise; the geometry of a mirrored object or of a counter-clockwise model turns it round.
void BindStates(const RenderStates& states, const DrawTargets& targets, bool front_is_clockwise);

}  // namespace burin::effect

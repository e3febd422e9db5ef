// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace burin::gl {

/// What Context promises for its life (context.h); called once.
void SetConventions();

/// Puts back everything that an effect's pass may have changed: no depth, stencil, blend, scissor or cull, all colours
/// written, filled polygons, no bias, no sRGB writes, front faces counter-clockwise as glTF has them on the screen. A
/// renderer calls it before it draws and then sets only what it wants different.
void ResetState();

}  // namespace burin::gl

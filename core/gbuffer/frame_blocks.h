// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/mat4x4.hpp>

#include "core/gbuffer/attribute_renderer.h"
#include "core/gbuffer/gpu_blocks.h"
#include "core/gbuffer/key_light.h"

namespace burin::gbuffer {

/// The projection with depth turned round: 1 at the near plane, 0 at the far one, so that floating-point depth is fine
/// far away too (Reed, "Depth Precision Visualized", 2015). Rows x, y, w stay.
[[nodiscard]] glm::mat4 ReverseDepth(const scene::View& view);

/// The view's projection with reversed depth times its view matrix, rounded once.
[[nodiscard]] glm::mat4 ClipFromWorld(const scene::View& view);

/// Camera and key light; the environment's members are the caller's.
[[nodiscard]] FrameBlock MakeFrameBlock(const FrameInput& frame, const KeyLight& key, int width, int height);
[[nodiscard]] DrawBlock MakeDrawBlock(const scene::DrawItem& item);

/// True when the transform turns left into right: the other winding is the front.
[[nodiscard]] bool IsMirrored(const glm::mat4& world_from_object);

}  // namespace burin::gbuffer

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/gbuffer/gpu_blocks.h"
#include "core/scene/pose.h"
#include "core/scene/scene.h"

namespace burin::gbuffer {

/// The shown lights as the shaders read them, intensities times `exposure`.
[[nodiscard]] std::vector<LightRecord> BuildLights(const scene::Scene& scene, const scene::Pose& pose, float exposure);

/// Files give lights in lux and candela, from 1 to 100,000, and say nothing of the camera. Where all lights together
/// give the scene's middle more than pi lux (a white surface that faces them is then 1, display white), they are scaled
/// down to that, like a camera on automatic exposure that only ever stops down; weaker ones stay as they are. Computed
/// once, at rest, so that a frame's brightness does not depend on the others.
[[nodiscard]] float LightExposure(const scene::Scene& scene);

}  // namespace burin::gbuffer

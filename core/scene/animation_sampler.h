// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "core/scene/scene.h"

namespace burin::scene {

/// The value of a channel at `time_s`, `channel.components` floats; before the first key and after the last it is
/// theirs. Rotations (x, y, z, w) come out with unit length.
void SampleChannel(const AnimationChannel& channel, float time_s, std::span<float> out);

/// Spherical interpolation along the shorter arc of unit quaternions.
[[nodiscard]] glm::quat Slerp(const glm::quat& a, const glm::quat& b, float t);

}  // namespace burin::scene

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/scene/scene.h"

namespace burin::scene {

/// Which of a file's axes points upwards. glTF says y; patch models and .obj files don't say.
enum class UpAxis : std::uint8_t { kX, kMinusX, kY, kMinusY, kZ, kMinusZ };

/// Turns the whole scene, cameras and lights included, by the least turn that takes the axis to y.
void TurnUpwards(UpAxis axis, Scene& scene);

}  // namespace burin::scene

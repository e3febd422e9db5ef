// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a scene holds, for `burin info`.

#include <string>

#include "core/scene/scene.h"

namespace burin::scene {

/// For people: a few indented lines. For programs: one JSON object, indented by two.
/// Both give names, sizes, materials, cameras, lights, animations with their durations, and the bounds at time 0.
[[nodiscard]] std::string DescribeScene(const Scene& scene, bool as_json);

}  // namespace burin::scene

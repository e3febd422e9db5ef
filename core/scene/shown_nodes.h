// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/scene/scene.h"

namespace burin::scene {

/// Per node: whether it is on or below one of Scene::roots.
[[nodiscard]] std::vector<bool> ShownNodes(const Scene& scene);

}  // namespace burin::scene

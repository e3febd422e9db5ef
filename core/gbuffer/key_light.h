// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "core/scene/pose.h"
#include "core/scene/scene.h"

namespace burin::gbuffer {

/// The light that `lightdepth` and an effect's light parameters mean: the first light among the shown nodes, in the
/// file's order; without any, the key light of the built-in studio, directional.
struct KeyLight {
  scene::LightType type = scene::LightType::kDirectional;
  glm::vec3 position{0.0f};                ///< world; of a directional light its node's
  glm::vec3 direction{0.0f, -1.0f, 0.0f};  ///< world, towards which it shines, unit
  glm::vec3 color{1.0f};                   ///< linear, without intensity
};

[[nodiscard]] KeyLight FindKeyLight(const scene::Scene& scene, const scene::Pose& pose);

/// Nodes that carry a light and hang under the shown scene's roots, in the file's order.
[[nodiscard]] std::vector<int> LightNodes(const scene::Scene& scene);

}  // namespace burin::gbuffer

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/render/scene_stage.h"

namespace burin::bench {

/// One way to draw an antialiased frame.
struct Method {
  std::string name;
  render::SceneOptions options;
  /// The frame is the mean of one rendering at each of these places within a pixel, (0, 0) being its centre.
  std::vector<glm::dvec2> offsets = {{0.0, 0.0}};
  /// What its frame time is taken of; nothing: the real thing is not here to be timed.
  std::optional<render::SceneOptions> timed;
};

/// Every method of the tables, "none" first. A mode of the edge stage is one line there. Context's thread.
[[nodiscard]] std::vector<Method> Methods(const glm::vec4& background);

}  // namespace burin::bench

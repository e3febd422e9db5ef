// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "fx_parser/effect/effect.h"

namespace burin::effect {

/// One pass as it is run.
struct Step {
  std::size_t technique = 0;
  std::size_t pass = 0;
  bool draws_scene = false;            ///< a custom attribute's pass: the scene's geometry, not the quadrilateral
  std::vector<std::size_t> targets;    ///< indices in Effect::textures; empty: the frame
  glm::ivec2 size{0};                  ///< of the targets, pixels
  bool clears_targets = false;         ///< the first that touches them in a frame
  bool uses_depth_stencil = false;     ///< with the buffer that all targets of its size share
  bool clears_depth_stencil = false;
};

/// What one technique does in a frame, in order, and what it touches.
struct Schedule {
  std::vector<std::size_t> attributes;         ///< textures that the caller fills
  std::vector<std::size_t> custom_attributes;  ///< textures that scene-drawing steps fill
  std::vector<std::size_t> pass_results;
  std::vector<std::size_t> files;
  /// Targets that a step looks up before any step has drawn into them: cleared as the frame starts.
  std::vector<std::size_t> cleared_at_start;
  bool clears_frame_at_start = false;          ///< no step draws into the frame
  std::vector<Step> steps;
  std::vector<glm::ivec2> texture_sizes;       ///< of every texture; those of files are (1, 1) until they are loaded
};

/// round(scale * frame), at least 1.
[[nodiscard]] glm::ivec2 ScaledSize(double scale, glm::ivec2 frame);

/// Only textures that the technique (or a custom attribute that it reads) looks up are in the schedule.
[[nodiscard]] Schedule MakeSchedule(const fx::Effect& effect, std::size_t technique, glm::ivec2 frame);

}  // namespace burin::effect

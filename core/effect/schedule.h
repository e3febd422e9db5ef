// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "fx_parser/effect/effect.h"

namespace burin::effect {

/// What a script's Clear clears, and the parameters that hold with what: black and transparent, 1 and 0 without.
struct ClearStep {
  bool color = false, depth = false, stencil = false;
  std::optional<std::size_t> color_parameter, depth_parameter, stencil_parameter;
};

/// A parameter that a script's loop sets to the number of its turn.
struct LoopTurn {
  std::size_t parameter = 0;
  double number = 0;
};

/// One pass as it is run, or what a script does between passes.
struct Step {
  enum class Kind {
    kPass,
    kClear,  ///< `clear`
    kSource  ///< copies the scene's or picture's colour into the first target
  };
  Kind kind = Kind::kPass;
  std::size_t technique = 0;
  std::size_t pass = 0;
  bool draws_scene = false;          ///< the scene's geometry, not the quadrilateral
  bool shows_source = false;         ///< textures without a file show the source's picture, over the quadrilateral
  std::vector<std::size_t> targets;  ///< indices in Effect::textures; empty: the frame
  glm::ivec2 size{0};                ///< of the targets, pixels
  bool clears_targets = false;       ///< the first that touches them in a frame
  bool uses_depth_stencil = false;   ///< with the buffer that all targets of its size share
  bool clears_depth_stencil = false;
  std::optional<std::size_t> depth_stencil;  ///< a texture of a script whose buffer it is; otherwise its size's
  std::string viewer;                        ///< the light that the scene is seen from; empty: the camera
  ClearStep clear;
  std::vector<LoopTurn> loop_turns;
};

/// What one technique does in a frame, in order, and what it touches.
struct Schedule {
  std::vector<std::size_t> attributes;         ///< textures that the caller fills
  std::vector<std::size_t> custom_attributes;  ///< textures that scene-drawing steps fill
  std::vector<std::size_t> pass_results;
  std::vector<std::size_t> files;
  std::vector<std::size_t> offscreen;   ///< of pass_results: what the runner fills before the steps
  std::vector<std::size_t> procedural;  ///< textures that functions fill before the first frame
  /// Targets that a step looks up before any step has drawn into them: cleared as the frame starts.
  std::vector<std::size_t> cleared_at_start;
  bool clears_frame_at_start = false;  ///< no step draws into the frame, or some only into a part of it
  bool copies_source = false;          ///< some step is a kSource
  bool replaces_scene = false;         ///< a picture stands in for the scene's geometry
  bool is_cut = false;                 ///< there were more steps than kMaxSteps
  std::vector<Step> steps;
  std::vector<glm::ivec2> texture_sizes;  ///< of every texture; those of files are (1, 1) until they are loaded
};

/// round(scale * frame), at least 1.
[[nodiscard]] glm::ivec2 ScaledSize(double scale, glm::ivec2 frame);

struct ScheduleOptions {
  /// The source is a scene: passes without a script that project vertices draw it; otherwise the quadrilateral.
  bool has_scene = false;
  /// The first component of a parameter, for the counts of scripts' loops; empty: its default.
  std::function<double(std::size_t parameter)> number;
  /// TechniqueChoice::by_object: the steps of all of these, in order, instead of the one technique's.
  std::vector<std::size_t> by_object = {};
};

/// Steps that one frame may have: what scripts' loops run beyond it is left out, with a warning of the runner.
inline constexpr std::size_t kMaxSteps = 4096;

/// Only textures that the technique (or a custom attribute that it reads) looks up or draws into are in the schedule.
[[nodiscard]] Schedule MakeSchedule(const fx::Effect& effect, std::size_t technique, glm::ivec2 frame,
                                    const ScheduleOptions& options = {});

}  // namespace burin::effect

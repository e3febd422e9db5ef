// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/image/image_module.h"
#include "core/overdraw/edge_options.h"
#include "core/scene/tessellation_options.h"
#include "core/scene/up_axis.h"
#include "core/translucency/translucency_options.h"
#include "core/video/video_module.h"

namespace burin::render {

/// Whether the frame's alpha goes into the file: kAuto keeps it where the source has one (scenes, pictures with alpha).
enum class AlphaOutput { kAuto, kKeep, kDrop };

/// Everything that `burin render` was asked for, as values; checked for form, not yet against files.
struct Job {
  std::vector<std::string> effects;  ///< files, in chain order
  std::string source;                ///< scene, image, sequence pattern, video, "-"; empty: none
  std::string output;                ///< file, pattern, video, "-"
  std::vector<std::string> include_folders;
  std::vector<std::pair<std::string, std::string>> definitions;
  std::vector<std::pair<std::string, std::string>> parameters;
  std::string technique;
  std::vector<std::string> attributes;  ///< --attributes
  std::vector<long> frames;             ///< ascending; empty: all that the source has
  std::optional<video::FrameRate> fps;
  std::optional<std::pair<int, int>> size;
  std::string camera;
  std::optional<double> orbit_deg;
  /// Frames of a full turn that ends where it began (frame 1 + turntable_frames looks like frame 1); 0: no turning.
  long turntable_frames = 0;
  std::string animation = "auto";
  scene::UpAxis up = scene::UpAxis::kY;
  std::string environment;
  std::optional<std::array<float, 4>> background;  ///< scene-linear RGBA behind a scene; absent: transparent
  overdraw::EdgeOptions edges;
  scene::TessellationOptions tessellation;
  translucency::TranslucencyOptions translucency;
  float morph_to_sphere = 0.0f;  ///< 0..1
  int samples = 1;               ///< of a scene's colour, a pixel: 1, 4 or 16
  image::ColorOptions color;
  std::string device = "auto";
  int threads = 0;
  int depth_bits = 0;  ///< 0: the output's usual
  AlphaOutput alpha = AlphaOutput::kAuto;
  std::optional<video::Chroma> chroma;  ///< of y4m; absent: the source's, else 4:4:4
  int quality = 95;
  bool keep_going = false;
  bool make_folders = false;
};

}  // namespace burin::render

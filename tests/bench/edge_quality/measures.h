// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tests/bench/edge_quality/stand.h"

namespace burin::bench {

/// How much work a run is.
struct Effort {
  int size = 512;               ///< of the quality frames, square
  int reference_samples = 256;  ///< of a still frame, a pixel
  int frames = 100;             ///< of each motion
  /// Of a panned reference frame, a pixel; a 20th of them is rendered for each.
  int pan_samples = 1280;
  /// Of a turned reference frame, a pixel. Crawl is right to 4 % from 64 on; the second difference is not (the
  /// reference's own steps count against it), so "second turn" compares methods only.
  int turn_samples = 64;
  int time_size = 1024;
  int time_rounds = 15;
};

/// One number of the tables.
struct Figure {
  std::string measure;
  std::string method;
  double value = 0.0;
};

/// Root mean square error x 255 against the reference over the mask's pixels and three channels.
[[nodiscard]] std::vector<Figure> StillErrors(Stand& stand, const std::vector<Method>& methods, const Effort& effort);

/// "crawl NAME": mean |dI - dI of the reference| x 255 from frame to frame; "second NAME": mean |d2I| less that of the
/// reference. NAME: pan (the picture slides by 0.05 pixels a frame) or turn (the camera orbits and rolls about a
/// point off the middle, edges move by about as much).
[[nodiscard]] std::vector<Figure> Crawl(Stand& stand, const std::vector<Method>& methods, const Effort& effort,
                                        bool is_turn);

/// An isolated edge at 12 angles and several places: "bloat": mean area that is covered too much, in pixels
/// perpendicular to the edge; "bloat abs": mean of the absolute error of each column (row, where the edge is steep).
[[nodiscard]] std::vector<Figure> Bloat(const std::vector<Method>& methods, int size);

/// "frame ms" and "frame ratio" (median of the ratios to "none" of the same round) at the timing size, 8-bit display
/// target, after one frame to warm up.
[[nodiscard]] std::vector<Figure> FrameTimes(Stand& stand, const std::vector<Method>& methods, int rounds);

}  // namespace burin::bench

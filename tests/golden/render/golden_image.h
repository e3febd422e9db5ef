// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/image/image.h"

namespace burin::golden {

/// How far a picture may be from its golden one, in 8-bit steps: the largest difference of any sample, and the mean
/// over all of them.
struct Tolerance {
  int max_difference = 0;
  double mean_difference = 0.0;
};

/// Smooth shading: drivers round differently in the last bits.
inline constexpr Tolerance kShaded{6, 0.25};
/// Thresholds, ids and silhouettes: a last bit can turn a whole pixel, so only how many do is bounded.
inline constexpr Tolerance kThresholded{255, 1.0};

/// --update-golden: golden images are written instead of compared.
extern bool update_golden;

/// Compares an 8-bit PNG at `path` with tests/golden/images/<name>.png; a failure of the running test says by how much
/// and where the picture and the difference (eight times) were kept.
void ExpectGolden(const std::string& path, const std::string& name, const Tolerance& tolerance);

}  // namespace burin::golden

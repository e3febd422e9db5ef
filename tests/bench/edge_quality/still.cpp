// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "tests/bench/edge_quality/edge_mask.h"
#include "tests/bench/edge_quality/measures.h"

namespace burin::bench {
namespace {

/// The bench looks at each scene from two sides, so that no one view decides.
constexpr double kOrbits_deg[] = {0.0, 137.0};

double SquaredError(const Picture& picture, const Picture& reference, const Mask& mask) {
  double sum = 0.0;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask[i] == 0) continue;
    for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) {
      const double error = static_cast<double>(picture.rgb[c]) - reference.rgb[c];
      sum += error * error;
    }
  }
  return sum;
}

}  // namespace

std::vector<Figure> StillErrors(Stand& stand, const std::vector<Method>& methods, const Effort& effort) {
  const Method& plain = methods.front();
  std::vector<double> sums(methods.size(), 0.0);
  double pixels = 0.0;
  double share = 0.0;
  for (const double orbit_deg : kOrbits_deg) {
    const Place place{.orbit_deg = orbit_deg};
    const Picture reference = Reference(stand, plain, place, effort.reference_samples);
    const Mask mask = EdgeMask(stand, plain, place);
    for (std::size_t m = 0; m < methods.size(); ++m) {
      sums[m] += SquaredError(stand.Render(methods[m], place), reference, mask);
    }
    pixels += Share(mask) * static_cast<double>(mask.size());
    share += Share(mask) / std::size(kOrbits_deg);
  }
  std::vector<Figure> figures = {{"edge share", "", share}};
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const double rmse = pixels > 0 ? 255.0 * std::sqrt(sums[m] / (3.0 * pixels)) : 0.0;
    figures.push_back({"rmse", methods[m].name, rmse});
  }
  return figures;
}

}  // namespace burin::bench

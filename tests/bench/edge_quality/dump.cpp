// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/edge_quality/dump.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>

namespace burin::bench {
namespace {

/// The transfer function of IEC 61966-2-1, linear to display.
double Display(double c) { return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055; }

}  // namespace

bool WritePpm(const std::string& path, const Picture& picture, const Mask* mask) {
  std::ofstream file(path, std::ios::binary);
  file << fmt::format("P6\n{} {}\n255\n", picture.width, picture.height);
  for (std::size_t i = 0; i < picture.rgb.size(); ++i) {
    const double dim = mask == nullptr || (*mask)[i / 3] != 0 ? 1.0 : 0.3;
    file.put(static_cast<char>(std::lround(255.0 * dim * Display(picture.rgb[i]))));
  }
  file.close();
  return file.good();
}

}  // namespace burin::bench

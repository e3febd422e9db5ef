// SPDX-License-Identifier: Apache-2.0
// Ramamoorthi and Hanrahan, "An Efficient Representation for Irradiance Environment Maps" (SIGGRAPH 2001): equations 3
// (basis), 10 (projection) and 8 (the cosine lobe's coefficients pi, 2 pi / 3, pi / 4, divided by pi here).
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "core/gbuffer/environment.h"

namespace burin::gbuffer {
namespace {

using Coefficients = std::array<glm::dvec3, 9>;

std::array<double, 9> Basis(double x, double y, double z) {
  return {0.282095,
          0.488603 * y,
          0.488603 * z,
          0.488603 * x,
          1.092548 * x * y,
          1.092548 * y * z,
          0.315392 * (3.0 * z * z - 1.0),
          1.092548 * x * z,
          0.546274 * (x * x - y * y)};
}

void AddRow(const EnvironmentMap& map, int row, Coefficients& sum) {
  constexpr double kPi = glm::pi<double>();
  const double latitude = kPi * (0.5 - (row + 0.5) / map.height);
  // The exact solid angle of one texel of this row.
  const double top = kPi * (0.5 - static_cast<double>(row) / map.height);
  const double bottom = kPi * (0.5 - (row + 1.0) / map.height);
  const double solid_angle = 2.0 * kPi / map.width * (std::sin(top) - std::sin(bottom));
  const double cosine = std::cos(latitude);
  for (int column = 0; column < map.width; ++column) {
    const double longitude = 2.0 * kPi * ((column + 0.5) / map.width - 0.5);
    const std::array<double, 9> basis =
        Basis(cosine * std::sin(longitude), std::sin(latitude), -cosine * std::cos(longitude));
    const glm::dvec3 light = glm::dvec3(map.pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(map.width) +
                                                   static_cast<std::size_t>(column)]) *
                             solid_angle;
    for (std::size_t i = 0; i < 9; ++i) sum[i] += light * basis[i];
  }
}

}  // namespace

std::array<glm::vec3, 9> ProjectIrradiance(const EnvironmentMap& map) {
  const auto add_rows = [&](const tbb::blocked_range<int>& rows, Coefficients sum) {
    for (int row = rows.begin(); row < rows.end(); ++row) AddRow(map, row, sum);
    return sum;
  };
  const auto join = [](Coefficients a, const Coefficients& b) {
    for (std::size_t i = 0; i < 9; ++i) a[i] += b[i];
    return a;
  };
  // Deterministic: the same map gives the same bits, whatever the threads do.
  const Coefficients sum =
      tbb::parallel_deterministic_reduce(tbb::blocked_range<int>(0, map.height, 16), Coefficients{}, add_rows, join);
  std::array<glm::vec3, 9> result;
  for (std::size_t i = 0; i < 9; ++i) {
    const double lobe = i == 0 ? 1.0 : i < 4 ? 2.0 / 3.0 : 0.25;
    result[i] = glm::vec3(sum[i] * lobe);
  }
  return result;
}

}  // namespace burin::gbuffer

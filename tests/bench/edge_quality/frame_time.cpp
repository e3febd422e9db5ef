// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>

#include "tests/bench/edge_quality/measures.h"

namespace burin::bench {
namespace {

double Median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace

std::vector<Figure> FrameTimes(Stand& stand, const std::vector<Method>& methods, int rounds) {
  auto target = gl::Texture::Create(gl::PlainFormat(gl::Numeric::kUnorm, 8, 4), stand.size(), stand.size(), 1, "timed");
  if (!target) {
    fmt::print(stderr, "edge_quality: {}\n", target.error().message);
    std::exit(1);
  }
  std::vector<std::vector<double>> times_ms(methods.size());
  std::vector<std::vector<double>> ratios(methods.size());
  for (int round = -1; round < rounds; ++round) {
    for (std::size_t m = 0; m < methods.size(); ++m) {
      if (!methods[m].timed) continue;
      const Place place{.orbit_deg = 1.0 * round};
      const auto start = std::chrono::steady_clock::now();
      stand.Draw(methods[m], place, *target);
      const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
      if (round < 0) continue;
      times_ms[m].push_back(taken.count());
      ratios[m].push_back(taken.count() / times_ms[0].back());
    }
  }
  std::vector<Figure> figures;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    if (times_ms[m].empty()) continue;
    figures.push_back({"frame ms", methods[m].name, Median(times_ms[m])});
    figures.push_back({"frame ratio", methods[m].name, Median(ratios[m])});
  }
  return figures;
}

}  // namespace burin::bench

// SPDX-License-Identifier: Apache-2.0
#include "core/video/frame_rate.h"

#include <cmath>

namespace burin::video {
namespace {

constexpr double kContainerRounding = 1e-5;
constexpr double kExact = 1e-7;
constexpr double kFastest = 1e5;
constexpr long kLargestTerm = 1000000;

bool Near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance * b; }

// The convergents of the continued fraction, up to the first that is near enough.
FrameRate SimplestRatio(double rate) {
  long p0 = 1, q0 = 0;
  long p1 = static_cast<long>(std::floor(rate)), q1 = 1;
  double rest = rate - std::floor(rate);
  while (!Near(static_cast<double>(p1) / static_cast<double>(q1), rate, kExact) && rest > 1e-9) {
    const double inverse = 1.0 / rest;
    const long term = static_cast<long>(std::floor(inverse));
    const long p2 = term * p1 + p0, q2 = term * q1 + q0;
    if (p2 > kLargestTerm * 1000 || q2 > kLargestTerm) break;
    p0 = p1, q0 = q1, p1 = p2, q1 = q2;
    rest = inverse - std::floor(inverse);
  }
  return p1 > 0 ? FrameRate{static_cast<int>(p1), static_cast<int>(q1)} : FrameRate{1, kLargestTerm};
}

}  // namespace

FrameRate RateFromDouble(double rate) {
  if (!std::isfinite(rate) || rate <= 0.0 || rate > kFastest) return {24, 1};
  if (const double whole = std::round(rate); whole >= 1.0 && Near(whole, rate, kContainerRounding)) {
    return {static_cast<int>(whole), 1};
  }
  if (const double ntsc = std::round(rate * 1.001); ntsc >= 1.0 && Near(ntsc / 1.001, rate, kContainerRounding)) {
    return {static_cast<int>(ntsc) * 1000, 1001};
  }
  return SimplestRatio(rate);
}

}  // namespace burin::video

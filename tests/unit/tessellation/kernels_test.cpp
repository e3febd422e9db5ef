// SPDX-License-Identifier: Apache-2.0
#include "core/tessellation/kernels.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <random>
#include <vector>

#include "core/base/cpu.h"

namespace burin::tessellation {
namespace {

constexpr std::uint32_t kSeed = 515;

std::vector<const Kernels*> AllKernels() {
  std::vector<const Kernels*> kernels{&PlainKernels()};
  if (base::HasAvx2()) kernels.push_back(&Avx2Kernels());
  return kernels;
}

constexpr std::size_t kMostPoints = 8, kMostVertices = 256;
using Points = std::array<Lanes, kMostPoints>;
using Vertices = std::array<Lanes, kMostVertices>;

/// All vertices of one curve with `inner` steps from each end.
void RunCurve(const Kernels& kernels, const Points& points, int degree, double step, std::uint32_t inner,
              Vertices& out) {
  SteppedCurve curve;
  kernels.start_curves(points.data(), 1, 0, 1, degree, step, CurveParts::kAll, &curve);
  kernels.run_curve(curve, degree, {inner, inner, true, true, true}, out.data());
}

bool AreSameBits(const Lanes& a, const Lanes& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

// Rounding to float hides most of what differs in double, so this is told here and not by surfaces.
TEST(Kernels, StepACurveTheSameWayFromBothOfItsEnds) {
  std::mt19937 random(kSeed);
  // Sums of a few floats are exact in double: full mantissas are what tells orders of summation apart.
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  Points points{}, reversed{};
  Vertices plain, forwards, backwards;
  for (int n = 0; n < 2'000; ++n) {
    const int degree = 1 + n % 7;
    for (int k = 0; k <= degree; ++k) {
      Lanes& point = points[static_cast<std::size_t>(k)];
      for (int c = 0; c < 4; ++c) point[c] = coordinate(random);
      reversed[static_cast<std::size_t>(degree - k)] = point;
    }
    const double step = 1.0 / (2.0 + static_cast<double>(n % 97) * 0.37);
    const auto inner = static_cast<std::uint32_t>(0.5 / step);
    const std::size_t count = 2 * inner + 3;
    RunCurve(PlainKernels(), points, degree, step, inner, plain);
    for (const Kernels* kernels : AllKernels()) {
      RunCurve(*kernels, points, degree, step, inner, forwards);
      RunCurve(*kernels, reversed, degree, step, inner, backwards);
      for (std::size_t i = 0; i < count; ++i)
        ASSERT_TRUE(AreSameBits(forwards[i], backwards[count - 1 - i])) << "seed " << kSeed << " case " << n;
      ASSERT_EQ(std::memcmp(plain.data(), forwards.data(), count * sizeof(Lanes)), 0);
    }
  }
}

TEST(Kernels, TellShortNormals) {
  for (const Kernels* kernels : AllKernels()) {
    for (std::uint32_t count = 1; count < 12; ++count) {
      std::array<Lanes, 12> values;
      values.fill(Lanes{0.0, 3.0, -4.0, 0.0});
      std::vector<float> out(3 * count + 1, 7.0f);
      EXPECT_FALSE(kernels->store_units(values.data(), count, out.data()));
      for (std::uint32_t i = 0; i < count; ++i) {
        EXPECT_FLOAT_EQ(out[3 * i + 1], 0.6f);
        EXPECT_FLOAT_EQ(out[3 * i + 2], -0.8f);
      }
      EXPECT_EQ(out.back(), 7.0f) << "one float too many";
      for (std::uint32_t i = 0; i < count; ++i) {
        values[i] = Lanes{0.9e-6, 0.0, 0.0, 0.0};
        EXPECT_TRUE(kernels->store_units(values.data(), count, out.data()));
        EXPECT_TRUE(IsShortNormal(values[i]));
        values[i] = Lanes{1.1e-6, 0.0, 0.0, 0.0};
        EXPECT_FALSE(kernels->store_units(values.data(), count, out.data()));
        EXPECT_FALSE(IsShortNormal(values[i]));
      }
    }
  }
}

}  // namespace
}  // namespace burin::tessellation

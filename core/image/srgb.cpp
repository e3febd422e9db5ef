// SPDX-License-Identifier: Apache-2.0
// The powers x^(1/2.4) and x^2.4 are computed as exp2(p * log2(x)) with polynomials in plain arithmetic and integer
// bit operations, so that the compiler vectorises the loops. log2: x = 2^e * m with m in [sqrt(1/2), sqrt(2)), then
// the series of 2*atanh(s)/ln 2 with s = (m-1)/(m+1). exp2: Taylor series of e^(f ln 2) for f in [-1/2, 1/2].
#include "core/image/srgb.h"

#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/base/target_clones.h"
#include "core/image/image_module.h"

namespace burin::image {
namespace {

constexpr float kLinearBreak = 0.0031308F;
constexpr float kEncodedBreak = 0.04045F;
constexpr float kSlope = 12.92F;
constexpr float kScale = 1.055F;
constexpr float kOffset = kScale - 1.0F;  // 0.055, rounded so that 1 stays 1
constexpr float kGamma = 2.4F;

// x^power for normal x in [2^-9, FLT_MAX]; anything else gives some value, never a fault. p * log2(x) is carried as
// an integer part and a small rest, which keeps the error of the product at the size of one rounding.
[[gnu::always_inline]] inline float Power(float x, float power) {
  constexpr std::int32_t kSqrtHalf = 0x3F3504F3;  // bits of sqrt(1/2)
  const std::int32_t bits = std::bit_cast<std::int32_t>(x);
  const std::int32_t exponent = (bits - kSqrtHalf) >> 23;
  const float m = std::bit_cast<float>(bits - exponent * (1 << 23));
  const float s = (m - 1.0F) / (m + 1.0F);
  const float s2 = s * s;
  // 2/ln2 * (1 + s^2/3 + s^4/5 + s^6/7 + s^8/9): the next term is below 1e-9 of the sum, as |s| <= 0.1716.
  const float log2_m =
      s * (2.885390082F + s2 * (0.961796694F + s2 * (0.577078016F + s2 * (0.412198583F + s2 * 0.320598898F))));
  const float e = static_cast<float>(exponent);
  const float whole = power * e;
  // Adding and taking away 1.5 * 2^23 rounds to the nearest integer without a call.
  constexpr float kRound = 12582912.0F;
  const float k = (whole + power * log2_m + kRound) - kRound;
  const float f = (whole - k) + power * log2_m;
  const float y = f * 0.693147181F;
  const float exp_f =
      1.0F +
      y * (1.0F + y * (0.5F + y * (1.66666667e-1F + y * (4.16666667e-2F + y * (8.33333333e-3F + y * 1.38888889e-3F)))));
  const std::int32_t scale = (static_cast<std::int32_t>(k) + 127) * (1 << 23);
  return exp_f * std::bit_cast<float>(scale);
}

// Both branches are computed and one is chosen: a select, no jump. The range given to Power keeps the exponent
// arithmetic away from overflow for negative, huge, infinite and NaN input, which the selects then pass through.
[[gnu::always_inline]] inline float FastSrgbFromLinear(float v) {
  const float in_range = v > kLinearBreak ? (v < 3.0e38F ? v : 1.0F) : 1.0F;
  const float curve = kScale * Power(in_range, 1.0F / kGamma) - kOffset;
  const float finite = v > kLinearBreak ? curve : v * kSlope;
  return v < 3.0e38F ? finite : v;
}

// 2.4 times the exponent of 4e15 is below 128, so that the result is finite; beyond that it is infinite.
[[gnu::always_inline]] inline float FastLinearFromSrgb(float v) {
  constexpr float kLargest = 4.0e15F;
  const float in_range = v > kEncodedBreak ? (v < kLargest ? v : 1.0F) : 1.0F;
  const float curve = Power((in_range + kOffset) * (1.0F / kScale), kGamma);
  const float finite = v > kEncodedBreak ? curve : v * (1.0F / kSlope);
  const float large = v >= kLargest ? std::numeric_limits<float>::infinity() : v;  // NaN stays NaN
  return v < kLargest ? finite : large;
}

class Srgb final : public ColorTransform {
 public:
  void SceneToDisplay(std::span<float> rgba) const override { SrgbFromLinearRgba(rgba); }
  void DisplayToScene(std::span<float> rgba) const override { LinearFromSrgbRgba(rgba); }
  [[nodiscard]] bool is_srgb() const override { return true; }
};

}  // namespace

float SrgbFromLinear(float linear) {
  if (!(linear > kLinearBreak)) return linear * kSlope;
  return static_cast<float>(1.055 * std::pow(static_cast<double>(linear), 1.0 / 2.4) - 0.055);
}

float LinearFromSrgb(float encoded) {
  if (!(encoded > kEncodedBreak)) return static_cast<float>(static_cast<double>(encoded) / 12.92);
  return static_cast<float>(std::pow((static_cast<double>(encoded) + 0.055) / 1.055, 2.4));
}

const std::array<float, 256>& LinearFromSrgb8Table() {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> values{};
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = LinearFromSrgb(static_cast<float>(i) / 255.0F);
    return values;
  }();
  return table;
}

// All four lanes are computed and alpha's is put back by a select, which costs less than leaving lanes out.
BURIN_TARGET_CLONES void SrgbFromLinearRgba(std::span<float> rgba) {
  float* const v = rgba.data();
  const std::size_t count = rgba.size() & ~std::size_t{3};
  for (std::size_t i = 0; i < count; ++i) {
    const float encoded = FastSrgbFromLinear(v[i]);
    v[i] = (i & 3U) == 3U ? v[i] : encoded;
  }
}

BURIN_TARGET_CLONES void LinearFromSrgbRgba(std::span<float> rgba) {
  float* const v = rgba.data();
  const std::size_t count = rgba.size() & ~std::size_t{3};
  for (std::size_t i = 0; i < count; ++i) {
    const float linear = FastLinearFromSrgb(v[i]);
    v[i] = (i & 3U) == 3U ? v[i] : linear;
  }
}

std::shared_ptr<const ColorTransform> SrgbTransform() {
  static const std::shared_ptr<const ColorTransform> transform = std::make_shared<const Srgb>();
  return transform;
}

}  // namespace burin::image

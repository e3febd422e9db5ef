// SPDX-License-Identifier: Apache-2.0
// ITU-R BT.601-7, sections 2.5.1 to 2.5.4: Kr = 0.299, Kb = 0.114, Y' = 16 + 219 E'y, C = 128 + 224 E'c. Full range is
// JFIF's (ITU-T T.871): Y' = 255 E'y, C = 128 + 255 E'c. In 32-bit integers with 16 fraction bits, rounded to nearest.
#include "core/video/ycbcr.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <vector>

#include "core/base/target_clones.h"

namespace burin::video {
namespace {

using U8 = std::uint8_t;
using U32 = std::uint32_t;

static_assert(std::endian::native == std::endian::little, "pixels are packed as little-endian words");

constexpr double kKr = 0.299;
constexpr double kKb = 0.114;
constexpr double kKg = 1.0 - kKr - kKb;
constexpr int kFraction = 16;
constexpr int kHalf = 1 << (kFraction - 1);

constexpr int Fixed(double value) { return static_cast<int>(value * (1 << kFraction) + (value < 0 ? -0.5 : 0.5)); }

struct ToRgb {
  int y_offset;
  int y;
  int cr_r, cb_g, cr_g, cb_b;
};

constexpr ToRgb MakeToRgb(int y_offset, double y_range, double c_range) {
  const double y = 255.0 / y_range;
  const double c = 255.0 / c_range;
  return {y_offset,
          Fixed(y),
          Fixed(c * 2.0 * (1.0 - kKr)),
          Fixed(-c * 2.0 * (1.0 - kKb) * kKb / kKg),
          Fixed(-c * 2.0 * (1.0 - kKr) * kKr / kKg),
          Fixed(c * 2.0 * (1.0 - kKb))};
}
constexpr ToRgb kLimitedToRgb = MakeToRgb(16, 219.0, 224.0);
constexpr ToRgb kFullToRgb = MakeToRgb(0, 255.0, 255.0);

[[gnu::always_inline]] inline U32 Clamp255(int v) { return static_cast<U32>(std::clamp(v, 0, 255)); }

// One row, chroma already at luma's width.
BURIN_TARGET_CLONES void RgbaRow(const ToRgb& m, const U8* __restrict y, const U8* __restrict cb,
                                 const U8* __restrict cr, U32* __restrict rgba, int width) {
  const ToRgb k = m;
  for (int x = 0; x < width; ++x) {
    const int luma = (y[x] - k.y_offset) * k.y + kHalf;
    const int b = cb[x] - 128;
    const int r = cr[x] - 128;
    const U32 red = Clamp255((luma + k.cr_r * r) >> kFraction);
    const U32 green = Clamp255((luma + k.cb_g * b + k.cr_g * r) >> kFraction);
    const U32 blue = Clamp255((luma + k.cb_b * b) >> kFraction);
    rgba[x] = red | (green << 8) | (blue << 16) | 0xFF000000U;
  }
}

BURIN_TARGET_CLONES void WidenByTwo(const U8* __restrict from, U8* __restrict to, int pairs) {
  for (int i = 0; i < pairs; ++i) {
    to[2 * i] = from[i];
    to[2 * i + 1] = from[i];
  }
}

// A chroma row at luma's width: `from` itself, or `storage` filled by replication.
const U8* Widen(const YcbcrLayout& layout, const U8* from, std::vector<U8>& storage) {
  if (layout.chroma_shift_x == 0) return from;
  if (layout.chroma_shift_x == 1) {
    WidenByTwo(from, storage.data(), layout.chroma_width());
  } else {
    for (int x = 0; x < layout.width; ++x) storage[static_cast<std::size_t>(x)] = from[x >> layout.chroma_shift_x];
  }
  return storage.data();
}

int ChromaRow(const YcbcrLayout& layout, bool interlaced, int row) {
  if (!interlaced || layout.chroma_shift_y == 0) return row >> layout.chroma_shift_y;
  const int in_field = (row >> 1) >> layout.chroma_shift_y;
  return std::min(in_field * 2 + (row & 1), layout.chroma_height() - 1);
}

constexpr int kYr = Fixed(kKr * 219.0 / 255.0);
constexpr int kYb = Fixed(kKb * 219.0 / 255.0);
constexpr int kYg = Fixed(219.0 / 255.0) - kYr - kYb;  // so that white is 235 exactly
constexpr double kCbScale = 224.0 / 255.0 / (2.0 * (1.0 - kKb));
constexpr double kCrScale = 224.0 / 255.0 / (2.0 * (1.0 - kKr));
constexpr int kCbr = Fixed(-kKr * kCbScale);
constexpr int kCbb = Fixed((1.0 - kKb) * kCbScale);
constexpr int kCbg = -kCbr - kCbb;  // so that greys are 128 exactly
constexpr int kCrr = Fixed((1.0 - kKr) * kCrScale);
constexpr int kCrb = Fixed(-kKb * kCrScale);
constexpr int kCrg = -kCrr - kCrb;

BURIN_TARGET_CLONES void LumaRow(const U32* __restrict rgba, U8* __restrict y, int width) {
  for (int x = 0; x < width; ++x) {
    const U32 p = rgba[x];
    const int r = static_cast<int>(p & 0xFFU);
    const int g = static_cast<int>((p >> 8) & 0xFFU);
    const int b = static_cast<int>((p >> 16) & 0xFFU);
    y[x] = static_cast<U8>((kYr * r + kYg * g + kYb * b + (16 << kFraction) + kHalf) >> kFraction);
  }
}

// Chroma from sums of 2^shift pixels each.
template <int kShift>
[[gnu::always_inline]] inline void StoreChroma(int r, int g, int b, U8& cb, U8& cr) {
  constexpr int kBias = (128 << (kFraction + kShift)) + (1 << (kFraction + kShift - 1));
  cb = static_cast<U8>((kCbr * r + kCbg * g + kCbb * b + kBias) >> (kFraction + kShift));
  cr = static_cast<U8>((kCrr * r + kCrg * g + kCrb * b + kBias) >> (kFraction + kShift));
}

BURIN_TARGET_CLONES void ChromaRow444(const U32* __restrict rgba, U8* __restrict cb, U8* __restrict cr, int width) {
  for (int x = 0; x < width; ++x) {
    const U32 p = rgba[x];
    StoreChroma<0>(static_cast<int>(p & 0xFFU), static_cast<int>((p >> 8) & 0xFFU), static_cast<int>((p >> 16) & 0xFFU),
                   cb[x], cr[x]);
  }
}

// Each chroma sample from two columns of two rows (the same row twice for 4:2:2). Red and blue are summed side by side
// in one word: four bytes need ten bits each.
BURIN_TARGET_CLONES void ChromaRowHalved(const U32* __restrict above, const U32* __restrict below, U8* __restrict cb,
                                         U8* __restrict cr, int pairs) {
  constexpr U32 kRedBlue = 0x00FF00FFU;
  for (int i = 0; i < pairs; ++i) {
    const U32 a = above[2 * i];
    const U32 b = above[2 * i + 1];
    const U32 c = below[2 * i];
    const U32 d = below[2 * i + 1];
    const U32 red_blue = (a & kRedBlue) + (b & kRedBlue) + (c & kRedBlue) + (d & kRedBlue);
    const U32 green = ((a >> 8) & 0xFFU) + ((b >> 8) & 0xFFU) + ((c >> 8) & 0xFFU) + ((d >> 8) & 0xFFU);
    StoreChroma<2>(static_cast<int>(red_blue & 0xFFFFU), static_cast<int>(green), static_cast<int>(red_blue >> 16),
                   cb[i], cr[i]);
  }
}

void HalvedChroma(const U32* above, const U32* below, U8* cb, U8* cr, int width) {
  const int pairs = width / 2;
  ChromaRowHalved(above, below, cb, cr, pairs);
  if (width % 2 == 0) return;
  const U32 last_above[2] = {above[width - 1], above[width - 1]};
  const U32 last_below[2] = {below[width - 1], below[width - 1]};
  ChromaRowHalved(last_above, last_below, cb + pairs, cr + pairs, 1);
}

}  // namespace

void RgbaFromYcbcr(const YcbcrLayout& layout, bool interlaced_chroma, std::span<const std::uint8_t> planes,
                   std::span<std::uint8_t> rgba) {
  assert(planes.size() >= layout.frame_bytes() && rgba.size() >= layout.luma_bytes() * 4);
  const ToRgb& matrix = layout.full_range ? kFullToRgb : kLimitedToRgb;
  // Replication by pairs may write one sample past an odd width.
  std::vector<U8> cb_row(static_cast<std::size_t>(layout.width) + 2, 128);
  std::vector<U8> cr_row(static_cast<std::size_t>(layout.width) + 2, 128);
  const U8* cb = planes.data() + layout.luma_bytes();
  const U8* cr = cb + layout.chroma_bytes();
  U32* out = reinterpret_cast<U32*>(rgba.data());
  const U8* wide_cb = cb_row.data();
  const U8* wide_cr = cr_row.data();
  int widened = -1;
  for (int row = 0; row < layout.height; ++row) {
    const int chroma_row = ChromaRow(layout, interlaced_chroma, row);
    if (layout.has_chroma && chroma_row != widened) {
      const std::size_t at = static_cast<std::size_t>(chroma_row) * static_cast<std::size_t>(layout.chroma_width());
      wide_cb = Widen(layout, cb + at, cb_row);
      wide_cr = Widen(layout, cr + at, cr_row);
      widened = chroma_row;
    }
    const std::size_t at = static_cast<std::size_t>(row) * static_cast<std::size_t>(layout.width);
    RgbaRow(matrix, planes.data() + at, wide_cb, wide_cr, out + at, layout.width);
  }
}

void YcbcrFromRgba(const YcbcrLayout& layout, std::span<const std::uint8_t> rgba, std::span<std::uint8_t> planes) {
  assert(layout.has_chroma && !layout.full_range && layout.chroma_shift_x <= 1 && layout.chroma_shift_y <= 1);
  assert(planes.size() >= layout.frame_bytes() && rgba.size() >= layout.luma_bytes() * 4);
  const U32* in = reinterpret_cast<const U32*>(rgba.data());
  const std::size_t width = static_cast<std::size_t>(layout.width);
  U8* luma = planes.data();
  U8* cb = luma + layout.luma_bytes();
  U8* cr = cb + layout.chroma_bytes();
  const int step = 1 << layout.chroma_shift_y;
  for (int row = 0; row < layout.height; row += step) {
    const U32* above = in + static_cast<std::size_t>(row) * width;
    const U32* below = row + step - 1 < layout.height ? above + static_cast<std::size_t>(step - 1) * width : above;
    LumaRow(above, luma + static_cast<std::size_t>(row) * width, layout.width);
    if (below != above) LumaRow(below, luma + static_cast<std::size_t>(row + 1) * width, layout.width);
    if (layout.chroma_shift_x == 0) {
      ChromaRow444(above, cb, cr, layout.width);
    } else {
      HalvedChroma(above, below, cb, cr, layout.width);
    }
    cb += layout.chroma_width();
    cr += layout.chroma_width();
  }
}

}  // namespace burin::video

// SPDX-License-Identifier: Apache-2.0
#pragma once
// 8-bit planar Y'CbCr to and from 8-bit R'G'B'. The matrix is always that of ITU-R BT.601: YUV4MPEG2 has no field for
// it, and ffmpeg's scaler takes BT.601 for whatever has no tag, so a stream from ffmpeg through burin and back keeps
// its colours whatever its own matrix was. Chroma is replicated on the way in and box-averaged on the way out, which
// are exact inverses of each other.

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/image/image.h"

namespace burin::video {

struct YcbcrLayout {
  int width = 0;
  int height = 0;
  int chroma_shift_x = 0;  ///< log2 of the luma columns to a chroma column: 0, 1 or 2
  int chroma_shift_y = 0;
  bool has_chroma = true;   ///< false: only Y
  bool has_alpha = false;   ///< a plane of luma's size after the others, not looked at
  bool full_range = false;  ///< Y and chroma in 0..255; else Y in 16..235 and chroma in 16..240

  [[nodiscard]] int chroma_width() const { return (width + (1 << chroma_shift_x) - 1) >> chroma_shift_x; }
  [[nodiscard]] int chroma_height() const { return (height + (1 << chroma_shift_y) - 1) >> chroma_shift_y; }
  [[nodiscard]] std::size_t luma_bytes() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  [[nodiscard]] std::size_t chroma_bytes() const {
    return has_chroma ? static_cast<std::size_t>(chroma_width()) * static_cast<std::size_t>(chroma_height()) : 0;
  }
  [[nodiscard]] std::size_t frame_bytes() const { return luma_bytes() * (has_alpha ? 2 : 1) + 2 * chroma_bytes(); }
};

/// Planes Y, Cb, Cr (frame_bytes() of them) into `rgba`, width * height * 4 bytes, alpha 255. `interlaced_chroma`: the
/// vertically halved chroma rows belong to the two fields in turn.
void RgbaFromYcbcr(const YcbcrLayout& layout, bool interlaced_chroma, std::span<const std::uint8_t> planes,
                   std::span<std::uint8_t> rgba);

/// `rgba` into planes of limited range; chroma shifts 0 or 1, chroma present, no alpha plane.
void YcbcrFromRgba(const YcbcrLayout& layout, std::span<const std::uint8_t> rgba, std::span<std::uint8_t> planes);

}  // namespace burin::video

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace burin::test {

/// What goes into an uncompressed 8- or 32-bit TIFF of one strip; by TIFF 6.0, little-endian.
struct TinyTiff {
  std::uint32_t width = 1;
  std::uint32_t height = 1;
  std::uint32_t photometric = 2;  ///< 1 grey, 2 RGB, 5 CMYK, 8 CIELab
  std::uint32_t channels = 3;
  std::uint32_t bits = 8;
  std::uint32_t sample_format = 1;  ///< 1 unsigned, 2 signed, 3 float
  std::uint32_t orientation = 1;
  int extra_samples = -1;  ///< of the fourth channel: 1 associated alpha, 2 unassociated
  bool date = false;
};

inline std::vector<std::byte> MakeTiff(const TinyTiff& tiff, std::span<const std::byte> pixels) {
  struct Entry {
    std::uint16_t tag, type;
    std::uint32_t count, value;
  };
  constexpr std::uint16_t kAscii = 2, kShort = 3, kLong = 4;
  constexpr std::uint32_t kPixelsAt = 8;
  const std::uint32_t bits_at = kPixelsAt + static_cast<std::uint32_t>(pixels.size());
  const std::uint32_t date_at = bits_at + 2 * tiff.channels;
  const std::uint32_t directory_at = date_at + 20;
  std::vector<Entry> entries{{256, kLong, 1, tiff.width},
                             {257, kLong, 1, tiff.height},
                             {258, kShort, tiff.channels, tiff.channels > 2 ? bits_at : tiff.bits | tiff.bits << 16},
                             {259, kShort, 1, 1},
                             {262, kShort, 1, tiff.photometric},
                             {273, kLong, 1, kPixelsAt},
                             {274, kShort, 1, tiff.orientation},
                             {277, kShort, 1, tiff.channels},
                             {278, kLong, 1, tiff.height},
                             {279, kLong, 1, static_cast<std::uint32_t>(pixels.size())},
                             {339, kShort, 1, tiff.sample_format}};
  if (tiff.extra_samples >= 0) entries.push_back({338, kShort, 1, static_cast<std::uint32_t>(tiff.extra_samples)});
  if (tiff.date) entries.push_back({306, kAscii, 20, date_at});
  std::ranges::sort(entries, {}, &Entry::tag);

  std::vector<std::byte> file;
  const auto put = [&file](std::uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) file.push_back(static_cast<std::byte>(value >> (8 * i)));
  };
  put(0x002A4949, 4);  // "II", 42
  put(directory_at, 4);
  file.insert(file.end(), pixels.begin(), pixels.end());
  for (std::uint32_t i = 0; i < tiff.channels; ++i) put(tiff.bits, 2);
  for (const char c : std::array<char, 20>{"2026:01:02 03:04:05"}) file.push_back(static_cast<std::byte>(c));
  put(static_cast<std::uint32_t>(entries.size()), 2);
  for (const Entry& entry : entries) {
    put(entry.tag, 2);
    put(entry.type, 2);
    put(entry.count, 4);
    put(entry.value, 4);
  }
  put(0, 4);
  return file;
}

}  // namespace burin::test

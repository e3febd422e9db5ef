// SPDX-License-Identifier: Apache-2.0
// TIFF 6.0, section 2 (image file directory: a count, 12-byte entries sorted by tag, the next directory's offset), and
// BigTIFF, which widens count, entries and offsets to 8, 20 and 8 bytes.
#include "core/image/tiff_date.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace burin::image {
namespace {

constexpr std::uint16_t kDateTime = 306;
constexpr std::size_t kDateBytes = 20;   // "YYYY:MM:DD HH:MM:SS" and the NUL, always outside the entry

struct Layout {
  std::size_t first_offset_at;
  std::size_t word;    ///< bytes of a directory's entry count
  std::size_t entry;
  std::size_t offset;
};
constexpr Layout kClassic{4, 2, 12, 4};
constexpr Layout kBig{8, 8, 20, 8};

// Little-endian number of `bytes` bytes; 0 when it would lie outside.
std::uint64_t Number(std::span<const std::byte> file, std::uint64_t at, std::size_t bytes) {
  if (at > file.size() || file.size() - at < bytes) return 0;
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes; ++i) value |= std::to_integer<std::uint64_t>(file[at + i]) << (8 * i);
  return value;
}

}  // namespace

void RemoveTiffDate(std::span<std::byte> file) {
  if (file.size() < 8 || std::to_integer<char>(file[0]) != 'I' || std::to_integer<char>(file[1]) != 'I') return;
  const std::uint64_t magic = Number(file, 2, 2);
  if (magic != 42 && magic != 43) return;
  const Layout& layout = magic == 42 ? kClassic : kBig;

  const std::uint64_t directory = Number(file, layout.first_offset_at, layout.offset);
  const std::uint64_t count = Number(file, directory, layout.word);
  if (directory > file.size() || count > file.size() / layout.entry) return;
  const std::uint64_t entries = directory + layout.word;
  const std::uint64_t end = entries + count * layout.entry + layout.offset;
  if (end > file.size()) return;

  for (std::uint64_t i = 0; i < count; ++i) {
    const std::uint64_t at = entries + i * layout.entry;
    if (Number(file, at, 2) != kDateTime) continue;
    const std::uint64_t text = Number(file, at + layout.entry - layout.offset, layout.offset);
    if (text <= file.size() && file.size() - text >= kDateBytes) {
      std::fill_n(file.begin() + static_cast<std::ptrdiff_t>(text), kDateBytes, std::byte{0});
    }
    std::memmove(&file[at], &file[at + layout.entry], end - at - layout.entry);
    std::fill_n(file.begin() + static_cast<std::ptrdiff_t>(end - layout.entry), layout.entry, std::byte{0});
    for (std::size_t b = 0; b < layout.word; ++b) file[directory + b] = static_cast<std::byte>((count - 1) >> (8 * b));
    return;
  }
}

}  // namespace burin::image

// SPDX-License-Identifier: Apache-2.0
// TIFF 6.0, section 2: a header with the byte order and the offset of the first image file directory, which is a count,
// 12-byte entries (tag, type, number of values, the values or their offset) and the next directory's offset. BigTIFF
// widens counts, entries and offsets to 8, 20 and 8 bytes.
#include "core/image/tiff_stream.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <optional>

namespace burin::image {
namespace {

constexpr std::uint16_t kDateTime = 306;
constexpr std::uint16_t kStripOffsets = 273;
constexpr std::uint16_t kStripByteCounts = 279;
constexpr std::uint16_t kTileOffsets = 324;
constexpr std::uint16_t kTileByteCounts = 325;
constexpr std::size_t kDateBytes = 20;  // "YYYY:MM:DD HH:MM:SS" and the NUL, always outside the entry

struct Entry {
  std::uint64_t at = 0;         ///< of the entry itself
  std::size_t value_bytes = 0;  ///< of one value
  std::uint64_t count = 0;
  std::uint64_t values_at = 0;
};

class Directory {
 public:
  /// Empty when `file` is no TIFF; whole() tells whether the directory lies in the file.
  static std::optional<Directory> First(std::span<const std::byte> file) {
    Directory d(file);
    if (file.size() < 8) return std::nullopt;
    const char order = std::to_integer<char>(file[0]);
    if (std::to_integer<char>(file[1]) != order || (order != 'I' && order != 'M')) return std::nullopt;
    d.big_endian_ = order == 'M';
    const std::uint64_t magic = d.Number(2, 2).value_or(0);
    if (magic != 42 && magic != 43) return std::nullopt;
    d.big_ = magic == 43;
    const auto at = d.Number(d.big_ ? 8 : 4, d.offset_bytes());
    const auto count = at ? d.Number(*at, d.count_bytes()) : std::nullopt;
    if (count && *count <= file.size() / d.entry_bytes()) {
      d.at_ = *at;
      d.count_ = *count;
      d.whole_ = d.end() <= file.size();
    }
    return d;
  }

  [[nodiscard]] bool whole() const { return whole_; }
  [[nodiscard]] bool big_endian() const { return big_endian_; }
  [[nodiscard]] std::uint64_t at() const { return at_; }
  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] std::uint64_t end() const { return at_ + count_bytes() + count_ * entry_bytes() + offset_bytes(); }
  [[nodiscard]] std::size_t count_bytes() const { return big_ ? 8 : 2; }
  [[nodiscard]] std::size_t entry_bytes() const { return big_ ? 20 : 12; }
  [[nodiscard]] std::size_t offset_bytes() const { return big_ ? 8 : 4; }

  [[nodiscard]] std::optional<Entry> Find(std::uint16_t tag) const {
    for (std::uint64_t i = 0; i < count_; ++i) {
      const std::uint64_t at = at_ + count_bytes() + i * entry_bytes();
      if (Number(at, 2) != tag) continue;
      Entry entry{at, ValueBytes(Number(at + 2, 2).value_or(0)), Number(at + 4, offset_bytes()).value_or(0), 0};
      const std::uint64_t field = at + 4 + offset_bytes();
      const bool inside = entry.count * entry.value_bytes <= offset_bytes();
      entry.values_at = inside ? field : Number(field, offset_bytes()).value_or(~std::uint64_t{0});
      return entry;
    }
    return std::nullopt;
  }

  [[nodiscard]] std::optional<std::uint64_t> Value(const Entry& entry, std::uint64_t index) const {
    return Number(entry.values_at + index * entry.value_bytes, entry.value_bytes);
  }

 private:
  explicit Directory(std::span<const std::byte> file) : file_(file) {}

  // SHORT, LONG and LONG8 are the types that offsets and counts have.
  static std::size_t ValueBytes(std::uint64_t type) { return type == 3 ? 2 : type == 16 ? 8 : 4; }

  [[nodiscard]] std::optional<std::uint64_t> Number(std::uint64_t at, std::size_t bytes) const {
    if (at > file_.size() || file_.size() - at < bytes) return std::nullopt;
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < bytes; ++i) {
      value |= std::to_integer<std::uint64_t>(file_[at + i]) << (8 * (big_endian_ ? bytes - 1 - i : i));
    }
    return value;
  }

  std::span<const std::byte> file_;
  bool big_endian_ = false;
  bool big_ = false;
  bool whole_ = false;
  std::uint64_t at_ = 0;
  std::uint64_t count_ = 0;
};

bool DataIsInside(const Directory& directory, std::uint64_t file_bytes, std::uint16_t offsets_tag,
                  std::uint16_t counts_tag) {
  const auto offsets = directory.Find(offsets_tag);
  const auto counts = directory.Find(counts_tag);
  if (!offsets || !counts) return true;
  // As many values as claimed can't be in a file smaller than they are.
  if (offsets->count > file_bytes || counts->count > file_bytes) return false;
  for (std::uint64_t i = 0; i < std::min(offsets->count, counts->count); ++i) {
    const auto offset = directory.Value(*offsets, i);
    const auto count = directory.Value(*counts, i);
    if (!offset || !count || *offset > file_bytes || *count > file_bytes - *offset) return false;
  }
  return true;
}

}  // namespace

bool TiffIsWhole(std::span<const std::byte> file) {
  const auto directory = Directory::First(file);
  if (!directory) return true;
  return directory->whole() && DataIsInside(*directory, file.size(), kStripOffsets, kStripByteCounts) &&
         DataIsInside(*directory, file.size(), kTileOffsets, kTileByteCounts);
}

void RemoveTiffDate(std::span<std::byte> file) {
  const auto directory = Directory::First(file);
  if (!directory || !directory->whole()) return;
  const auto date = directory->Find(kDateTime);
  if (!date) return;
  // An ASCII value: its offset stands where Find looks for four-byte values that don't fit.
  if (date->count == kDateBytes && date->values_at <= file.size() && file.size() - date->values_at >= kDateBytes) {
    std::fill_n(file.begin() + static_cast<std::ptrdiff_t>(date->values_at), kDateBytes, std::byte{0});
  }
  const std::uint64_t after = date->at + directory->entry_bytes();
  std::memmove(&file[date->at], file.data() + after, directory->end() - after);
  std::fill_n(file.begin() + static_cast<std::ptrdiff_t>(directory->end() - directory->entry_bytes()),
              directory->entry_bytes(), std::byte{0});
  const std::size_t bytes = directory->count_bytes();
  for (std::size_t i = 0; i < bytes; ++i) {
    const std::size_t shift = 8 * (directory->big_endian() ? bytes - 1 - i : i);
    file[directory->at() + i] = static_cast<std::byte>((directory->count() - 1) >> shift);
  }
}

}  // namespace burin::image

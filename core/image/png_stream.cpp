// SPDX-License-Identifier: Apache-2.0
// PNG (ISO/IEC 15948), section 5: an 8-byte signature, then chunks of length, type, data and a CRC of type and data.
#include "core/image/png_stream.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "core/base/crc32.h"

namespace burin::image {
namespace {

constexpr std::size_t kSignature = 8;
constexpr std::size_t kLengthAndType = 8;
constexpr std::size_t kCrc = 4;
constexpr std::array<std::string_view, 6> kKept{"IHDR", "PLTE", "tRNS", "IDAT", "IEND", "eXIf"};

std::uint32_t BigEndian(std::span<const std::byte> bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | std::to_integer<std::uint32_t>(bytes[i]);
  return value;
}

}  // namespace

std::expected<std::vector<std::byte>, std::string> PngPicture(std::span<const std::byte> file) {
  std::vector<std::byte> picture(file.begin(), file.begin() + std::min(kSignature, file.size()));
  std::span<const std::byte> rest = file.subspan(picture.size());
  for (;;) {
    if (rest.size() < kLengthAndType + kCrc) return std::unexpected("the PNG data ends too early");
    const std::uint32_t length = BigEndian(rest);
    const std::string_view type(reinterpret_cast<const char*>(rest.data()) + 4, 4);
    if (length > rest.size() - kLengthAndType - kCrc) {
      return std::unexpected(fmt::format("the PNG data ends too early, in chunk {}", type));
    }
    const std::span<const std::byte> chunk = rest.first(kLengthAndType + length + kCrc);
    if (std::ranges::find(kKept, type) != kKept.end()) {
      if (base::Crc32(chunk.subspan(4, 4 + length)) != BigEndian(chunk.last(kCrc))) {
        return std::unexpected(fmt::format("PNG chunk {} is damaged: its checksum is wrong", type));
      }
      picture.insert(picture.end(), chunk.begin(), chunk.end());
    }
    if (type == "IEND") return picture;
    rest = rest.subspan(chunk.size());
  }
}

}  // namespace burin::image

// SPDX-License-Identifier: Apache-2.0
// ITU-T T.81, annex B: markers are 0xFF and a code, any number of 0xFF may fill before the code; segments carry their
// length, entropy-coded data runs on to the next marker that is neither a stuffed 0xFF00 nor a restart.
#include "core/image/jpeg_end.h"

#include <cstdint>

namespace burin::image {
namespace {

constexpr unsigned kEnd = 0xD9;
constexpr unsigned kStuffed = 0x00;
constexpr unsigned kTemporary = 0x01;

bool StandsAlone(unsigned code) { return code == kTemporary || (code >= 0xD0 && code <= 0xD8); }

}  // namespace

bool ReachesJpegEnd(std::span<const std::byte> file) {
  std::size_t at = 0;
  const auto byte = [&file](std::size_t i) { return std::to_integer<unsigned>(file[i]); };
  while (at + 1 < file.size()) {
    // Between segments this finds the next marker; after a scan header it skips the entropy-coded data.
    if (byte(at) != 0xFF || byte(at + 1) == 0xFF) {
      ++at;
      continue;
    }
    const unsigned code = byte(at + 1);
    at += 2;
    if (code == kEnd) return true;
    if (code == kStuffed || StandsAlone(code)) continue;
    if (at + 1 >= file.size()) return false;
    at += byte(at) * 256 + byte(at + 1);
  }
  return false;
}

}  // namespace burin::image

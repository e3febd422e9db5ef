// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace burin::base {

/// The CRC-32 of ISO 3309, as in Ethernet, PNG and Matroska. To go on: give the last result as `crc`.
[[nodiscard]] std::uint32_t Crc32(std::span<const std::byte> bytes, std::uint32_t crc = 0);

}  // namespace burin::base

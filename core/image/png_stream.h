// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <expected>
#include <span>
#include <string>
#include <vector>

namespace burin::image {

/// A PNG stream reduced to the chunks that make its picture (IHDR PLTE tRNS IDAT IEND, and eXIf for the orientation),
/// after checking that it is whole and that the checksums are right. libpng speaks to stderr about damage and about odd
/// colour profiles, texts and times; what it gets from here leaves it nothing to say. The error says what is wrong.
[[nodiscard]] std::expected<std::vector<std::byte>, std::string> PngPicture(std::span<const std::byte> file);

}  // namespace burin::image

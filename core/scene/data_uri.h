// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace burin::scene {

[[nodiscard]] bool IsDataUri(std::string_view uri);

/// The bytes of "data:<any type>;base64,<data>" (RFC 2397, RFC 4648 section 4; missing padding is let through).
[[nodiscard]] Result<std::vector<std::byte>> DecodeDataUri(std::string_view uri);

}  // namespace burin::scene

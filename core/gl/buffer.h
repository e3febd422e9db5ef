// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>

#include "core/gl/handle.h"

namespace burin::gl {

/// A buffer without storage yet.
[[nodiscard]] BufferHandle CreateBuffer(std::string_view label);

/// Replaces what it holds, for one frame's use.
void StreamInto(const BufferHandle& buffer, const void* data, std::size_t bytes);

}  // namespace burin::gl

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "core/base/error.h"

namespace burin::scene {

/// Views into the bytes of a .glb file.
struct GlbChunks {
  std::string_view json;
  std::optional<std::span<const std::byte>> bin;
};

[[nodiscard]] bool IsGlb(std::span<const std::byte> file);

/// glTF 2.0 specification, 4.4 "Binary glTF Layout". Unknown chunks are passed over.
[[nodiscard]] Result<GlbChunks> ReadGlbChunks(std::span<const std::byte> file);

}  // namespace burin::scene

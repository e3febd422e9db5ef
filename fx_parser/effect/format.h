// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace burin::fx {

/// The D3DFORMAT names that the extension takes, and B16G16R16 (three components).
enum class Format : std::uint8_t {
  kA8R8G8B8, kX8R8G8B8, kA8, kL8, kL16, kA8L8, kR5G6B5, kA2B10G10R10, kG16R16, kA16B16G16R16, kB16G16R16,
  kR16F, kG16R16F, kA16B16G16R16F, kR32F, kG32R32F, kA32B32G32R32F
};

struct FormatInfo {
  Format format;
  std::string_view name;
  int components;    ///< 1 to 4
  int bits;          ///< of the widest component
  bool is_float;     ///< floats are raw and scene-linear; the others are 0..1 and display-encoded
};

/// Case is ignored.
[[nodiscard]] std::optional<Format> FindFormat(std::string_view name);
[[nodiscard]] const FormatInfo& Info(Format format);
[[nodiscard]] std::span<const FormatInfo> AllFormats();

}  // namespace burin::fx

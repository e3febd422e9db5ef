// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/effect/format.h"

#include "fx_parser/effect/case.h"

namespace burin::fx {
namespace {

// In the order of the enumeration.
constexpr FormatInfo kFormats[] = {
    {Format::kA8R8G8B8, "A8R8G8B8", 4, 8, false},
    {Format::kX8R8G8B8, "X8R8G8B8", 3, 8, false},
    {Format::kA8, "A8", 1, 8, false},
    {Format::kL8, "L8", 1, 8, false},
    {Format::kL16, "L16", 1, 16, false},
    {Format::kA8L8, "A8L8", 2, 8, false},
    {Format::kR5G6B5, "R5G6B5", 3, 6, false},
    {Format::kA2B10G10R10, "A2B10G10R10", 4, 10, false},
    {Format::kG16R16, "G16R16", 2, 16, false},
    {Format::kA16B16G16R16, "A16B16G16R16", 4, 16, false},
    {Format::kB16G16R16, "B16G16R16", 3, 16, false},
    {Format::kR16F, "R16F", 1, 16, true},
    {Format::kG16R16F, "G16R16F", 2, 16, true},
    {Format::kA16B16G16R16F, "A16B16G16R16F", 4, 16, true},
    {Format::kR32F, "R32F", 1, 32, true},
    {Format::kG32R32F, "G32R32F", 2, 32, true},
    {Format::kA32B32G32R32F, "A32B32G32R32F", 4, 32, true},
};

}  // namespace

std::optional<Format> FindFormat(std::string_view name) {
  for (const FormatInfo& info : kFormats) {
    if (EqualsIgnoringCase(info.name, name)) return info.format;
  }
  return std::nullopt;
}

const FormatInfo& Info(Format format) { return kFormats[static_cast<std::size_t>(format)]; }

std::span<const FormatInfo> AllFormats() { return kFormats; }

}  // namespace burin::fx

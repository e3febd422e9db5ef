// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "core/base/error.h"
#include "core/image/image.h"

namespace burin::image {

[[nodiscard]] Result<Image> ReadFile(const std::string& path);
[[nodiscard]] Result<Image> ReadBytes(std::span<const std::byte> bytes, const std::string& name);

}  // namespace burin::image

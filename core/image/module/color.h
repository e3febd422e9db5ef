// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/base/error.h"
#include "core/image/image_module.h"

namespace burin::image {

[[nodiscard]] Result<std::shared_ptr<const ColorTransform>> MakeOcioTransform(const ColorOptions& options);

}  // namespace burin::image

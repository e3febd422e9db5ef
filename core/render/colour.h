// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/image/image.h"
#include "core/image/image_module.h"

namespace burin::render {

/// The same picture in another encoding, on the CPU: 4 channels of any type in, `type` out. kDisplay has unassociated
/// alpha, kSceneLinear associated. kData, or the same encoding, changes the type only. Any thread.
[[nodiscard]] image::Image ConvertEncoding(const image::Image& image, image::Encoding encoding, image::SampleType type,
                                           const image::ColorTransform& transform);

}  // namespace burin::render

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/image/image.h"

namespace burin::gl {

/// The GLenum of a sample type: GL_UNSIGNED_BYTE ...
[[nodiscard]] std::uint32_t TransferType(image::SampleType type);
/// The GLenum of 1 to 4 interleaved channels: GL_RED ... GL_RGBA, GL_RED_INTEGER ... for kU32.
[[nodiscard]] std::uint32_t TransferFormat(image::SampleType type, int channels);

}  // namespace burin::gl

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/video/video_module.h"

namespace burin::video {

/// The ratio that was meant by a rate given as a decimal: whole rates and those of NTSC (n * 1000/1001) when they are
/// within 1e-5 of it, as containers round them; else the simplest ratio within 1e-7. 24/1 for a rate that is none.
[[nodiscard]] FrameRate RateFromDouble(double rate);

}  // namespace burin::video

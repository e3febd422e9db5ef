// SPDX-License-Identifier: Apache-2.0
#pragma once
// Between the program and the video module's shared object only.

#include "core/base/temporaries.h"
#include "core/video/video_module.h"

namespace burin::video {

/// Makes the one VideoModule; the module registers its temporary files in the program's registry.
using VideoModuleFactory = VideoModule* (*)(base::TemporaryRegistry*);
inline constexpr const char* kVideoModuleFactory = "BurinVideoModule";

}  // namespace burin::video

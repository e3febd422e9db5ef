// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "core/base/error.h"
#include "core/video/video_module.h"

namespace burin::video {

[[nodiscard]] Result<std::unique_ptr<VideoReader>> OpenOpencvReader(const std::string& path);

}  // namespace burin::video

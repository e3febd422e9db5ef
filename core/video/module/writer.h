// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "core/base/error.h"
#include "core/video/video_module.h"

namespace burin::video {

[[nodiscard]] Result<std::unique_ptr<VideoWriter>> OpenOpencvWriter(const std::string& path,
                                                                    const VideoWriteOptions& options);

}  // namespace burin::video

// SPDX-License-Identifier: Apache-2.0
#pragma once
// YUV4MPEG2 streams (mjpegtools' yuv4mpeg(5)) on file descriptors: C420*, C422, C444, Cmono, 8 bit.

#include <memory>

#include "core/base/error.h"
#include "core/video/video_module.h"

namespace burin::video {

/// Reads the stream header at once; `name` is for messages. The descriptor is not closed.
[[nodiscard]] Result<std::unique_ptr<VideoReader>> OpenY4mReader(int descriptor, const std::string& name);

/// Writes the stream header at once. A closed pipe (EPIPE) is a kFailed error. The descriptor is not closed.
[[nodiscard]] Result<std::unique_ptr<VideoWriter>> OpenY4mWriter(int descriptor, const std::string& name,
                                                                 const VideoWriteOptions&);

}  // namespace burin::video

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace burin::video {

/// Takes the log of the ffmpeg libraries that OpenCV drives away from stderr and keeps its last error. Any thread.
void CaptureFfmpegLog();

/// The last error line that ffmpeg logged since the last call, "" when there was none.
[[nodiscard]] std::string TakeFfmpegError();

}  // namespace burin::video

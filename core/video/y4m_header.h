// SPDX-License-Identifier: Apache-2.0
#pragma once
// The text of YUV4MPEG2 streams: the stream header and the frame headers, as yuv4mpeg(5) of mjpegtools lays them down.

#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/video/video_module.h"
#include "core/video/ycbcr.h"

namespace burin::video {

/// Longest header line that is read, far above what any writer makes.
inline constexpr std::size_t kLongestY4mHeader = 4096;

struct Y4mHeader {
  VideoInfo info;
  YcbcrLayout layout;
  bool interlaced = false;  ///< both fields in one frame, and so in the chroma planes
};

/// `line`: the first line without its newline. `name` is for messages, which are kInput.
[[nodiscard]] Result<Y4mHeader> ParseY4mHeader(std::string_view line, const std::string& name);

/// Whether a frame of a stream of mixed interlacing has interlaced chroma; `fallback` when its line doesn't say.
[[nodiscard]] bool FrameIsInterlaced(std::string_view frame_line, bool fallback);

/// The header line that burin writes, with its newline.
[[nodiscard]] std::string FormatY4mHeader(const VideoWriteOptions& options);

/// The planes of a chroma subsampling.
[[nodiscard]] YcbcrLayout LayoutOf(int width, int height, Chroma chroma);

}  // namespace burin::video

// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <string_view>

#include "core/base/path.h"
#include "core/video/video_module.h"

namespace burin::video {

bool IsVideoPath(const std::string& path) {
  constexpr std::array<std::string_view, 18> kExtensions{"mkv", "mp4",  "mov", "avi", "webm", "m4v",
                                                         "mpg", "mpeg", "ogv", "wmv", "flv",  "m2ts",
                                                         "mts", "mxf",  "3gp", "asf", "vob",  "m2v"};
  return std::ranges::find(kExtensions, std::string_view(base::LowerExtension(path))) != kExtensions.end();
}

}  // namespace burin::video

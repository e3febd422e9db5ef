// SPDX-License-Identifier: Apache-2.0
// OpenCV installs its own log callback, which prints to stderr, the first time that it opens anything, and offers no
// other way to hear what went wrong. libavutil is loaded with it; its log functions are asked for by name, so that the
// build needs no ffmpeg headers. They have had these types since libavutil 50 (log.h).
#include "core/video/module/ffmpeg_log.h"

#include <dlfcn.h>

#include <array>
#include <cstdarg>
#include <cstdio>
#include <mutex>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/videoio.hpp>
#include <utility>

namespace burin::video {
namespace {

constexpr int kAvLogError = 16;  // AV_LOG_ERROR; more serious is lower

std::mutex error_mutex;
std::string& LastError() {
  static std::string error;
  return error;
}

void KeepErrors(void* /*context*/, int level, const char* format, va_list arguments) {
  if (level > kAvLogError) return;
  std::array<char, 512> line{};
  std::vsnprintf(line.data(), line.size(), format, arguments);
  std::string text = line.data();
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ' || text.back() == '.')) text.pop_back();
  if (text.empty()) return;
  const std::lock_guard lock(error_mutex);
  LastError() = std::move(text);
}

void Install() {
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  // Opening what can't be there makes OpenCV install its callback now rather than over ours.
  cv::VideoCapture(std::string("/dev/null/none"), cv::CAP_FFMPEG);
  using Callback = void (*)(void*, int, const char*, va_list);
  if (void* set = dlsym(RTLD_DEFAULT, "av_log_set_callback"); set != nullptr) {
    reinterpret_cast<void (*)(Callback)>(set)(KeepErrors);
  }
}

}  // namespace

void CaptureFfmpegLog() {
  static std::once_flag once;
  std::call_once(once, Install);
}

std::string TakeFfmpegError() {
  const std::lock_guard lock(error_mutex);
  return std::exchange(LastError(), {});
}

}  // namespace burin::video

// SPDX-License-Identifier: Apache-2.0
// Frames are read in sequence only: seeking by number is not exact with B-frames or variable rates. OpenCV decodes with
// as many threads as there are processors and hands over BGR; it turns frames by the container's rotation itself.
#include "core/video/module/reader.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <utility>

#include "core/base/path.h"
#include "core/video/frame_rate.h"
#include "core/video/matroska.h"
#include "core/video/module/ffmpeg_log.h"

namespace burin::video {
namespace {

std::unexpected<Error> CannotRead(const std::string& path, const std::string& why) {
  return Fail(ErrorKind::kInput, fmt::format("cannot read '{}': {}", path, why));
}

bool CountsExactly(const std::string& path) {
  const std::string extension = base::LowerExtension(path);
  return extension == "mp4" || extension == "mov" || extension == "m4v" || extension == "avi" || extension == "3gp";
}

bool TellsOfTruncation(const std::string& ffmpeg_error) {
  for (const char* phrase : {"ended prematurely", "partial file", "runcated"}) {
    if (ffmpeg_error.find(phrase) != std::string::npos) return true;
  }
  return false;
}

class OpencvReader final : public VideoReader {
 public:
  OpencvReader(std::string path, cv::VideoCapture capture, bool cut_off)
      : path_(std::move(path)), capture_(std::move(capture)), cut_off_(cut_off) {}

  // Decodes the first frame, so that a file whose stream can't be decoded fails when it is opened.
  Result<void> Start() {
    if (const Result<bool> first = Decode(); !first || !*first) {
      const std::string why = TakeFfmpegError();
      return CannotRead(path_, why.empty() ? "no frame of it can be decoded"
                                           : fmt::format("no frame of it can be decoded ({})", why));
    }
    info_.width = bgr_.cols;
    info_.height = bgr_.rows;
    info_.rate = RateFromDouble(capture_.get(cv::CAP_PROP_FPS));
    const double count = capture_.get(cv::CAP_PROP_FRAME_COUNT);
    if (std::isfinite(count) && count >= 1.0 && count < 1e9) info_.frame_count = std::lround(count);
    return {};
  }

  [[nodiscard]] const VideoInfo& info() const override { return info_; }

  Result<bool> Next(image::Image& frame) override {
    if (!held_) {
      const Result<bool> decoded = Decode();
      if (!decoded) return decoded;
      if (!*decoded) return CheckEnd();
    }
    held_ = false;
    if (bgr_.cols != info_.width || bgr_.rows != info_.height || bgr_.type() != CV_8UC3) {
      return CannotRead(path_, fmt::format("frame {} is {}x{}, those before are {}x{}", frames_ + 1, bgr_.cols,
                                           bgr_.rows, info_.width, info_.height));
    }
    const std::size_t bytes = static_cast<std::size_t>(info_.width) * static_cast<std::size_t>(info_.height) * 4;
    if (frame.pixels.size() != bytes) frame.pixels.resize(bytes);
    frame.width = info_.width;
    frame.height = info_.height;
    frame.channels = 4;
    frame.type = image::SampleType::kU8;
    frame.encoding = image::Encoding::kDisplay;
    cv::Mat rgba(info_.height, info_.width, CV_8UC4, frame.pixels.data());
    cv::cvtColor(bgr_, rgba, cv::COLOR_BGR2RGBA);
    ++frames_;
    return true;
  }

 private:
  Result<bool> Decode() {
    try {
      held_ = capture_.read(bgr_) && !bgr_.empty();
      return held_;
    } catch (const cv::Exception& e) {
      return CannotRead(path_, fmt::format("frame {}: {}", frames_ + 1, e.err));
    }
  }

  // The end, or a stream that broke off? MP4 and AVI list their frames; elsewhere the count is a duration (that of the
  // longest stream) times a rate, and only ffmpeg's word or the container's own size can be trusted.
  Result<bool> CheckEnd() {
    const std::string why = TakeFfmpegError();
    const long missing = info_.frame_count.value_or(0) - frames_;
    constexpr long kCutByEditList = 2;
    const bool listed = CountsExactly(path_) && missing > (why.empty() ? kCutByEditList : 0);
    if (!listed && !cut_off_ && !TellsOfTruncation(why)) return false;
    std::string message = fmt::format("it breaks off after frame {}", frames_);
    if (missing > 0) message += fmt::format(", but says that it has {}", *info_.frame_count);
    return CannotRead(path_, why.empty() ? message : fmt::format("{} ({})", message, why));
  }

  std::string path_;
  cv::VideoCapture capture_;
  bool cut_off_;  ///< the container's own size says so
  cv::Mat bgr_;
  VideoInfo info_;
  bool held_ = false;  ///< bgr_ is decoded and not yet handed out
  long frames_ = 0;
};

// Whether the file can be a video at all, and whether it is one that was cut off.
Result<bool> CheckFile(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return CannotRead(path, std::strerror(errno));
  if (S_ISDIR(status.st_mode)) return CannotRead(path, "it is a folder");
  if (!S_ISREG(status.st_mode)) return CannotRead(path, "it is not a regular file");
  if (status.st_size == 0) return CannotRead(path, "it is empty");
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return CannotRead(path, std::strerror(errno));
  const bool cut_off = MatroskaIsCutOff(descriptor);
  close(descriptor);
  return cut_off;
}

}  // namespace

Result<std::unique_ptr<VideoReader>> OpenOpencvReader(const std::string& path) {
  const Result<bool> cut_off = CheckFile(path);
  if (!cut_off) return std::unexpected(cut_off.error());
  CaptureFfmpegLog();
  static_cast<void>(TakeFfmpegError());
  try {
    // Absolute, so that a colon in the name is not taken for a protocol.
    const std::string absolute = std::filesystem::absolute(path).string();
    cv::VideoCapture capture(absolute, cv::CAP_FFMPEG);
    if (!capture.isOpened()) {
      const std::string why = TakeFfmpegError();
      return CannotRead(path, why.empty() ? "it is damaged, or holds no video that ffmpeg can decode"
                                          : fmt::format("it is no whole video ({})", why));
    }
    auto reader = std::make_unique<OpencvReader>(path, std::move(capture), *cut_off);
    if (const Result<void> started = reader->Start(); !started) return std::unexpected(started.error());
    return reader;
  } catch (const std::exception& e) {
    return CannotRead(path, e.what());
  }
}

}  // namespace burin::video

// SPDX-License-Identifier: Apache-2.0
// OpenCV's VideoWriter drops frames of another size or type without a word, writes odd sizes one smaller where chroma
// is halved, and reports no error while it writes. So everything is checked before, and the file is opened and its
// frames are counted after.
#include "core/video/module/writer.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <optional>
#include <string_view>
#include <utility>

#include "core/base/atomic_file.h"
#include "core/base/path.h"
#include "core/video/matroska.h"
#include "core/video/module/ffmpeg_log.h"

namespace burin::video {
namespace {

struct Container {
  std::string_view extension;
  std::string_view codec;
  std::array<char, 4> fourcc;
  std::string_view written_as;  ///< the extension that OpenCV is given
};

// WebM is Matroska with another document type; OpenCV prints a complaint about the tag when it is asked for .webm.
constexpr std::array<Container, 6> kContainers{{
    {"mkv", "FFV1", {'F', 'F', 'V', '1'}, ".mkv"},
    {"avi", "FFV1", {'F', 'F', 'V', '1'}, ".avi"},
    {"mp4", "H.264", {'a', 'v', 'c', '1'}, ".mp4"},
    {"m4v", "H.264", {'a', 'v', 'c', '1'}, ".mp4"},
    {"mov", "H.264", {'a', 'v', 'c', '1'}, ".mov"},
    {"webm", "VP9", {'V', 'P', '9', '0'}, ".mkv"},
}};

std::optional<MatroskaKind> KindOf(const Container& container) {
  if (container.written_as != ".mkv") return std::nullopt;
  return container.extension == "webm" ? MatroskaKind::kWebm : MatroskaKind::kMatroska;
}

std::unexpected<Error> CannotWrite(const std::string& path, const std::string& why) {
  return Fail(ErrorKind::kFailed, fmt::format("cannot write '{}': {}", path, why));
}

const Container* FindContainer(const std::string& path) {
  const std::string extension = base::LowerExtension(path);
  for (const Container& container : kContainers) {
    if (container.extension == extension) return &container;
  }
  return nullptr;
}

Result<const Container*> CheckRequest(const std::string& path, const VideoWriteOptions& options) {
  const Container* container = FindContainer(path);
  if (container == nullptr) {
    return Fail(
        ErrorKind::kUsage,
        fmt::format("cannot write '{}': videos are written as .mkv or .avi (FFV1, lossless), .mp4 or .mov (H.264) "
                    "and .webm (VP9); for others write y4m to - and pipe it into ffmpeg",
                    path));
  }
  if (options.width <= 0 || options.height <= 0 || options.rate.numerator <= 0 || options.rate.denominator <= 0) {
    return CannotWrite(path, fmt::format("a video of {}x{} at {}/{} frames a second", options.width, options.height,
                                         options.rate.numerator, options.rate.denominator));
  }
  if (options.width % 2 != 0 || options.height % 2 != 0) {
    return Fail(
        ErrorKind::kUsage,
        fmt::format("cannot write '{}': OpenCV writes videos of even width and height only, not {}x{}; choose an "
                    "even --size, write an image sequence (name.####.png), or y4m to - and pipe it into ffmpeg",
                    path, options.width, options.height));
  }
  return container;
}

class OpencvWriter final : public VideoWriter {
 public:
  OpencvWriter(std::string path, base::AtomicFile file, cv::VideoWriter writer, const VideoWriteOptions& options,
               std::optional<MatroskaKind> matroska)
      : path_(std::move(path)),
        file_(std::move(file)),
        writer_(std::move(writer)),
        options_(options),
        matroska_(matroska) {}

  Result<void> Write(const image::Image& frame) override {
    if (frame.type != image::SampleType::kU8 || (frame.channels != 3 && frame.channels != 4) ||
        frame.width != options_.width || frame.height != options_.height) {
      return CannotWrite(
          path_, fmt::format("frame {} is {}x{} with {} channels of {} bits, the video takes {}x{} 8-bit RGB "
                             "or RGBA",
                             frames_ + 1, frame.width, frame.height, frame.channels, 8 * image::SampleBytes(frame.type),
                             options_.width, options_.height));
    }
    try {
      const int type = frame.channels == 4 ? CV_8UC4 : CV_8UC3;
      // cv::Mat has no constant view; cvtColor only reads this one.
      const cv::Mat rgb(frame.height, frame.width, type, const_cast<std::byte*>(frame.pixels.data()));
      cv::cvtColor(rgb, bgr_, frame.channels == 4 ? cv::COLOR_RGBA2BGR : cv::COLOR_RGB2BGR);
      writer_.write(bgr_);
    } catch (const std::exception& e) {
      return CannotWrite(path_, fmt::format("frame {}: {}", frames_ + 1, e.what()));
    }
    ++frames_;
    return {};
  }

  Result<void> Finish() override {
    try {
      writer_.release();
      if (frames_ == 0) return CannotWrite(path_, "it got no frames");
      if (const Result<void> checked = CheckWritten(); !checked) return checked;
      if (matroska_) {
        const Result<long> count = SettleMatroska(file_.descriptor(), path_, options_.rate, *matroska_);
        if (!count) return std::unexpected(count.error());
        if (*count != frames_) return Lost(*count, "");
      }
    } catch (const std::exception& e) {
      return CannotWrite(path_, e.what());
    }
    return file_.Commit();
  }

 private:
  Result<void> CheckWritten() {
    std::string why = TakeFfmpegError();
    cv::VideoCapture written(file_.temporary_path(), cv::CAP_FFMPEG);
    cv::Mat first;
    if (!written.isOpened() || !written.read(first)) {
      return CannotWrite(path_, fmt::format("what was written can't be read back{}", Parenthesis(why)));
    }
    if (first.cols != options_.width || first.rows != options_.height) {
      return CannotWrite(path_, fmt::format("its frames came out as {}x{} instead of {}x{}", first.cols, first.rows,
                                            options_.width, options_.height));
    }
    const long count = std::lround(written.get(cv::CAP_PROP_FRAME_COUNT));
    return count == frames_ ? Result<void>{} : Lost(count, why);
  }

  [[nodiscard]] Result<void> Lost(long count, const std::string& why) const {
    return CannotWrite(path_, fmt::format("{} of {} frames are in the file{}", count, frames_, Parenthesis(why)));
  }

  static std::string Parenthesis(const std::string& why) { return why.empty() ? "" : fmt::format(" ({})", why); }

  std::string path_;
  base::AtomicFile file_;
  cv::VideoWriter writer_;
  VideoWriteOptions options_;
  std::optional<MatroskaKind> matroska_;
  cv::Mat bgr_;
  long frames_ = 0;
};

}  // namespace

Result<std::unique_ptr<VideoWriter>> OpenOpencvWriter(const std::string& path, const VideoWriteOptions& options) {
  const Result<const Container*> container = CheckRequest(path, options);
  if (!container) return std::unexpected(container.error());
  Result<base::AtomicFile> file = base::AtomicFile::Create(path, std::string((*container)->written_as));
  if (!file) return std::unexpected(file.error());
  CaptureFfmpegLog();
  static_cast<void>(TakeFfmpegError());
  try {
    const auto& tag = (*container)->fourcc;
    cv::VideoWriter writer(file->temporary_path(), cv::CAP_FFMPEG,
                           cv::VideoWriter::fourcc(tag[0], tag[1], tag[2], tag[3]), options.rate.value(),
                           cv::Size(options.width, options.height), true);
    if (!writer.isOpened()) {
      const std::string why = TakeFfmpegError();
      return CannotWrite(path,
                         fmt::format("no {} encoder takes {}x{} at {:.6g} frames a second{}; write .mkv (FFV1), an "
                                     "image sequence, or y4m to - and pipe it into ffmpeg",
                                     (*container)->codec, options.width, options.height, options.rate.value(),
                                     why.empty() ? "" : fmt::format(" ({})", why)));
    }
    return std::make_unique<OpencvWriter>(path, std::move(*file), std::move(writer), options, KindOf(**container));
  } catch (const std::exception& e) {
    return CannotWrite(path, e.what());
  }
}

}  // namespace burin::video

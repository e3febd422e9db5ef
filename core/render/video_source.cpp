// SPDX-License-Identifier: Apache-2.0
// Video files by the video module, y4m files and streams by core/video/y4m.
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "core/render/source.h"
#include "core/video/y4m.h"

namespace burin::render {
namespace {

/// An open file that closes itself; stdin is not owned.
class Descriptor {
 public:
  Descriptor(int number, bool owned) : number_(number), owned_(owned) {}
  Descriptor(Descriptor&& other) noexcept : number_(other.number_), owned_(std::exchange(other.owned_, false)) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (owned_) close(number_);
  }
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
  bool owned_;
};

/// Decodes in order; frames that are not wanted are decoded and dropped, since seeking is not exact in every file.
class VideoSource final : public Source {
 public:
  VideoSource(Descriptor descriptor, std::unique_ptr<video::VideoReader> reader, SourceKind kind, std::string name)
      : descriptor_(std::move(descriptor)), reader_(std::move(reader)), name_(std::move(name)) {
    const video::VideoInfo& video = reader_->info();
    info_.kind = kind;
    info_.width = video.width;
    info_.height = video.height;
    info_.rate = video.rate;
    info_.has_alpha = false;
    if (kind != SourceKind::kVideo) info_.chroma = video.chroma;
    info_.expected_frames = video.frame_count;
  }
  [[nodiscard]] const SourceInfo& info() const override { return info_; }

  [[nodiscard]] Result<bool> Read(long number, SourceFrame& frame) override {
    frame.number = number;
    if (number < 1) {
      return Fail(ErrorKind::kInput, fmt::format("{}: frame {}: a video's frames begin at 1", name_, number));
    }
    if (!frame.picture) frame.picture.emplace();
    while (decoded_ < number) {
      auto more = reader_->Next(*frame.picture);
      if (!more) return std::unexpected(more.error());
      if (!*more) return false;
      ++decoded_;
    }
    return true;
  }

 private:
  Descriptor descriptor_;  // outlives the reader
  std::unique_ptr<video::VideoReader> reader_;
  SourceInfo info_;
  std::string name_;
  long decoded_ = 0;
};

}  // namespace

Result<std::unique_ptr<Source>> OpenVideoSource(const Job& job, SourceKind kind) {
  if (kind == SourceKind::kVideo) {
    auto module = video::LoadVideoModule();
    if (!module) return std::unexpected(module.error());
    auto reader = (*module)->OpenReader(job.source);
    if (!reader) return std::unexpected(reader.error());
    return std::make_unique<VideoSource>(Descriptor(-1, false), *std::move(reader), kind, job.source);
  }
  const bool is_stream = kind == SourceKind::kY4mStream;
  const std::string name = is_stream ? "stdin" : job.source;
  Descriptor descriptor(is_stream ? STDIN_FILENO : open(job.source.c_str(), O_RDONLY | O_CLOEXEC), !is_stream);
  if (descriptor.number() < 0) {
    return Fail(ErrorKind::kInput, fmt::format("{}: cannot open: {}", name, std::strerror(errno)));
  }
  if (is_stream && isatty(STDIN_FILENO) == 1) {
    return Fail(ErrorKind::kUsage, "-: stdin is a terminal; expected a YUV4MPEG2 stream (ffmpeg -f yuv4mpegpipe -)");
  }
  auto reader = video::OpenY4mReader(descriptor.number(), name);
  if (!reader) return std::unexpected(reader.error());
  return std::make_unique<VideoSource>(std::move(descriptor), *std::move(reader), kind, name);
}

}  // namespace burin::render

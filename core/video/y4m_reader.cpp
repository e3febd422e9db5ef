// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "core/base/file_io.h"
#include "core/image/convert.h"
#include "core/video/y4m.h"
#include "core/video/y4m_header.h"

namespace burin::video {
namespace {

// Header lines from a buffer, payload straight from the descriptor.
class Stream {
 public:
  explicit Stream(int descriptor) : descriptor_(descriptor), buffer_(kBufferBytes) {}

  /// True when nothing is left. Errors stay in error().
  [[nodiscard]] bool AtEnd() { return begin_ == end_ && !Fill(); }

  /// The next line without its newline; cut off at kLongestY4mHeader or the end, with `complete` false.
  std::string Line(bool& complete) {
    std::string line;
    complete = false;
    while (line.size() < kLongestY4mHeader && !AtEnd()) {
      const char c = static_cast<char>(buffer_[begin_++]);
      if (c == '\n') {
        complete = true;
        break;
      }
      line += c;
    }
    return line;
  }

  /// Fills `to` and says how much of it there was.
  std::size_t Read(std::span<std::byte> to) {
    const std::size_t buffered = std::min(to.size(), end_ - begin_);
    std::memcpy(to.data(), buffer_.data() + begin_, buffered);
    begin_ += buffered;
    if (buffered == to.size()) return buffered;
    const base::ReadCount count = base::ReadAll(descriptor_, to.subspan(buffered));
    error_ = count.error;
    return buffered + count.bytes;
  }

  [[nodiscard]] int error() const { return error_; }

 private:
  static constexpr std::size_t kBufferBytes = 4096;

  // One read, not ReadAll: a writer that waits for us must not be waited for.
  bool Fill() {
    begin_ = end_ = 0;
    const ssize_t got = base::ReadSome(descriptor_, buffer_);
    if (got < 0) error_ = static_cast<int>(-got);
    if (got > 0) end_ = static_cast<std::size_t>(got);
    return got > 0;
  }

  int descriptor_;
  int error_ = 0;
  std::vector<std::byte> buffer_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
};

std::unexpected<Error> Broken(const std::string& name, const std::string& why) {
  return Fail(ErrorKind::kInput, fmt::format("cannot read '{}': {}", name, why));
}

class Y4mReader final : public VideoReader {
 public:
  Y4mReader(Stream stream, std::string name, const Y4mHeader& header)
      : stream_(std::move(stream)), name_(std::move(name)), header_(header) {}

  [[nodiscard]] const VideoInfo& info() const override { return header_.info; }

  Result<bool> Next(image::Image& frame) override {
    if (stream_.AtEnd()) return stream_.error() == 0 ? Result<bool>(false) : ReadError();
    bool complete = false;
    const std::string line = stream_.Line(complete);
    if (line != "FRAME" && !line.starts_with("FRAME ")) {
      if (!complete && std::string_view("FRAME").starts_with(line)) return BrokeOff();
      return Broken(name_, fmt::format("frame {} does not begin with FRAME", frames_ + 1));
    }
    if (!complete) {
      if (line.size() < kLongestY4mHeader) return BrokeOff();
      return Broken(name_,
                    fmt::format("the header of frame {} is longer than {} bytes", frames_ + 1, kLongestY4mHeader));
    }
    if (!ReadPlanes()) return stream_.error() == 0 ? Result<bool>(BrokeOff()) : ReadError();
    Convert(FrameIsInterlaced(line, header_.interlaced), frame);
    ++frames_;
    return true;
  }

 private:
  // The header's size is only believed as data arrive: no more is set aside than came, and a step.
  bool ReadPlanes() {
    constexpr std::size_t kStep = std::size_t{32} << 20;
    const std::size_t total = header_.layout.frame_bytes();
    std::size_t done = 0;
    while (done < total) {
      const std::size_t step = std::min(total - done, std::max(kStep, planes_.size() - done));
      if (planes_.size() < done + step) planes_.resize(done + step);
      const std::size_t got = stream_.Read(std::as_writable_bytes(std::span(planes_).subspan(done, step)));
      done += got;
      if (got < step) return false;
    }
    return true;
  }

  void Convert(bool interlaced, image::Image& frame) const {
    const YcbcrLayout& layout = header_.layout;
    const std::size_t bytes = layout.luma_bytes() * 4;
    if (frame.pixels.size() != bytes) frame.pixels.resize(bytes);
    frame.width = layout.width;
    frame.height = layout.height;
    frame.channels = 4;
    frame.type = image::SampleType::kU8;
    frame.encoding = image::Encoding::kDisplay;
    RgbaFromYcbcr(layout, interlaced, planes_, frame.As<std::uint8_t>());
  }

  [[nodiscard]] std::unexpected<Error> BrokeOff() const {
    return Broken(name_, fmt::format("the stream breaks off in frame {}", frames_ + 1));
  }
  [[nodiscard]] Result<bool> ReadError() const {
    return Broken(name_, fmt::format("{} in frame {}", std::generic_category().message(stream_.error()), frames_ + 1));
  }

  Stream stream_;
  std::string name_;
  Y4mHeader header_;
  std::vector<std::uint8_t> planes_;
  long frames_ = 0;
};

}  // namespace

Result<std::unique_ptr<VideoReader>> OpenY4mReader(int descriptor, const std::string& name) {
  base::WidenPipe(descriptor);
  Stream stream(descriptor);
  if (stream.AtEnd()) {
    return Broken(name, stream.error() == 0 ? "it is empty, not a YUV4MPEG2 stream"
                                            : std::generic_category().message(stream.error()));
  }
  bool complete = false;
  const std::string line = stream.Line(complete);
  if (!complete && line.starts_with("YUV4MPEG2")) {
    return Broken(name, line.size() < kLongestY4mHeader
                            ? "the stream breaks off in its header"
                            : fmt::format("its header is longer than {} bytes", kLongestY4mHeader));
  }
  const Result<Y4mHeader> header = ParseY4mHeader(line, name);
  if (!header) return std::unexpected(header.error());
  return std::make_unique<Y4mReader>(std::move(stream), name, *header);
}

}  // namespace burin::video

// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <span>
#include <string_view>
#include <system_error>
#include <vector>

#include "core/base/file_io.h"
#include "core/image/convert.h"
#include "core/video/y4m.h"
#include "core/video/y4m_header.h"

namespace burin::video {
namespace {

constexpr std::string_view kFrameHeader = "FRAME\n";

class Y4mWriter final : public VideoWriter {
 public:
  Y4mWriter(int descriptor, std::string name, const YcbcrLayout& layout)
      : descriptor_(descriptor),
        name_(std::move(name)),
        layout_(layout),
        buffer_(kFrameHeader.size() + layout.frame_bytes()) {
    std::memcpy(buffer_.data(), kFrameHeader.data(), kFrameHeader.size());
  }

  Result<void> Send(std::span<const std::byte> bytes) {
    const int error = base::WriteAll(descriptor_, bytes);
    if (error == 0) return {};
    const std::string why = error == EPIPE ? "its reader has closed the pipe" : std::generic_category().message(error);
    return Fail(ErrorKind::kFailed, fmt::format("cannot write '{}': {} (frame {})", name_, why, frames_ + 1));
  }

  Result<void> Write(const image::Image& frame) override {
    if (frame.type != image::SampleType::kU8 || (frame.channels != 3 && frame.channels != 4) ||
        frame.width != layout_.width || frame.height != layout_.height) {
      return Fail(
          ErrorKind::kFailed,
          fmt::format("cannot write '{}': frame {} is {}x{} with {} channels of {} bits, the stream takes {}x{} "
                      "8-bit RGB or RGBA",
                      name_, frames_ + 1, frame.width, frame.height, frame.channels, 8 * image::SampleBytes(frame.type),
                      layout_.width, layout_.height));
    }
    const std::span<std::uint8_t> planes = std::span(buffer_).subspan(kFrameHeader.size());
    if (frame.channels == 4) {
      YcbcrFromRgba(layout_, frame.As<std::uint8_t>(), planes);
    } else {
      YcbcrFromRgba(layout_, image::ToChannels(frame, 4).As<std::uint8_t>(), planes);
    }
    // Header and planes in one write: a pipe's reader wakes once.
    if (Result<void> sent = Send(std::as_bytes(std::span(buffer_))); !sent) return sent;
    ++frames_;
    return {};
  }

  Result<void> Finish() override { return {}; }

 private:
  int descriptor_;
  std::string name_;
  YcbcrLayout layout_;
  std::vector<std::uint8_t> buffer_;
  long frames_ = 0;
};

}  // namespace

Result<std::unique_ptr<VideoWriter>> OpenY4mWriter(int descriptor, const std::string& name,
                                                   const VideoWriteOptions& options) {
  if (options.width <= 0 || options.height <= 0 || options.rate.numerator <= 0 || options.rate.denominator <= 0) {
    return Fail(ErrorKind::kFailed,
                fmt::format("cannot write '{}': a stream of {}x{} at {}:{} frames a second", name, options.width,
                            options.height, options.rate.numerator, options.rate.denominator));
  }
  base::WidenPipe(descriptor);
  auto writer = std::make_unique<Y4mWriter>(descriptor, name, LayoutOf(options.width, options.height, options.chroma));
  const std::string header = FormatY4mHeader(options);
  if (const Result<void> sent = writer->Send(std::as_bytes(std::span(header))); !sent)
    return std::unexpected(sent.error());
  return writer;
}

}  // namespace burin::video

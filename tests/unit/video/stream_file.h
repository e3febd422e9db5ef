// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "core/image/convert.h"
#include "core/image/image.h"

namespace burin::test {

/// An unnamed file as a stream: write, Rewind, read.
class StreamFile {
 public:
  StreamFile() {
    std::string pattern = "/tmp/burin_stream_XXXXXX";
    descriptor_ = mkstemp(pattern.data());
    unlink(pattern.c_str());
  }
  explicit StreamFile(std::string_view content) : StreamFile() {
    if (::write(descriptor_, content.data(), content.size()) != static_cast<ssize_t>(content.size()))
      std::perror("write");
    Rewind();
  }
  ~StreamFile() { close(descriptor_); }
  StreamFile(const StreamFile&) = delete;
  StreamFile& operator=(const StreamFile&) = delete;

  [[nodiscard]] int descriptor() const { return descriptor_; }
  void Rewind() const { lseek(descriptor_, 0, SEEK_SET); }
  [[nodiscard]] std::string Content() const {
    std::string content(static_cast<std::size_t>(lseek(descriptor_, 0, SEEK_END)), '\0');
    if (pread(descriptor_, content.data(), content.size(), 0) < 0) std::perror("pread");
    return content;
  }

 private:
  int descriptor_ = -1;
};

/// An RGBA frame of smooth colours that differ from frame to frame.
inline image::Image SmoothFrame(int width, int height, int number) {
  image::Image frame = image::MakeImage(width, height, 4, image::SampleType::kU8, image::Encoding::kDisplay);
  std::uint8_t* pixel = frame.As<std::uint8_t>().data();
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x, pixel += 4) {
      pixel[0] = static_cast<std::uint8_t>(40 + (x * 150) / width);
      pixel[1] = static_cast<std::uint8_t>(60 + (y * 120) / height);
      pixel[2] = static_cast<std::uint8_t>(50 + (number * 10) % 150);
      pixel[3] = 255;
    }
  }
  return frame;
}

inline bool HasFfmpeg() { return std::system("ffmpeg -version >/dev/null 2>&1") == 0; }

}  // namespace burin::test

// SPDX-License-Identifier: Apache-2.0
#pragma once
// core/video: videos in and out. y4m is our own (core/video/y4m.h); everything else is OpenCV, behind a module that is
// loaded when first needed, because OpenCV's videoio takes 0.23 s to load.

#include <memory>
#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/image/image.h"

namespace burin::video {

/// Frames a second as a ratio, e.g. 30000/1001.
struct FrameRate {
  int numerator = 24;
  int denominator = 1;
  [[nodiscard]] double value() const { return static_cast<double>(numerator) / denominator; }
};

/// Chroma subsampling of a YCbCr stream.
enum class Chroma { k420, k422, k444 };

struct VideoInfo {
  int width = 0;
  int height = 0;
  FrameRate rate;
  std::optional<long> frame_count;  ///< what the container says; empty when it doesn't (streams)
  Chroma chroma = Chroma::k420;
};

class VideoReader {
 public:
  virtual ~VideoReader() = default;
  [[nodiscard]] virtual const VideoInfo& info() const = 0;
  /// The next frame as kU8 RGBA (alpha 255), kDisplay, into `frame` (its storage is reused); false at the end.
  /// A stream that breaks off before the container's frame count is an error that names the frame.
  [[nodiscard]] virtual Result<bool> Next(image::Image& frame) = 0;
};

class VideoWriter {
 public:
  virtual ~VideoWriter() = default;
  /// kU8, 4 channels (alpha is dropped) or 3 channels RGB, of the size given at the start.
  [[nodiscard]] virtual Result<void> Write(const image::Image& frame) = 0;
  /// Finishes the stream, checks it (frame count of the written file) and gives the file its name. Without it the
  /// destructor removes the temporary file.
  [[nodiscard]] virtual Result<void> Finish() = 0;
};

struct VideoWriteOptions {
  int width = 0;
  int height = 0;
  FrameRate rate;
  Chroma chroma = Chroma::k444;  ///< y4m only
};

class VideoModule {
 public:
  virtual ~VideoModule() = default;
  [[nodiscard]] virtual Result<std::unique_ptr<VideoReader>> OpenReader(const std::string& path) = 0;
  /// By extension: .mkv and .avi FFV1 (lossless), .mp4 and .mov H.264. Odd sizes with H.264 are refused (kUsage).
  [[nodiscard]] virtual Result<std::unique_ptr<VideoWriter>> OpenWriter(const std::string& path,
                                                                        const VideoWriteOptions&) = 0;
  [[nodiscard]] virtual std::string Versions() = 0;
};

/// Loads the module once (thread-safe) and keeps it. Errors: kFailed when the shared object is missing.
[[nodiscard]] Result<VideoModule*> LoadVideoModule();

/// True for the extensions the video module takes (.mkv .mp4 .mov .avi .webm .m4v .mpg ...), needing no module.
[[nodiscard]] bool IsVideoPath(const std::string& path);

}  // namespace burin::video

// SPDX-License-Identifier: Apache-2.0
#include "core/render/output_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "core/base/path.h"
#include "core/image/file_format.h"
#include "core/video/video_module.h"

namespace burin::render {
namespace {

namespace fs = std::filesystem;

bool IsH264(const std::string& extension) { return extension == "mp4" || extension == "mov" || extension == "m4v"; }

/// Formats whose floats are scene-linear light.
bool IsSceneLinear(const std::string& extension, int depth_bits) {
  if (extension == "exr" || extension == "hdr" || extension == "pfm") return true;
  return (extension == "tif" || extension == "tiff") && depth_bits == 32;
}

image::SampleType ChooseType(const Output& output, const std::string& extension, const Job& job,
                             const SourceInfo& source) {
  using enum image::SampleType;
  if (output.encoding == image::Encoding::kSceneLinear) {
    if (job.depth_bits == 8) return kU8;  // for CheckWritable to refuse
    if (extension == "hdr" || extension == "pfm") return kF32;
    return job.depth_bits == 32 ? kF32 : kF16;
  }
  if (job.depth_bits == 32) return kF32;
  if (job.depth_bits == 16) return kU16;
  const bool has_more = source.type == kU16;
  const bool takes_more = extension == "png" || extension == "tif" || extension == "tiff";
  return job.depth_bits == 0 && has_more && takes_more ? kU16 : kU8;
}

Result<void> CheckVideo(const Output& output, const Job& job, int width, int height) {
  const std::string& path = output.pattern.text();
  if (job.depth_bits > 8) {
    return Fail(ErrorKind::kUsage, fmt::format("{}: video holds 8 bits a channel, not {}; write an image sequence "
                                               "instead (frame.####.png or frame.####.exr)",
                                               path, job.depth_bits));
  }
  if (job.alpha == AlphaOutput::kKeep) {
    return Fail(ErrorKind::kUsage, fmt::format("{}: video holds no alpha; write an image sequence instead "
                                               "(frame.####.png or frame.####.exr)",
                                               path));
  }
  if (output.kind == OutputKind::kVideo && IsH264(base::LowerExtension(path)) && (width % 2 != 0 || height % 2 != 0)) {
    return Fail(ErrorKind::kUsage, fmt::format("{}: H.264 needs an even width and height, the frame is {}x{}; use "
                                               "--size, or .mkv (FFV1)",
                                               path, width, height));
  }
  return {};
}

}  // namespace

Result<Output> ClassifyOutput(const Job& job) {
  Output output;
  if (job.output.empty())
    return Fail(ErrorKind::kUsage, "no output; expected -o FILE (or -o - for a stream on stdout)");
  auto pattern = NamePattern::Parse(job.output);
  if (!pattern) return std::unexpected(pattern.error());
  output.pattern = *std::move(pattern);
  const std::string extension = base::LowerExtension(job.output);
  if (job.output == "-") {
    output.kind = OutputKind::kY4mStream;
  } else if (extension == "y4m") {
    output.kind = OutputKind::kY4mFile;
  } else if (video::IsVideoPath(job.output)) {
    output.kind = OutputKind::kVideo;
  } else if (image::IsImagePath(job.output)) {
    output.kind = OutputKind::kImages;
    output.is_exr = extension == "exr";
    if (IsSceneLinear(extension, job.depth_bits)) output.encoding = image::Encoding::kSceneLinear;
  } else {
    return Fail(
        ErrorKind::kUsage,
        fmt::format("{}: {}; expected an image (.png .jpg .tif .exr), a video (.mkv .mp4 .avi .mov .y4m) or -",
                    job.output,
                    extension.empty() ? std::string("no extension") : fmt::format("unknown extension .{}", extension)));
  }
  if (output.is_video() && output.pattern.has_token()) {
    return Fail(ErrorKind::kUsage, fmt::format("{}: a video is one file, its name takes no frame number", job.output));
  }
  return output;
}

Result<void> ChooseSamples(Output& output, const Job& job, const SourceInfo& source, int width, int height) {
  const std::string& path = output.pattern.text();
  if (output.is_video()) {
    output.channels = 4;  // what the writers take fastest; they drop the alpha
    return CheckVideo(output, job, width, height);
  }
  output.type = ChooseType(output, base::LowerExtension(path), job, source);
  if (auto good = image::CheckWritable(path, output.type, 3); !good) return good;
  const std::string extension = base::LowerExtension(path);
  const bool drops_alpha = extension == "jpg" || extension == "jpeg" || extension == "hdr";
  const auto with_alpha = drops_alpha
                              ? Fail(ErrorKind::kUsage, fmt::format("{}: .{} files hold no alpha; expected .png, "
                                                                    ".tif or .exr",
                                                                    path, extension))
                              : image::CheckWritable(path, output.type, 4);
  switch (job.alpha) {
    case AlphaOutput::kKeep:
      if (!with_alpha) return with_alpha;
      output.channels = 4;
      break;
    case AlphaOutput::kDrop:
      output.channels = 3;
      break;
    case AlphaOutput::kAuto:
      output.channels = source.has_alpha && with_alpha ? 4 : 3;
      break;
  }
  return {};
}

Result<void> CheckPlace(const Output& output, bool make_folders) {
  if (output.kind == OutputKind::kY4mStream) {
    if (isatty(STDOUT_FILENO) == 1) {
      return Fail(ErrorKind::kUsage, "-: stdout is a terminal; pipe the stream into another program");
    }
    return {};
  }
  const fs::path path(output.pattern.text());
  const fs::path folder = path.parent_path().empty() ? fs::path(".") : path.parent_path();
  std::error_code status;
  if (make_folders) {
    fs::create_directories(folder, status);
    if (status) {
      return Fail(ErrorKind::kFailed,
                  fmt::format("{}: cannot make the folder {}: {}", path.string(), folder.string(), status.message()));
    }
  }
  if (!fs::is_directory(folder, status)) {
    return Fail(ErrorKind::kFailed,
                fmt::format("{}: the folder {} is not there; --mkdir makes it", path.string(), folder.string()));
  }
  if (access(folder.c_str(), W_OK | X_OK) != 0) {
    return Fail(ErrorKind::kFailed, fmt::format("{}: cannot write in the folder {}: {}", path.string(), folder.string(),
                                                std::strerror(errno)));
  }
  if (!output.pattern.has_token() && fs::exists(path, status)) {
    if (!fs::is_regular_file(path, status)) {
      return Fail(ErrorKind::kFailed, fmt::format("{}: is no regular file", path.string()));
    }
    if (access(path.c_str(), W_OK) != 0) {
      return Fail(ErrorKind::kFailed, fmt::format("{}: cannot write: {}", path.string(), std::strerror(errno)));
    }
  }
  return {};
}

}  // namespace burin::render

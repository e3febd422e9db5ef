// SPDX-License-Identifier: Apache-2.0
#include "core/render/versions.h"

#include <fmt/format.h>

#include "core/gl/context.h"
#include "core/image/image_module.h"
#include "core/video/video_module.h"

namespace burin::render {

std::string ProgramVersion() { return BURIN_VERSION; }

std::vector<std::string> LibraryVersions() {
  std::vector<std::string> lines;
  const auto images = image::LoadImageModule();
  lines.push_back(images ? (*images)->Versions() : images.error().message);
  const auto videos = video::LoadVideoModule();
  lines.push_back(videos ? (*videos)->Versions() : videos.error().message);
  return lines;
}

Result<std::string> DescribeDevice(const std::string& device) {
  gl::SetDriverEnvironment(0);
  auto context = gl::Context::Create({.device = device, .debug = false});
  if (!context) return std::unexpected(context.error());
  const gl::DeviceInfo& info = (*context)->info();
  std::string text = fmt::format(
      "device: {}{}\n        {}\n        OpenGL {}\n        textures up to {}x{}, {} draw buffers, {} samples\n",
      info.renderer, info.is_software ? " (software)" : "", info.vendor, info.version, info.max_texture_size,
      info.max_texture_size, info.max_draw_buffers, info.max_samples);
  for (const std::string& line : gl::ListDevices()) text += fmt::format("--device {}\n", line);
  return text;
}

}  // namespace burin::render

// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <opencv2/core.hpp>

#include "core/base/temporaries.h"
#include "core/video/module/reader.h"
#include "core/video/module/writer.h"
#include "core/video/module_factory.h"
#include "core/video/video_module.h"

namespace burin::video {
namespace {

class OpencvModule final : public VideoModule {
 public:
  Result<std::unique_ptr<VideoReader>> OpenReader(const std::string& path) override { return OpenOpencvReader(path); }

  Result<std::unique_ptr<VideoWriter>> OpenWriter(const std::string& path, const VideoWriteOptions& options) override {
    return OpenOpencvWriter(path, options);
  }

  std::string Versions() override { return fmt::format("OpenCV {}", cv::getVersionString()); }
};

}  // namespace
}  // namespace burin::video

extern "C" __attribute__((visibility("default"))) burin::video::VideoModule* BurinVideoModule(
    burin::base::TemporaryRegistry* temporaries) {
  burin::base::ShareTemporaries(*temporaries);
  return new burin::video::OpencvModule;
}

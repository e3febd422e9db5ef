// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/image/image_module.h"
#include "core/render/plan.h"

namespace burin::render {

/// One frame off the device.
struct RenderedFrame {
  long number = 1;
  image::Image picture;              ///< empty when Plan::has_frame is false and the output takes layers
  std::vector<image::Image> layers;  ///< one for each of Plan::layers
};

/// Where frames go. Write() comes from workers() threads at once; with one worker, in frame order.
class Sink {
 public:
  virtual ~Sink() = default;
  [[nodiscard]] virtual int workers() const = 0;
  /// The path that the frame went to. What is written before a failure stays valid. Errors: kFailed.
  [[nodiscard]] virtual Result<std::string> Write(RenderedFrame frame) = 0;
  /// After the last frame: gives a video its name. Without it nothing of a video is left.
  [[nodiscard]] virtual Result<void> Finish() = 0;
};

/// `transform` turns frames whose encoding is not the output's.
[[nodiscard]] Result<std::unique_ptr<Sink>> OpenSink(const Plan& plan, const Job& job, const SourceInfo& source,
                                                     std::shared_ptr<const image::ColorTransform> transform);

// One file each.
[[nodiscard]] Result<std::unique_ptr<Sink>> OpenImageSink(const Plan& plan, const Job& job,
                                                          std::shared_ptr<const image::ColorTransform> transform);
[[nodiscard]] Result<std::unique_ptr<Sink>> OpenVideoSink(const Plan& plan, const Job& job, const SourceInfo& source,
                                                          std::shared_ptr<const image::ColorTransform> transform);

}  // namespace burin::render

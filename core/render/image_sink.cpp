// SPDX-License-Identifier: Apache-2.0
// One image file a frame; EXR files take attributes as layers.
#include <algorithm>

#include "core/base/cpu.h"
#include "core/image/convert.h"
#include "core/render/colour.h"
#include "core/render/sink.h"

namespace burin::render {
namespace {

std::vector<std::string> FrameChannels(int channels) {
  std::vector<std::string> names{"R", "G", "B", "A"};
  names.resize(static_cast<std::size_t>(channels));
  return names;
}

/// An attribute's channels; colour beside a frame must not take the frame's names.
std::vector<std::string> LayerChannels(gbuffer::Attribute attribute, int channels, bool beside_frame) {
  const gbuffer::AttributeInfo& info = gbuffer::Info(attribute);
  std::vector<std::string> names;
  for (int i = 0; i < channels; ++i) {
    std::string name(info.exr_channels[static_cast<std::size_t>(i)]);
    if (beside_frame && attribute == gbuffer::Attribute::kColor) name = "color." + name;
    names.push_back(std::move(name));
  }
  return names;
}

class ImageSink final : public Sink {
 public:
  ImageSink(image::ImageModule& module, const Plan& plan, const Job& job,
            std::shared_ptr<const image::ColorTransform> transform)
      : module_(module), plan_(plan), transform_(std::move(transform)) {
    options_.jpeg_quality = job.quality;
    const int threads = job.threads > 0 ? job.threads : base::AvailableThreads();
    const std::size_t frames = std::max<std::size_t>(plan.frames.size(), 1);
    workers_ = static_cast<int>(std::min<std::size_t>(static_cast<std::size_t>(threads), frames));
  }

  [[nodiscard]] int workers() const override { return workers_; }

  [[nodiscard]] Result<std::string> Write(RenderedFrame frame) override {
    const std::string path = plan_.output.pattern.Format(frame.number);
    if (!frame.picture.pixels.empty()) Encode(frame.picture);
    const auto written = plan_.layers.empty() || !plan_.output.is_exr
                             ? module_.Write(path, frame.picture, options_)
                             : module_.WriteLayers(path, Layers(frame), options_);
    if (!written) return std::unexpected(written.error());
    return path;
  }

  [[nodiscard]] Result<void> Finish() override { return {}; }

 private:
  void Encode(image::Image& picture) const {
    const Output& output = plan_.output;
    const bool same = picture.encoding == output.encoding || picture.encoding == image::Encoding::kData;
    if (!same || picture.type != output.type) {
      picture = ConvertEncoding(picture, output.encoding, output.type, *transform_);
    }
    if (picture.channels > output.channels) picture = image::ToChannels(picture, output.channels);
  }

  [[nodiscard]] std::vector<image::Layer> Layers(const RenderedFrame& frame) const {
    std::vector<image::Layer> layers;
    if (plan_.has_frame) layers.push_back({FrameChannels(frame.picture.channels), &frame.picture});
    for (std::size_t i = 0; i < frame.layers.size(); ++i) {
      layers.push_back({LayerChannels(plan_.layers[i], frame.layers[i].channels, plan_.has_frame), &frame.layers[i]});
    }
    return layers;
  }

  image::ImageModule& module_;
  const Plan& plan_;
  std::shared_ptr<const image::ColorTransform> transform_;
  image::WriteOptions options_;
  int workers_ = 1;
};

}  // namespace

Result<std::unique_ptr<Sink>> OpenImageSink(const Plan& plan, const Job& job,
                                            std::shared_ptr<const image::ColorTransform> transform) {
  auto module = image::LoadImageModule();
  if (!module) return std::unexpected(module.error());
  return std::make_unique<ImageSink>(**module, plan, job, std::move(transform));
}

}  // namespace burin::render

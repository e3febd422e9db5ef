// SPDX-License-Identifier: Apache-2.0
#include <OpenColorIO/OpenColorIO.h>
#include <OpenEXRConfig.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "core/base/cpu.h"
#include "core/base/path.h"
#include "core/base/temporaries.h"
#include "core/image/file_format.h"
#include "core/image/image_module.h"
#include "core/image/module/color.h"
#include "core/image/module/reader.h"
#include "core/image/module/writer.h"
#include "core/image/module_factory.h"

namespace burin::image {
namespace {

// Channel names of a plain picture, as OpenEXR's technical introduction gives them.
std::vector<std::string> PictureChannels(int channels) {
  switch (channels) {
    case 1:
      return {"Y"};
    case 2:
      return {"Y", "A"};
    case 3:
      return {"R", "G", "B"};
    default:
      return {"R", "G", "B", "A"};
  }
}

class OiioModule final : public ImageModule {
 public:
  Result<Image> Read(const std::string& path) override { return ReadFile(path); }

  Result<Image> ReadMemory(std::span<const std::byte> bytes, const std::string& name) override {
    return ReadBytes(bytes, name);
  }

  Result<void> Write(const std::string& path, const Image& image, const WriteOptions& options) override {
    if (const Result<void> writable = CheckImage(path, image); !writable) return writable;
    if (base::LowerExtension(path) != "exr") return WriteWithOiio(path, image, options);
    const Layer layer{PictureChannels(image.channels), &image};
    return WriteExr(path, {&layer, 1}, options);
  }

  Result<void> WriteLayers(const std::string& path, std::span<const Layer> layers,
                           const WriteOptions& options) override {
    if (base::LowerExtension(path) != "exr") {
      return Fail(ErrorKind::kUsage, fmt::format("cannot write '{}': only .exr holds layers", path));
    }
    return WriteExr(path, layers, options);
  }

  Result<void> CanWrite(const std::string& path, SampleType type, int channels) override {
    return CheckWritable(path, type, channels);
  }

  Result<std::shared_ptr<const ColorTransform>> MakeColorTransform(const ColorOptions& options) override {
    if (!options.config.empty()) return MakeOcioTransform(options);
    if (!options.display.empty() || !options.view.empty()) {
      return Fail(ErrorKind::kUsage, fmt::format("{} '{}' needs an OpenColorIO configuration (--ocio or $OCIO)",
                                                 options.display.empty() ? "view" : "display",
                                                 options.display.empty() ? options.view : options.display));
    }
    return SrgbTransform();
  }

  std::string Versions() override {
    const int version = OIIO::openimageio_version();
    return fmt::format("OpenImageIO {}.{}.{}, OpenEXR {}, OpenColorIO {}", version / 10000, version / 100 % 100,
                       version % 100, OPENEXR_VERSION_STRING, OCIO_NAMESPACE::GetVersion());
  }

 private:
  static Result<void> CheckImage(const std::string& path, const Image& image) {
    if (image.width <= 0 || image.height <= 0 ||
        image.pixels.size() != image.RowBytes() * static_cast<std::size_t>(image.height)) {
      return Fail(ErrorKind::kFailed, fmt::format("cannot write '{}': {} bytes of pixels do not make a {}x{} picture",
                                                  path, image.pixels.size(), image.width, image.height));
    }
    return CheckWritable(path, image.type, image.channels);
  }
};

}  // namespace
}  // namespace burin::image

extern "C" __attribute__((visibility("default"))) burin::image::ImageModule* BurinImageModule(
    burin::base::TemporaryRegistry* temporaries) {
  burin::base::ShareTemporaries(*temporaries);
  OCIO_NAMESPACE::SetLoggingLevel(OCIO_NAMESPACE::LOGGING_LEVEL_NONE);
  OIIO::attribute("threads", burin::base::AvailableThreads());
  return new burin::image::OiioModule;
}

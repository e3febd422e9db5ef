// SPDX-License-Identifier: Apache-2.0
#pragma once
// core/image as a loadable module. OpenImageIO and OpenColorIO bring some 250 shared libraries with them and take
// 0.38 s to load, so the program reaches them through this interface, loaded when first needed (LoadImageModule),
// on a thread beside the EGL start.

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/image/image.h"

namespace burin::image {

/// Converts colours in place between the display encoding and scene-linear light. Thread-safe, immutable.
class ColorTransform {
 public:
  virtual ~ColorTransform() = default;
  /// `rgba`: pixels of 4 floats; alpha is left alone.
  virtual void SceneToDisplay(std::span<float> rgba) const = 0;
  virtual void DisplayToScene(std::span<float> rgba) const = 0;
  /// True for the built-in transform: the sRGB transfer functions of IEC 61966-2-1, channel by channel.
  [[nodiscard]] virtual bool is_srgb() const = 0;
};

/// Which OpenColorIO transform. All empty: the built-in sRGB. Empty display or view: the configuration's default.
struct ColorOptions {
  std::string config;  ///< path of a configuration (--ocio or $OCIO)
  std::string display;
  std::string view;
};

struct TextAttribute {
  std::string name;
  std::string value;
};

/// Channels of one image of a layered file, e.g. channel_names {"N.X", "N.Y", "N.Z"}. kU32 stays 32-bit unsigned.
struct Layer {
  std::vector<std::string> channel_names;
  const Image* image = nullptr;
};

struct WriteOptions {
  int jpeg_quality = 95;
  std::vector<TextAttribute> metadata;  ///< no clock time is ever written
};

class ImageModule {
 public:
  virtual ~ImageModule() = default;
  /// Any format OpenImageIO reads; 8- and 16-bit integer files come as kU8/kU16 and kDisplay, floating ones as
  /// kF16/kF32 and kSceneLinear. 1 to 4 channels, RGB(A) order. Errors: kInput, naming the file.
  [[nodiscard]] virtual Result<Image> Read(const std::string& path) = 0;
  /// The same from memory (an image embedded in a glTF). `name` is for messages.
  [[nodiscard]] virtual Result<Image> ReadMemory(std::span<const std::byte> bytes, const std::string& name) = 0;
  /// Writes one picture whole or not at all: a temporary beside `path`, then a rename. The extension chooses the
  /// format; the image's type chooses the depth and must be one that the format has (see CanWrite).
  [[nodiscard]] virtual Result<void> Write(const std::string& path, const Image& image, const WriteOptions&) = 0;
  /// Several layers as one EXR part; all of one size.
  [[nodiscard]] virtual Result<void> WriteLayers(const std::string& path, std::span<const Layer> layers,
                                                 const WriteOptions&) = 0;
  /// kUsage with the reason and the alternatives when the extension is unknown or cannot hold this; checked before
  /// anything is rendered.
  [[nodiscard]] virtual Result<void> CanWrite(const std::string& path, SampleType type, int channels) = 0;
  /// Errors: kUsage/kInput when the configuration, display or view is missing; names what there is.
  [[nodiscard]] virtual Result<std::shared_ptr<const ColorTransform>> MakeColorTransform(const ColorOptions&) = 0;
  /// "OpenImageIO 2.4.7, OpenEXR 3.1.5, OpenColorIO 2.1.2"
  [[nodiscard]] virtual std::string Versions() = 0;
};

/// Loads the module once (thread-safe) and keeps it. Errors: kFailed when the shared object is missing.
[[nodiscard]] Result<ImageModule*> LoadImageModule();

/// The built-in transform, for those who need no module.
[[nodiscard]] std::shared_ptr<const ColorTransform> SrgbTransform();

}  // namespace burin::image

// SPDX-License-Identifier: Apache-2.0
#include "core/render/colour.h"

#include "core/image/convert.h"

namespace burin::render {

image::Image ConvertEncoding(const image::Image& image, image::Encoding encoding, image::SampleType type,
                             const image::ColorTransform& transform) {
  using image::Encoding;
  if (image.encoding == encoding || image.encoding == Encoding::kData || encoding == Encoding::kData) {
    return image::ToType(image, type);
  }
  image::Image floats = image::ToType(image::ToChannels(image, 4), image::SampleType::kF32);
  if (encoding == Encoding::kDisplay) {
    image::Unpremultiply(floats.As<float>());
    transform.SceneToDisplay(floats.As<float>());
  } else {
    transform.DisplayToScene(floats.As<float>());
    image::Premultiply(floats.As<float>());
  }
  floats.encoding = encoding;
  return type == image::SampleType::kF32 ? floats : image::ToType(floats, type);
}

}  // namespace burin::render

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>

#include "core/base/error.h"
#include "core/gbuffer/attribute_renderer.h"
#include "core/image/image_module.h"

namespace burin::render {

/// Fills attributes from a picture on the device, through the job's display transform. Context's thread only.
class PictureStage {
 public:
  [[nodiscard]] static Result<std::unique_ptr<PictureStage>> Create(
      std::shared_ptr<const image::ColorTransform> transform);

  /// Colours whose encoding is not the picture's are converted: plain sRGB on the device, OpenColorIO on the CPU.
  [[nodiscard]] Result<void> Fill(const gl::Texture& picture, image::Encoding encoding,
                                  std::span<const gbuffer::Request> requests);

  [[nodiscard]] const image::ColorTransform& transform() const { return *transform_; }

 private:
  PictureStage(std::unique_ptr<gbuffer::PictureRenderer> renderer,
               std::shared_ptr<const image::ColorTransform> transform);
  [[nodiscard]] Result<const gl::Texture*> Converted(const gl::Texture& picture, image::Encoding from,
                                                     image::Encoding to);

  std::unique_ptr<gbuffer::PictureRenderer> renderer_;
  std::shared_ptr<const image::ColorTransform> transform_;
  gl::Texture converted_;
};

/// Makes `texture` one of this format and size unless it is already.
[[nodiscard]] Result<void> EnsureTexture(gl::Texture& texture, const gl::Format& format, int width, int height,
                                         std::string_view label);

}  // namespace burin::render

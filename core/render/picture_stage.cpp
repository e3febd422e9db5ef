// SPDX-License-Identifier: Apache-2.0
#include "core/render/picture_stage.h"

#include <vector>

#include "core/gl/readback.h"
#include "core/render/colour.h"

namespace burin::render {
namespace {

bool NeedsConversion(const gbuffer::Request& request, image::Encoding encoding) {
  return gbuffer::Info(request.attribute).is_color && encoding != image::Encoding::kData &&
         request.encoding != image::Encoding::kData && request.encoding != encoding;
}

}  // namespace

Result<void> EnsureTexture(gl::Texture& texture, const gl::Format& format, int width, int height,
                           std::string_view label) {
  if (texture && texture.format() == format && texture.width() == width && texture.height() == height) return {};
  texture = gl::Texture();  // its memory goes before new is asked for
  auto created = gl::Texture::Create(format, width, height, 1, label);
  if (!created) return std::unexpected(created.error());
  texture = *std::move(created);
  return {};
}

PictureStage::PictureStage(std::unique_ptr<gbuffer::PictureRenderer> renderer,
                           std::shared_ptr<const image::ColorTransform> transform)
    : renderer_(std::move(renderer)), transform_(std::move(transform)) {}

Result<std::unique_ptr<PictureStage>> PictureStage::Create(std::shared_ptr<const image::ColorTransform> transform) {
  auto renderer = gbuffer::PictureRenderer::Create();
  if (!renderer) return std::unexpected(renderer.error());
  return std::unique_ptr<PictureStage>(new PictureStage(*std::move(renderer), std::move(transform)));
}

Result<void> PictureStage::Fill(const gl::Texture& picture, image::Encoding encoding,
                                std::span<const gbuffer::Request> requests) {
  if (transform_->is_srgb()) return renderer_->Render(picture, encoding, requests);
  std::vector<gbuffer::Request> as_it_is;
  std::vector<gbuffer::Request> to_convert;
  for (const gbuffer::Request& request : requests) {
    (NeedsConversion(request, encoding) ? to_convert : as_it_is).push_back(request);
  }
  if (!as_it_is.empty()) {
    if (auto filled = renderer_->Render(picture, encoding, as_it_is); !filled) return filled;
  }
  if (to_convert.empty()) return {};
  // There are two encodings of colour, so all of these want the same one.
  const image::Encoding wanted = to_convert.front().encoding;
  auto converted = Converted(picture, encoding, wanted);
  if (!converted) return std::unexpected(converted.error());
  return renderer_->Render(**converted, wanted, to_convert);
}

Result<const gl::Texture*> PictureStage::Converted(const gl::Texture& picture, image::Encoding from,
                                                   image::Encoding to) {
  const image::Image pixels = gl::Read(picture, image::SampleType::kF32, 4, from);
  const image::Image result = ConvertEncoding(pixels, to, image::SampleType::kF32, *transform_);
  const gl::Format format = gl::PlainFormat(gl::Numeric::kFloat, 32, 4);
  if (auto good = EnsureTexture(converted_, format, picture.width(), picture.height(), "converted picture"); !good) {
    return std::unexpected(good.error());
  }
  converted_.Upload(result);
  return &converted_;
}

}  // namespace burin::render

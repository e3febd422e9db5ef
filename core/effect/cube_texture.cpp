// SPDX-License-Identifier: Apache-2.0
#include "core/effect/cube_texture.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "core/gl/texture.h"
#include "core/image/cube_layout.h"

namespace burin::effect {
namespace {

/// Turns a square of a picture by half a turn.
void Turn(const image::FacePlace& place, int size, image::Image& picture) {
  const std::size_t pixel = picture.RowBytes() / static_cast<std::size_t>(picture.width);
  const auto at = [&](int x, int y) {
    return picture.pixels.begin() +
           static_cast<std::ptrdiff_t>(static_cast<std::size_t>(place.row * size + y) * picture.RowBytes() +
                                       static_cast<std::size_t>(place.column * size + x) * pixel);
  };
  for (int i = 0; i < size * size / 2; ++i) {
    const auto from = at(i % size, i / size);
    std::swap_ranges(from, from + static_cast<std::ptrdiff_t>(pixel), at(size - 1 - i % size, size - 1 - i / size));
  }
}

}  // namespace

Result<gl::TextureHandle> CubeTextureOf(const image::Image& picture, const std::string& label) {
  const auto layout = image::CubeLayoutOf(picture.width, picture.height);
  if (!layout) {
    return Fail(ErrorKind::kInput,
                fmt::format("{}x{} pixels are no cube: its faces may lie in a cross (4:3, 3:4), a row or a column",
                            picture.width, picture.height));
  }
  const image::CubeGrid& grid = image::GridOf(*layout);
  const int size = picture.width / grid.columns;
  image::Image faces = picture;
  for (const image::FacePlace& place : grid.faces) {
    if (place.is_turned) Turn(place, size, faces);
  }
  auto flat = gl::Texture::Create(gl::FormatFor(faces), faces.width, faces.height, 1, label);
  if (!flat) return std::unexpected(flat.error());
  flat->Upload(faces);
  GLuint id = 0;
  glCreateTextures(GL_TEXTURE_CUBE_MAP, 1, &id);
  gl::TextureHandle cube(id);
  glObjectLabel(GL_TEXTURE, id, static_cast<GLsizei>(label.size()), label.data());
  glTextureStorage2D(id, std::bit_width(static_cast<unsigned>(size)), flat->format().internal, size, size);
  glTextureParameteriv(id, GL_TEXTURE_SWIZZLE_RGBA, flat->format().swizzle.data());
  for (GLint face = 0; face < 6; ++face) {
    const image::FacePlace& place = grid.faces[static_cast<std::size_t>(face)];
    glCopyImageSubData(flat->id(), GL_TEXTURE_2D, 0, place.column * size, place.row * size, 0, id, GL_TEXTURE_CUBE_MAP,
                       0, 0, 0, face, size, size, 1);
  }
  glGenerateTextureMipmap(id);
  return cube;
}

}  // namespace burin::effect

// SPDX-License-Identifier: Apache-2.0
#include "core/gl/buffer_texture.h"

#include <epoxy/gl.h>

#include "core/gl/buffer.h"

namespace burin::gl {

BufferTexture::BufferTexture(std::uint32_t format, std::string_view label)
    : format_(format), buffer_(CreateBuffer(label)) {
  GLuint id = 0;
  glCreateTextures(GL_TEXTURE_BUFFER, 1, &id);
  texture_ = TextureHandle(id);
}

void BufferTexture::Upload(std::span<const std::byte> bytes) {
  StreamInto(buffer_, bytes.data(), bytes.size());
  glTextureBuffer(texture_.id(), format_, buffer_.id());
}

}  // namespace burin::gl

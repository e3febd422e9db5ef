// SPDX-License-Identifier: Apache-2.0
#include "core/gl/buffer.h"

#include <epoxy/gl.h>

#include "core/gl/debug.h"

namespace burin::gl {

BufferHandle CreateBuffer(std::string_view label) {
  GLuint id = 0;
  glCreateBuffers(1, &id);
  SetLabel(GL_BUFFER, id, label);
  return BufferHandle(id);
}

void StreamInto(const BufferHandle& buffer, const void* data, std::size_t bytes) {
  glNamedBufferData(buffer.id(), static_cast<GLsizeiptr>(bytes), data, GL_STREAM_DRAW);
}

}  // namespace burin::gl

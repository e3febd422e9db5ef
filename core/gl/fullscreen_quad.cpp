// SPDX-License-Identifier: Apache-2.0
#include "core/gl/fullscreen_quad.h"

#include <epoxy/gl.h>

#include <array>

#include "core/gl/debug.h"
#include "core/gl/vertex_layout.h"

namespace burin::gl {
namespace {

struct Vertex {
  float position[4];
  float texcoord[4];
};

// A strip: top left, top right, bottom left, bottom right. Clip y grows upwards, v downwards.
constexpr std::array kVertices = {
    Vertex{{-1.0f, 1.0f, 0.0f, 1.0f}, {0.0f, 0.0f, 0.0f, 1.0f}},
    Vertex{{1.0f, 1.0f, 0.0f, 1.0f}, {1.0f, 0.0f, 0.0f, 1.0f}},
    Vertex{{-1.0f, -1.0f, 0.0f, 1.0f}, {0.0f, 1.0f, 0.0f, 1.0f}},
    Vertex{{1.0f, -1.0f, 0.0f, 1.0f}, {1.0f, 1.0f, 0.0f, 1.0f}},
};

void AddAttribute(GLuint vertex_array, int location, std::size_t offset) {
  const auto index = static_cast<GLuint>(location);
  glEnableVertexArrayAttrib(vertex_array, index);
  glVertexArrayAttribFormat(vertex_array, index, 4, GL_FLOAT, GL_FALSE, static_cast<GLuint>(offset));
  glVertexArrayAttribBinding(vertex_array, index, 0);
}

}  // namespace

Result<FullscreenQuad> FullscreenQuad::Create() {
  AssertContextThread();
  FullscreenQuad quad;
  GLuint buffer = 0;
  glCreateBuffers(1, &buffer);
  quad.vertices_ = BufferHandle(buffer);
  glNamedBufferStorage(buffer, sizeof(kVertices), kVertices.data(), 0);
  SetLabel(GL_BUFFER, buffer, "full-screen quadrilateral");

  GLuint vertex_array = 0;
  glCreateVertexArrays(1, &vertex_array);
  quad.vertex_array_ = VertexArrayHandle(vertex_array);
  glVertexArrayVertexBuffer(vertex_array, 0, buffer, 0, sizeof(Vertex));
  AddAttribute(vertex_array, kLocationPosition, offsetof(Vertex, position));
  for (int i = 0; i < 8; ++i) AddAttribute(vertex_array, kLocationTexCoord0 + i, offsetof(Vertex, texcoord));
  SetLabel(GL_VERTEX_ARRAY, vertex_array, "full-screen quadrilateral");
  return quad;
}

void FullscreenQuad::Draw() const {
  glBindVertexArray(vertex_array_.id());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, static_cast<GLsizei>(kVertices.size()));
}

}  // namespace burin::gl

// SPDX-License-Identifier: Apache-2.0
#include "core/overdraw/edge_quad_buffer.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/gl/buffer.h"

namespace burin::overdraw {
namespace {

void SetAttribute(GLuint array, GLuint location, GLint size, std::size_t offset) {
  glEnableVertexArrayAttrib(array, location);
  glVertexArrayAttribFormat(array, location, size, GL_FLOAT, GL_FALSE, static_cast<GLuint>(offset));
  glVertexArrayAttribBinding(array, location, 0);
}

}  // namespace

EdgeQuadBuffer::EdgeQuadBuffer()
    : vertices_(gl::CreateBuffer("edge quads")), indices_(gl::CreateBuffer("edge quads: indices")) {
  GLuint array = 0;
  glCreateVertexArrays(1, &array);
  vertex_array_ = gl::VertexArrayHandle(array);
  SetAttribute(array, 0, 2, offsetof(EdgeVertex, position));
  SetAttribute(array, 1, 4, offsetof(EdgeVertex, segment));
  SetAttribute(array, 2, 4, offsetof(EdgeVertex, depth));
  glVertexArrayVertexBuffer(array, 0, vertices_.id(), 0, sizeof(EdgeVertex));
  glVertexArrayElementBuffer(array, indices_.id());
}

void EdgeQuadBuffer::ReserveIndices(std::size_t quads) {
  if (quads <= indexed_quads_) return;
  indexed_quads_ = std::max(quads, 2 * indexed_quads_);
  std::vector<std::uint32_t> indices;
  indices.reserve(6 * indexed_quads_);
  for (std::size_t i = 0; i < indexed_quads_; ++i) {
    for (const std::uint32_t corner : {0u, 1u, 2u, 2u, 1u, 3u}) {
      indices.push_back(static_cast<std::uint32_t>(4 * i) + corner);
    }
  }
  glNamedBufferData(indices_.id(), static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)), indices.data(),
                    GL_STATIC_DRAW);
}

void EdgeQuadBuffer::Upload(std::span<const EdgeVertex> vertices) {
  quads_ = vertices.size() / 4;
  if (quads_ == 0) return;
  ReserveIndices(quads_);
  gl::StreamInto(vertices_, vertices.data(), vertices.size_bytes());
}

void EdgeQuadBuffer::Draw() const {
  if (quads_ == 0) return;
  glBindVertexArray(vertex_array_.id());
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(6 * quads_), GL_UNSIGNED_INT, nullptr);
  glBindVertexArray(0);
}

std::string_view EdgeQuadVertexText() {
  return R"(#version 450 core
layout(location = 0) in vec2 position;
layout(location = 1) in vec4 segment;
layout(location = 2) in vec4 depth;
flat out vec4 v_segment;
flat out vec4 v_depth;
void main() {
  gl_Position = vec4(position, 0.0, 1.0);
  v_segment = segment;
  v_depth = depth;
}
)";
}

}  // namespace burin::overdraw

// SPDX-License-Identifier: Apache-2.0
#include "core/gbuffer/mesh_store.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>
#include <span>
#include <vector>

#include "core/gl/buffer.h"
#include "core/gl/vertex_layout.h"

namespace burin::gbuffer {
namespace {

constexpr int kLocationPreviousPosition = gl::kLocationTexCoord0 + 7;

// One attribute's numbers, one after the other.
struct Stream {
  int location = 0;
  int components = 3;
  std::span<const std::byte> bytes;
};

template <class T>
void Add(std::vector<Stream>& streams, int location, const std::vector<T>& values) {
  if (values.empty()) return;
  streams.push_back({location, static_cast<int>(sizeof(T) / sizeof(float)), std::as_bytes(std::span(values))});
}

void Attach(GLuint vertex_array, GLuint buffer, std::size_t offset, int location, int components) {
  const auto index = static_cast<GLuint>(location);
  glVertexArrayVertexBuffer(vertex_array, index, buffer, static_cast<GLintptr>(offset),
                            components * static_cast<GLsizei>(sizeof(float)));
  glVertexArrayAttribFormat(vertex_array, index, components, GL_FLOAT, GL_FALSE, 0);
  glVertexArrayAttribBinding(vertex_array, index, index);
  glEnableVertexArrayAttrib(vertex_array, index);
}

std::size_t TotalBytes(std::span<const Stream> streams) {
  std::size_t total = 0;
  for (const Stream& stream : streams) total += stream.bytes.size();
  return total;
}

gl::VertexArrayHandle NewVertexArray(GLuint indices) {
  GLuint id = 0;
  glCreateVertexArrays(1, &id);
  glVertexArrayElementBuffer(id, indices);
  return gl::VertexArrayHandle(id);
}

void Fill(GLuint buffer, std::span<const Stream> streams) {
  std::size_t offset = 0;
  for (const Stream& stream : streams) {
    glNamedBufferSubData(buffer, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(stream.bytes.size()),
                         stream.bytes.data());
    offset += stream.bytes.size();
  }
}

// The attributes of `streams`, in both vertex arrays; the previous position for our own shaders only.
void AttachAll(const GpuPrimitive& primitive, GLuint buffer, std::span<const Stream> streams, bool is_deformed) {
  std::size_t offset = 0;
  for (const Stream& stream : streams) {
    const bool is_position = stream.location == gl::kLocationPosition;
    const bool is_previous = stream.location == kLocationPreviousPosition;
    Attach(primitive.vertex_array.id(), buffer, offset, stream.location, stream.components);
    if (!is_previous) Attach(primitive.effect_vertex_array.id(), buffer, offset, stream.location, stream.components);
    if (is_position && !is_deformed) {
      Attach(primitive.vertex_array.id(), buffer, offset, kLocationPreviousPosition, stream.components);
    }
    offset += stream.bytes.size();
  }
}

std::vector<Stream> ConstantStreams(const scene::Primitive& primitive) {
  std::vector<Stream> streams;
  Add(streams, gl::kLocationColor0, primitive.colors);
  Add(streams, gl::kLocationTexCoord0, primitive.texcoords[0]);
  Add(streams, gl::kLocationTexCoord0 + 1, primitive.texcoords[1]);
  return streams;
}

std::vector<Stream> ShapeStreams(const scene::Primitive& primitive, const scene::DrawItem& item) {
  std::vector<Stream> streams;
  if (item.is_deformed) {
    Add(streams, gl::kLocationPosition, item.deformed.positions);
    Add(streams, kLocationPreviousPosition, item.deformed.previous_positions);
    Add(streams, gl::kLocationNormal, item.deformed.normals);
    Add(streams, gl::kLocationTangent, item.deformed.tangents);
  } else {
    Add(streams, gl::kLocationPosition, primitive.positions);
    Add(streams, gl::kLocationNormal, primitive.normals);
    Add(streams, gl::kLocationTangent, primitive.tangents);
  }
  return streams;
}

GLenum ModeOf(scene::PrimitiveMode mode) {
  switch (mode) {
    case scene::PrimitiveMode::kPoints:
      return GL_POINTS;
    case scene::PrimitiveMode::kLines:
      return GL_LINES;
    case scene::PrimitiveMode::kTriangles:
      return GL_TRIANGLES;
  }
  return GL_TRIANGLES;
}

glm::vec3 CenterOf(const std::vector<glm::vec3>& positions) {
  if (positions.empty()) return glm::vec3(0.0f);
  glm::vec3 low = positions.front();
  glm::vec3 high = low;
  for (const glm::vec3& position : positions) {
    low = glm::min(low, position);
    high = glm::max(high, position);
  }
  return 0.5f * (low + high);
}

Result<void> Allocate(GLuint buffer, std::size_t bytes, GLenum usage, const void* data) {
  glNamedBufferData(buffer, static_cast<GLsizeiptr>(bytes), data, usage);
  if (glGetError() == GL_OUT_OF_MEMORY) {
    return Fail(ErrorKind::kFailed, fmt::format("no memory on the device for {} bytes of geometry", bytes));
  }
  return {};
}

Result<GpuPrimitive> Upload(const scene::Primitive& source, const scene::DrawItem& item) {
  GpuPrimitive primitive;
  primitive.mode = ModeOf(source.mode);
  primitive.index_count = static_cast<int>(source.indices.size());
  primitive.indices = gl::CreateBuffer("indices");
  primitive.vertices = gl::CreateBuffer("vertices");
  primitive.vertex_array = NewVertexArray(primitive.indices.id());
  primitive.effect_vertex_array = NewVertexArray(primitive.indices.id());
  primitive.has_texcoords = !source.texcoords[0].empty();

  const auto indices = std::as_bytes(std::span(source.indices));
  if (auto done = Allocate(primitive.indices.id(), indices.size(), GL_STATIC_DRAW, indices.data()); !done) {
    return std::unexpected(done.error());
  }
  std::vector<Stream> streams = ConstantStreams(source);
  const std::vector<Stream> shape = ShapeStreams(source, item);
  if (!item.is_deformed) streams.insert(streams.end(), shape.begin(), shape.end());
  if (auto done = Allocate(primitive.vertices.id(), TotalBytes(streams), GL_STATIC_DRAW, nullptr); !done) {
    return std::unexpected(done.error());
  }
  Fill(primitive.vertices.id(), streams);
  AttachAll(primitive, primitive.vertices.id(), streams, item.is_deformed);
  if (item.is_deformed) {
    primitive.deformed = gl::CreateBuffer("deformed vertices");
    AttachAll(primitive, primitive.deformed.id(), shape, true);
  } else {
    primitive.center = CenterOf(source.positions);
  }
  const auto has = [&](int location) { return std::ranges::find(shape, location, &Stream::location) != shape.end(); };
  primitive.has_normals = has(gl::kLocationNormal);
  primitive.has_tangents = has(gl::kLocationTangent);
  return primitive;
}

}  // namespace

Result<const GpuPrimitive*> MeshStore::Prepare(const scene::DrawItem& item, bool wants_center) {
  const scene::Primitive& source =
      scene_->meshes.at(static_cast<std::size_t>(item.mesh)).primitives.at(static_cast<std::size_t>(item.primitive));
  const std::tuple key(item.is_deformed, item.is_deformed ? item.node : item.mesh, item.primitive);
  auto found = primitives_.find(key);
  if (found == primitives_.end()) {
    Result<GpuPrimitive> uploaded = Upload(source, item);
    if (!uploaded) return std::unexpected(uploaded.error());
    found = primitives_.emplace(key, std::move(*uploaded)).first;
  }
  GpuPrimitive& primitive = found->second;
  if (item.is_deformed) {
    const std::vector<Stream> shape = ShapeStreams(source, item);
    // A fresh store every frame, so that the driver need not wait for the frame before.
    if (auto done = Allocate(primitive.deformed.id(), TotalBytes(shape), GL_STREAM_DRAW, nullptr); !done) {
      return std::unexpected(done.error());
    }
    Fill(primitive.deformed.id(), shape);
    if (wants_center) primitive.center = CenterOf(item.deformed.positions);
  }
  return &primitive;
}

void SetMissingAttributes() {
  for (GLuint location = 1; location < 16; ++location) glVertexAttrib4f(location, 0.0f, 0.0f, 0.0f, 0.0f);
  glVertexAttrib4f(gl::kLocationColor0, 1.0f, 1.0f, 1.0f, 1.0f);
  glVertexAttrib4f(gl::kLocationColor1, 1.0f, 1.0f, 1.0f, 1.0f);
}

}  // namespace burin::gbuffer

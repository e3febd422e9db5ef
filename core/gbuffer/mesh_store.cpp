// SPDX-License-Identifier: Apache-2.0
#include "core/gbuffer/mesh_store.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <span>
#include <vector>

#include "core/gl/buffer.h"
#include "core/gl/vertex_layout.h"
#include "core/scene/item_geometry.h"

namespace burin::gbuffer {
namespace {

// What our own shaders read beside what effects may.
constexpr int kLocationPatchUv = gl::kLocationTexCoord0 + 5;
constexpr int kLocationPatchId = gl::kLocationTexCoord0 + 6;
constexpr int kLocationPreviousPosition = gl::kLocationTexCoord0 + 7;

// One attribute's numbers, one after the other.
struct Stream {
  int location = 0;
  int components = 3;
  std::span<const std::byte> bytes;
};

template <class T>
void Add(std::vector<Stream>& streams, int location, std::span<const T> values) {
  if (values.empty()) return;
  streams.push_back({location, static_cast<int>(sizeof(T) / sizeof(float)), std::as_bytes(values)});
}

void Attach(GLuint vertex_array, GLuint buffer, std::size_t offset, int location, int components) {
  const auto index = static_cast<GLuint>(location);
  glVertexArrayVertexBuffer(vertex_array, index, buffer, static_cast<GLintptr>(offset),
                            components * static_cast<GLsizei>(sizeof(float)));
  if (location == kLocationPatchId) {
    glVertexArrayAttribIFormat(vertex_array, index, components, GL_UNSIGNED_INT, 0);
  } else {
    glVertexArrayAttribFormat(vertex_array, index, components, GL_FLOAT, GL_FALSE, 0);
  }
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

// The attributes of `streams`, in both vertex arrays; what effects know nothing of for our own shaders only. Without
// previous positions among them, those are the positions.
void AttachAll(const GpuPrimitive& primitive, GLuint buffer, std::span<const Stream> streams) {
  const bool has_previous = std::ranges::find(streams, kLocationPreviousPosition, &Stream::location) != streams.end();
  std::size_t offset = 0;
  for (const Stream& stream : streams) {
    const bool is_position = stream.location == gl::kLocationPosition;
    const bool is_ours = stream.location >= kLocationPatchUv;
    Attach(primitive.vertex_array.id(), buffer, offset, stream.location, stream.components);
    if (!is_ours) Attach(primitive.effect_vertex_array.id(), buffer, offset, stream.location, stream.components);
    if (is_position && !has_previous) {
      Attach(primitive.vertex_array.id(), buffer, offset, kLocationPreviousPosition, stream.components);
    }
    offset += stream.bytes.size();
  }
}

std::vector<Stream> ConstantStreams(const scene::ItemGeometry& geometry) {
  std::vector<Stream> streams;
  Add(streams, gl::kLocationColor0, geometry.colors);
  Add(streams, gl::kLocationTexCoord0, geometry.texcoords[0]);
  Add(streams, gl::kLocationTexCoord0 + 1, geometry.texcoords[1]);
  return streams;
}

std::vector<Stream> ShapeStreams(const scene::ItemGeometry& geometry) {
  std::vector<Stream> streams;
  Add(streams, gl::kLocationPosition, geometry.positions);
  Add(streams, kLocationPreviousPosition, geometry.previous_positions);
  Add(streams, gl::kLocationNormal, geometry.normals);
  Add(streams, gl::kLocationTangent, geometry.tangents);
  return streams;
}

std::vector<Stream> SurfaceStreams(const scene::ItemGeometry& geometry) {
  std::vector<Stream> streams = ConstantStreams(geometry);
  const std::vector<Stream> shape = ShapeStreams(geometry);
  streams.insert(streams.end(), shape.begin(), shape.end());
  Add(streams, kLocationPatchUv, geometry.patch_uv);
  Add(streams, kLocationPatchId, geometry.patch_ids);
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

glm::vec3 CenterOf(std::span<const glm::vec3> positions) {
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

GpuPrimitive NewPrimitive(scene::PrimitiveMode mode) {
  GpuPrimitive primitive;
  primitive.mode = ModeOf(mode);
  primitive.indices = gl::CreateBuffer("indices");
  primitive.vertices = gl::CreateBuffer("vertices");
  primitive.vertex_array = NewVertexArray(primitive.indices.id());
  primitive.effect_vertex_array = NewVertexArray(primitive.indices.id());
  return primitive;
}

void NoteWhatIsThere(const scene::ItemGeometry& geometry, GpuPrimitive& primitive) {
  primitive.index_count = static_cast<int>(geometry.indices.size());
  primitive.has_normals = !geometry.normals.empty();
  primitive.has_tangents = !geometry.tangents.empty();
  primitive.has_texcoords = !geometry.texcoords[0].empty();
  primitive.has_patches = !geometry.patch_ids.empty();
}

// Effects look textures up by the first coordinates alone: those are the base colour's, as its material places it.
Result<void> PlaceTexture(const scene::TextureUse& use, const scene::ItemGeometry& geometry, GLenum usage,
                          GpuPrimitive& primitive) {
  const auto& from = geometry.texcoords[static_cast<std::size_t>(use.texcoord)];
  if (!use || from.empty() || (use.texcoord == 0 && use.uv_transform == glm::mat3(1.0f))) return {};
  std::vector<glm::vec2> placed;
  placed.reserve(from.size());
  for (const glm::vec2& uv : from) placed.emplace_back(use.uv_transform * glm::vec3(uv, 1.0f));
  if (!primitive.effect_texcoords) primitive.effect_texcoords = gl::CreateBuffer("texture coordinates for effects");
  const GLuint buffer = primitive.effect_texcoords.id();
  if (auto done = Allocate(buffer, placed.size() * sizeof(glm::vec2), usage, placed.data()); !done) return done;
  Attach(primitive.effect_vertex_array.id(), buffer, 0, gl::kLocationTexCoord0, 2);
  return {};
}

Result<GpuPrimitive> Upload(const scene::ItemGeometry& geometry, const scene::TextureUse& base_color,
                            bool is_deformed) {
  GpuPrimitive primitive = NewPrimitive(geometry.mode);
  NoteWhatIsThere(geometry, primitive);
  const auto indices = std::as_bytes(geometry.indices);
  if (auto done = Allocate(primitive.indices.id(), indices.size(), GL_STATIC_DRAW, indices.data()); !done) {
    return std::unexpected(done.error());
  }
  std::vector<Stream> streams = ConstantStreams(geometry);
  const std::vector<Stream> shape = ShapeStreams(geometry);
  if (!is_deformed) streams.insert(streams.end(), shape.begin(), shape.end());
  if (auto done = Allocate(primitive.vertices.id(), TotalBytes(streams), GL_STATIC_DRAW, nullptr); !done) {
    return std::unexpected(done.error());
  }
  Fill(primitive.vertices.id(), streams);
  AttachAll(primitive, primitive.vertices.id(), streams);
  if (is_deformed) {
    primitive.deformed = gl::CreateBuffer("deformed vertices");
    AttachAll(primitive, primitive.deformed.id(), shape);
  } else {
    primitive.center = CenterOf(geometry.positions);
  }
  if (auto done = PlaceTexture(base_color, geometry, GL_STATIC_DRAW, primitive); !done)
    return std::unexpected(done.error());
  return primitive;
}

// All of this frame's triangles.
Result<void> Replace(const scene::ItemGeometry& geometry, const scene::TextureUse& base_color,
                     GpuPrimitive& primitive) {
  NoteWhatIsThere(geometry, primitive);
  const auto indices = std::as_bytes(geometry.indices);
  if (auto done = Allocate(primitive.indices.id(), indices.size(), GL_STREAM_DRAW, indices.data()); !done) return done;
  const std::vector<Stream> streams = SurfaceStreams(geometry);
  if (auto done = Allocate(primitive.vertices.id(), TotalBytes(streams), GL_STREAM_DRAW, nullptr); !done) return done;
  Fill(primitive.vertices.id(), streams);
  AttachAll(primitive, primitive.vertices.id(), streams);
  primitive.center = CenterOf(geometry.positions);
  return PlaceTexture(base_color, geometry, GL_STREAM_DRAW, primitive);
}

const scene::TextureUse& BaseColorOf(const scene::Scene& scene, const scene::DrawItem& item) {
  static const scene::TextureUse kNone;
  return item.material_id == 0 ? kNone : scene.materials.at(item.material_id - 1).base_color_texture;
}

}  // namespace

Result<const GpuPrimitive*> MeshStore::Prepare(const scene::DrawItem& item, bool wants_center) {
  if (item.surface) return PrepareSurface(item);
  const scene::ItemGeometry geometry = scene::GeometryOf(*scene_, item);
  const std::tuple key(item.is_deformed, item.is_deformed ? item.node : item.mesh, item.primitive);
  auto found = primitives_.find(key);
  if (found == primitives_.end()) {
    Result<GpuPrimitive> uploaded = Upload(geometry, BaseColorOf(*scene_, item), item.is_deformed);
    if (!uploaded) return std::unexpected(uploaded.error());
    found = primitives_.emplace(key, std::move(*uploaded)).first;
  }
  GpuPrimitive& primitive = found->second;
  if (item.is_deformed) {
    const std::vector<Stream> shape = ShapeStreams(geometry);
    // A fresh store every frame, so that the driver need not wait for the frame before.
    if (auto done = Allocate(primitive.deformed.id(), TotalBytes(shape), GL_STREAM_DRAW, nullptr); !done) {
      return std::unexpected(done.error());
    }
    Fill(primitive.deformed.id(), shape);
    if (wants_center) primitive.center = CenterOf(geometry.positions);
  }
  return &primitive;
}

Result<const GpuPrimitive*> MeshStore::PrepareSurface(const scene::DrawItem& item) {
  auto found = surfaces_.find({item.node, item.primitive});
  if (found == surfaces_.end()) {
    Surface surface{.primitive = NewPrimitive(scene::PrimitiveMode::kTriangles), .shown = nullptr};
    found = surfaces_.emplace(std::pair(item.node, item.primitive), std::move(surface)).first;
  }
  Surface& surface = found->second;
  if (surface.shown != item.surface) {
    surface.shown = nullptr;
    if (auto done = Replace(scene::GeometryOf(*scene_, item), BaseColorOf(*scene_, item), surface.primitive); !done) {
      return std::unexpected(done.error());
    }
    surface.shown = item.surface;
  }
  return &surface.primitive;
}

void SetMissingAttributes() {
  for (GLuint location = 1; location < 16; ++location) glVertexAttrib4f(location, 0.0f, 0.0f, 0.0f, 0.0f);
  glVertexAttrib4f(gl::kLocationColor0, 1.0f, 1.0f, 1.0f, 1.0f);
  glVertexAttrib4f(gl::kLocationColor1, 1.0f, 1.0f, 1.0f, 1.0f);
}

}  // namespace burin::gbuffer

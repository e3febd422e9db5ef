// SPDX-License-Identifier: Apache-2.0
#include "core/gl/readback.h"

#include <epoxy/gl.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "core/gl/debug.h"
#include "core/gl/pixel_transfer.h"

namespace burin::gl {
namespace {

constexpr GLuint64 kWaitNanoseconds = 1'000'000'000;

image::Image EmptyImage(const Texture& texture, image::SampleType type, int channels, image::Encoding encoding) {
  image::Image image;
  image.width = texture.width();
  image.height = texture.height();
  image.channels = channels;
  image.type = type;
  image.encoding = encoding;
  return image;
}

std::size_t Bytes(const image::Image& image) { return image.RowBytes() * static_cast<std::size_t>(image.height); }

GLenum ReadFormat(const Texture& texture, image::SampleType type, int channels) {
  if (texture.format().internal == GL_DEPTH32F_STENCIL8) return GL_DEPTH_COMPONENT;
  return TransferFormat(type, channels);
}

void ReadInto(const Texture& texture, const image::Image& image, void* destination) {
  glGetTextureImage(texture.id(), 0, ReadFormat(texture, image.type, image.channels), TransferType(image.type),
                    static_cast<GLsizei>(Bytes(image)), destination);
}

}  // namespace

struct ReadbackRing::Slot {
  BufferHandle buffer;
  std::size_t capacity = 0;
  GLsync fence = nullptr;
  image::Image image;  ///< without pixels

  Slot() = default;
  Slot(const Slot&) = delete;
  Slot& operator=(const Slot&) = delete;
  ~Slot() {
    if (fence != nullptr) glDeleteSync(fence);
  }

  void Reserve(std::size_t bytes) {
    if (bytes <= capacity) return;
    GLuint id = 0;
    glCreateBuffers(1, &id);
    buffer = BufferHandle(id);
    glNamedBufferStorage(id, static_cast<GLsizeiptr>(bytes), nullptr, GL_MAP_READ_BIT | GL_CLIENT_STORAGE_BIT);
    SetLabel(GL_BUFFER, id, "read-back");
    capacity = bytes;
  }

  void Wait() {
    while (glClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, kWaitNanoseconds) == GL_TIMEOUT_EXPIRED) {
    }
    glDeleteSync(fence);
    fence = nullptr;
  }
};

ReadbackRing::ReadbackRing(int depth) : depth_(depth) {
  for (int i = 0; i < depth_; ++i) free_.push_back(std::make_unique<Slot>());
}

ReadbackRing::~ReadbackRing() = default;

bool ReadbackRing::full() const { return free_.empty(); }

bool ReadbackRing::empty() const { return busy_.empty(); }

void ReadbackRing::Start(const Texture& texture, image::SampleType type, int channels, image::Encoding encoding) {
  AssertContextThread();
  if (free_.empty()) {
    std::fprintf(stderr, "burin: ReadbackRing::Start on a full ring of %d\n", depth_);
    std::abort();
  }
  std::unique_ptr<Slot> slot = std::move(free_.back());
  free_.pop_back();
  slot->image = EmptyImage(texture, type, channels, encoding);
  slot->Reserve(Bytes(slot->image));
  glBindBuffer(GL_PIXEL_PACK_BUFFER, slot->buffer.id());
  ReadInto(texture, slot->image, nullptr);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  slot->fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  glFlush();
  busy_.push_back(std::move(slot));
}

image::Image ReadbackRing::Finish() {
  AssertContextThread();
  if (busy_.empty()) {
    std::fprintf(stderr, "burin: ReadbackRing::Finish on an empty ring\n");
    std::abort();
  }
  std::unique_ptr<Slot> slot = std::move(busy_.front());
  busy_.pop_front();
  slot->Wait();
  image::Image image = std::move(slot->image);
  const std::size_t bytes = Bytes(image);
  const void* mapped = glMapNamedBufferRange(slot->buffer.id(), 0, static_cast<GLsizeiptr>(bytes), GL_MAP_READ_BIT);
  if (mapped != nullptr) {
    const auto* first = static_cast<const std::byte*>(mapped);
    image.pixels.assign(first, first + bytes);
  } else {
    image.pixels.resize(bytes);
  }
  glUnmapNamedBuffer(slot->buffer.id());
  free_.push_back(std::move(slot));
  return image;
}

image::Image Read(const Texture& texture, image::SampleType type, int channels, image::Encoding encoding) {
  AssertContextThread();
  image::Image image = EmptyImage(texture, type, channels, encoding);
  image.pixels.resize(Bytes(image));
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  ReadInto(texture, image, image.pixels.data());
  return image;
}

}  // namespace burin::gl

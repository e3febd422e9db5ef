// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <utility>

namespace burin::gl {

/// A move-only GL object name. `Traits::Delete(std::uint32_t)` frees it; the context outlives every handle.
template <class Traits>
class Handle {
 public:
  Handle() = default;
  explicit Handle(std::uint32_t id) : id_(id) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  Handle& operator=(Handle&& other) noexcept {
    if (this != &other) {
      Reset();
      id_ = std::exchange(other.id_, 0);
    }
    return *this;
  }
  ~Handle() { Reset(); }

  [[nodiscard]] std::uint32_t id() const { return id_; }
  explicit operator bool() const { return id_ != 0; }

 private:
  void Reset() {
    if (id_ != 0) Traits::Delete(std::exchange(id_, 0));
  }
  std::uint32_t id_ = 0;
};

struct TextureTraits {
  static void Delete(std::uint32_t id);
};
struct SamplerTraits {
  static void Delete(std::uint32_t id);
};
struct BufferTraits {
  static void Delete(std::uint32_t id);
};
struct FramebufferTraits {
  static void Delete(std::uint32_t id);
};
struct VertexArrayTraits {
  static void Delete(std::uint32_t id);
};
struct ProgramTraits {
  static void Delete(std::uint32_t id);
};

using TextureHandle = Handle<TextureTraits>;
using SamplerHandle = Handle<SamplerTraits>;
using BufferHandle = Handle<BufferTraits>;
using FramebufferHandle = Handle<FramebufferTraits>;
using VertexArrayHandle = Handle<VertexArrayTraits>;
using ProgramHandle = Handle<ProgramTraits>;

}  // namespace burin::gl

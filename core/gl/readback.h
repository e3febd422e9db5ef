// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <vector>

#include "core/base/error.h"
#include "core/gl/handle.h"
#include "core/gl/texture.h"
#include "core/image/image.h"

namespace burin::gl {

/// Asynchronous read-back through a ring of pixel buffers: Start() queues a copy and returns at once, Finish() waits
/// for the oldest. Used on the context's thread only.
class ReadbackRing {
 public:
  /// `depth`: how many copies may be under way (2 or 3).
  explicit ReadbackRing(int depth);
  ~ReadbackRing();
  [[nodiscard]] bool full() const;
  [[nodiscard]] bool empty() const;
  /// Level 0 of `texture` as `channels` (1..4) of `type`; kU32 is for unsigned integer textures only, kU8/kU16 for
  /// unorm, floats for any. The raw components are read: swizzles don't apply.
  void Start(const Texture& texture, image::SampleType type, int channels, image::Encoding encoding);
  /// The oldest read-back, in the order of Start().
  [[nodiscard]] image::Image Finish();

 private:
  struct Slot;
  std::vector<std::unique_ptr<Slot>> free_;
  std::deque<std::unique_ptr<Slot>> busy_;
  int depth_;
};

/// Reads at once.
[[nodiscard]] image::Image Read(const Texture& texture, image::SampleType type, int channels, image::Encoding encoding);

}  // namespace burin::gl

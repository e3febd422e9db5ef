// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/gl/egl_device.h"

namespace burin::gl {

/// A display and a GL 4.5 core context on it, current on this thread from Open() to the destructor.
class EglContext {
 public:
  EglContext() = default;
  EglContext(EglContext&& other) noexcept;
  EglContext& operator=(EglContext&& other) noexcept;
  ~EglContext();

  /// `device` without a handle: the surfaceless platform. Errors: kDevice, only the reason ("eglInitialize failed
  /// ...").
  [[nodiscard]] static Result<EglContext> Open(const EglDevice& device, bool debug);

 private:
  void Close();
  void* display_ = nullptr;
  void* context_ = nullptr;
};

}  // namespace burin::gl

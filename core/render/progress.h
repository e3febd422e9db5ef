// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/base/error.h"

namespace burin::render {

/// What a job tells while it runs. Called from several threads; implementations lock.
class Progress {
 public:
  virtual ~Progress() = default;
  virtual void DeviceChosen(const std::string& renderer) = 0;  ///< GL_RENDERER
  virtual void Started(long frames_total) = 0;                 ///< -1: not known (a stream)
  virtual void FrameDone(long frame, const std::string& path) = 0;
  /// With --keep-going: the frame is left out, the job goes on.
  virtual void FrameFailed(long frame, const std::string& message) = 0;
  virtual void Warning(const std::string& message) = 0;
  virtual void Info(const std::string& message) = 0;  ///< shown with -v
  /// A compiler's messages about an effect, formatted, with their newlines.
  virtual void Diagnostics(const std::string& text) = 0;
  /// Whether Diagnostics() takes ANSI colours.
  [[nodiscard]] virtual bool wants_color() const = 0;
  /// Exactly once, last.
  virtual void Finished(const Result<void>& result, long frames_done) = 0;
};

}  // namespace burin::render

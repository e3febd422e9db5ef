// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace burin::render {

/// What a job tells while it runs. Called from several threads; implementations lock.
class Progress {
 public:
  virtual ~Progress() = default;
  virtual void Started(long frames_total) = 0;                 ///< -1: not known (a stream)
  virtual void FrameDone(long frame, const std::string& path) = 0;
  virtual void Warning(const std::string& message) = 0;
  virtual void Info(const std::string& message) = 0;           ///< shown with -v
  /// Exactly once, last.
  virtual void Finished(bool succeeded, long frames_done) = 0;
};

}  // namespace burin::render

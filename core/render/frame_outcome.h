// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <mutex>
#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/render/progress.h"

namespace burin::render {

/// How a job's frames came out, told by all stages. The first error wins.
class FrameOutcome {
 public:
  FrameOutcome(bool keep_going, Progress& progress) : keep_going_(keep_going), progress_(progress) {}

  void Done(long frame, const std::string& path);
  /// A frame that failed alone. True when the job goes on without it.
  [[nodiscard]] bool Failed(long frame, const Error& error);
  /// An error after which nothing can follow.
  void Broke(const Error& error);

  [[nodiscard]] bool broken() const { return broken_; }
  [[nodiscard]] long done() const { return done_; }
  [[nodiscard]] Result<void> result() const;

 private:
  const bool keep_going_;
  Progress& progress_;
  std::atomic<bool> broken_{false};
  std::atomic<long> done_{0};
  mutable std::mutex mutex_;
  std::optional<Error> first_;
  long failed_ = 0;
};

}  // namespace burin::render

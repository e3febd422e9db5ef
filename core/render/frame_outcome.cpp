// SPDX-License-Identifier: Apache-2.0
#include "core/render/frame_outcome.h"

#include <fmt/format.h>

namespace burin::render {

void FrameOutcome::Done(long frame, const std::string& path) {
  ++done_;
  progress_.FrameDone(frame, path);
}

bool FrameOutcome::Failed(long frame, const Error& error) {
  if (!keep_going_) {
    Broke(error);
    return false;
  }
  {
    const std::lock_guard lock(mutex_);
    ++failed_;
  }
  progress_.FrameFailed(frame, error.message);
  return true;
}

void FrameOutcome::Broke(const Error& error) {
  const std::lock_guard lock(mutex_);
  if (!first_) first_ = error;
  broken_ = true;
}

Result<void> FrameOutcome::result() const {
  const std::lock_guard lock(mutex_);
  if (first_) return std::unexpected(*first_);
  if (failed_ > 0) {
    return Fail(ErrorKind::kFailed, fmt::format("{} frame{} failed", failed_, failed_ == 1 ? "" : "s"));
  }
  return {};
}

}  // namespace burin::render

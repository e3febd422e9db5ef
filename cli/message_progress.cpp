// SPDX-License-Identifier: Apache-2.0
#include "cli/message_progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include "cli/console.h"

namespace burin::cli {

MessageProgress::MessageProgress(const Settings& settings)
    : level_(settings.log_level), descriptor_(settings.progress_descriptor) {}

void MessageProgress::DeviceChosen(const std::string& renderer) {
  Info(fmt::format("device: {}", renderer));
  const std::lock_guard lock(mutex_);
  OnDevice(renderer);
}

void MessageProgress::Started(long frames_total) {
  const std::lock_guard lock(mutex_);
  total_ = frames_total;
  OnStarted();
}

void MessageProgress::FrameDone(long frame, const std::string& path) {
  const std::lock_guard lock(mutex_);
  ++done_;
  if (!finished_) OnFrame(frame, path);
}

void MessageProgress::FrameFailed(long frame, const std::string& message) {
  const std::lock_guard lock(mutex_);
  if (!OnMessage("error", message)) PrintError({ErrorKind::kFailed, fmt::format("frame {}: {}", frame, message)});
  OnFrameFailed(frame, message);
}

void MessageProgress::Warning(const std::string& message) {
  const std::lock_guard lock(mutex_);
  if (level_ >= LogLevel::kWarning && !OnMessage("warning", message)) PrintWarning(message);
}

void MessageProgress::Info(const std::string& message) {
  const std::lock_guard lock(mutex_);
  if (level_ >= LogLevel::kInfo && !OnMessage("info", message)) {
    WriteText(STDERR_FILENO, fmt::format("burin: {}\n", message));
  }
}

void MessageProgress::Diagnostics(const std::string& text) {
  const std::lock_guard lock(mutex_);
  OnMessage("diagnostics", text);
  WriteText(STDERR_FILENO, text);
}

bool MessageProgress::wants_color() const { return UsesColor(STDERR_FILENO); }

void MessageProgress::Finished(const Result<void>& result, long frames_done) {
  const std::lock_guard lock(mutex_);
  if (finished_) return;
  finished_ = true;
  OnFinished(result, frames_done);
}

void MessageProgress::Write(const std::string& text) const { WriteText(descriptor_, text); }

}  // namespace burin::cli

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mutex>
#include <string>

#include "cli/settings.h"
#include "core/render/progress.h"

namespace burin::cli {

/// What all progress modes share: messages on stderr by log level, one lock, a single last event. Modes implement the
/// On...() functions, which are called with the lock held; this class alone is --progress none.
class MessageProgress : public render::Progress {
 public:
  explicit MessageProgress(const Settings& settings);

  void DeviceChosen(const std::string& renderer) final;
  void Started(long frames_total) final;
  void FrameDone(long frame, const std::string& path) final;
  void FrameFailed(long frame, const std::string& message) final;
  void Warning(const std::string& message) final;
  void Info(const std::string& message) final;
  void Diagnostics(const std::string& text) final;
  [[nodiscard]] bool wants_color() const final;
  void Finished(const Result<void>& result, long frames_done) final;

 protected:
  virtual void OnDevice(const std::string&) {}
  virtual void OnStarted() {}
  virtual void OnFrame(long /*frame*/, const std::string& /*path*/) {}
  virtual void OnFrameFailed(long /*frame*/, const std::string& /*message*/) {}
  /// A message of any level goes out next: a bar makes room. True when the mode shows it itself.
  virtual bool OnMessage(const char* /*level*/, const std::string& /*text*/) { return false; }
  virtual void OnFinished(const Result<void>&, long /*frames_done*/) {}

  void Write(const std::string& text) const;           ///< to --progress-fd
  [[nodiscard]] long total() const { return total_; }  ///< -1: not known
  [[nodiscard]] long done() const { return done_; }

 private:
  std::mutex mutex_;
  LogLevel level_;
  int descriptor_;
  long total_ = -1;
  long done_ = 0;
  bool finished_ = false;
};

}  // namespace burin::cli

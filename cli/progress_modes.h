// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <string>

#include "cli/message_progress.h"

namespace burin::cli {

/// One line on a terminal, redrawn at most ten times a second: a bar, the frames, their rate and the time left.
class BarProgress final : public MessageProgress {
 public:
  using MessageProgress::MessageProgress;

 protected:
  void OnStarted() override;
  void OnFrame(long frame, const std::string& path) override;
  bool OnMessage(const char* level, const std::string& text) override;
  void OnFinished(const Result<void>& result, long frames_done) override;

 private:
  using Clock = std::chrono::steady_clock;
  void Draw();
  Clock::time_point started_;
  Clock::time_point drawn_;
};

/// A line a frame, without carriage returns, for logs.
class PlainProgress final : public MessageProgress {
 public:
  using MessageProgress::MessageProgress;

 protected:
  void OnFrame(long frame, const std::string& path) override;
};

/// One JSON object a line: device, start, frame, frame_failed, and exactly one end, which is last.
class JsonProgress final : public MessageProgress {
 public:
  using MessageProgress::MessageProgress;

 protected:
  void OnDevice(const std::string& renderer) override;
  void OnStarted() override;
  void OnFrame(long frame, const std::string& path) override;
  void OnFrameFailed(long frame, const std::string& message) override;
  bool OnMessage(const char* level, const std::string& text) override;
  void OnFinished(const Result<void>& result, long frames_done) override;

 private:
  std::string renderer_;
};

/// The lines that Open Job Description sessions read from a task: openjd_progress, openjd_status, openjd_fail.
class OpenJdProgress final : public MessageProgress {
 public:
  using MessageProgress::MessageProgress;

 protected:
  void OnStarted() override;
  void OnFrame(long frame, const std::string& path) override;
  void OnFinished(const Result<void>& result, long frames_done) override;
};

}  // namespace burin::cli

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <thread>

namespace burin::cli {

/// Turns SIGINT, SIGTERM and SIGHUP into a request to stop. Made on the main thread before any other thread starts: the
/// signals are blocked in all of them and one thread waits for them. It sets `stop()`; the job then ends by itself. If
/// it has not after a second (blocked in a read, deep in a driver), or at a second signal, the thread removes the
/// temporary files, calls `last_words` and ends the process with 128 + the signal's number.
class SignalGuard {
 public:
  explicit SignalGuard(std::function<void()> last_words);
  ~SignalGuard();
  SignalGuard(const SignalGuard&) = delete;
  SignalGuard& operator=(const SignalGuard&) = delete;

  [[nodiscard]] const std::atomic<bool>& stop() const { return stop_; }
  /// The signal that came, 0: none.
  [[nodiscard]] int signal() const { return signal_; }

 private:
  void Wait();

  std::function<void()> last_words_;
  std::atomic<bool> stop_{false};
  std::atomic<int> signal_{0};
  std::atomic<bool> finished_{false};
  std::thread thread_;
};

}  // namespace burin::cli

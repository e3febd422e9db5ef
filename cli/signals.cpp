// SPDX-License-Identifier: Apache-2.0
#include "cli/signals.h"

#include <pthread.h>
#include <unistd.h>

#include <csignal>
#include <ctime>
#include <utility>

#include "core/base/temporaries.h"

namespace burin::cli {
namespace {

/// The guard's own way out of its wait; never sent from outside in practice, and harmless then.
constexpr int kWake = SIGUSR2;
constexpr timespec kGrace{1, 0};
constexpr timespec kLastWords{0, 100'000'000};

sigset_t StopSignals() {
  sigset_t set;
  sigemptyset(&set);
  for (const int number : {SIGINT, SIGTERM, SIGHUP, kWake}) sigaddset(&set, number);
  return set;
}

}  // namespace

SignalGuard::SignalGuard(std::function<void()> last_words) : last_words_(std::move(last_words)) {
  sigset_t set = StopSignals();
  // nohup(1) and a shell's background jobs ignore some of these; blocking them would undo that.
  for (const int number : {SIGINT, SIGHUP}) {
    struct sigaction current {};
    if (sigaction(number, nullptr, &current) == 0 && current.sa_handler == SIG_IGN) sigdelset(&set, number);
  }
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  thread_ = std::thread([this] { Wait(); });
}

SignalGuard::~SignalGuard() {
  finished_ = true;
  pthread_kill(thread_.native_handle(), kWake);
  thread_.join();
}

void SignalGuard::Wait() {
  const sigset_t set = StopSignals();
  int number = 0;
  do {
    if (sigwait(&set, &number) != 0) return;
    if (finished_) return;
  } while (number == kWake);
  signal_ = number;
  stop_ = true;
  const int second = sigtimedwait(&set, nullptr, &kGrace);
  if (finished_ || second == kWake) return;
  base::RemoveTemporaries();
  // On a thread of their own: a thread that hangs may hold a lock that they need.
  std::thread(last_words_).detach();
  nanosleep(&kLastWords, nullptr);
  base::RemoveTemporaries();  // whatever was begun in between
  _exit(128 + number);
}

}  // namespace burin::cli

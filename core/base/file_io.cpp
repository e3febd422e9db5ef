// SPDX-License-Identifier: Apache-2.0
#include "core/base/file_io.h"

#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <ctime>

namespace burin::base {
namespace {

// Blocks SIGPIPE in this thread and takes away the one that a write raised, whatever the program does with it
// elsewhere.
class HoldSigpipe {
 public:
  HoldSigpipe() noexcept {
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    sigset_t pending;
    sigpending(&pending);
    was_pending_ = sigismember(&pending, SIGPIPE) == 1;
    pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  ~HoldSigpipe() {
    const int saved = errno;
    sigset_t pending;
    sigpending(&pending);
    if (!was_pending_ && sigismember(&pending, SIGPIPE) == 1) {
      const timespec no_wait{};
      sigtimedwait(&pipe_, nullptr, &no_wait);
    }
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    errno = saved;
  }
  HoldSigpipe(const HoldSigpipe&) = delete;
  HoldSigpipe& operator=(const HoldSigpipe&) = delete;

 private:
  sigset_t pipe_{};
  sigset_t before_{};
  bool was_pending_ = false;
};

// A descriptor that somebody set non-blocking (shared with a parent, as terminals and pipes are).
bool WaitFor(int descriptor, short event) noexcept {
  pollfd request{descriptor, event, 0};
  return poll(&request, 1, -1) >= 0 || errno == EINTR;
}

}  // namespace

int WriteAll(int descriptor, std::span<const std::byte> bytes) noexcept {
  const HoldSigpipe hold;
  while (!bytes.empty()) {
    const ssize_t written = write(descriptor, bytes.data(), bytes.size());
    if (written >= 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
      if (!WaitFor(descriptor, POLLOUT)) return errno;
    } else if (errno != EINTR) {
      return errno;
    }
  }
  return 0;
}

ssize_t ReadSome(int descriptor, std::span<std::byte> bytes) noexcept {
  for (;;) {
    const ssize_t got = read(descriptor, bytes.data(), bytes.size());
    if (got >= 0) return got;
    if (errno == EAGAIN || errno == EWOULDBLOCK) {
      if (!WaitFor(descriptor, POLLIN)) return -errno;
    } else if (errno != EINTR) {
      return -errno;
    }
  }
}

ReadCount ReadAll(int descriptor, std::span<std::byte> bytes) noexcept {
  ReadCount count;
  while (count.bytes < bytes.size()) {
    const ssize_t got = ReadSome(descriptor, bytes.subspan(count.bytes));
    if (got < 0) count.error = static_cast<int>(-got);
    if (got <= 0) break;
    count.bytes += static_cast<std::size_t>(got);
  }
  return count;
}

void WidenPipe(int descriptor) noexcept {
#ifdef F_SETPIPE_SZ
  constexpr int kBytes = 1 << 20;  // the usual /proc/sys/fs/pipe-max-size
  static_cast<void>(fcntl(descriptor, F_SETPIPE_SZ, kBytes));
#else
  static_cast<void>(descriptor);
#endif
}

}  // namespace burin::base

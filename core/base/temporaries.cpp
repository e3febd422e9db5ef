// SPDX-License-Identifier: Apache-2.0
#include "core/base/temporaries.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstring>

namespace burin::base {

/// Fixed slots rather than a list: a signal handler may look at any moment, so nothing may be freed or half linked.
class TemporaryRegistry {
 public:
  TemporaryId Add(const std::string& path) noexcept {
    if (path.size() >= sizeof(Slot::path)) return kNotRegistered;
    for (TemporaryId i = 0; i < slots_.size(); ++i) {
      int expected = kFree;
      if (!slots_[i].state.compare_exchange_strong(expected, kClaimed)) continue;
      std::memcpy(slots_[i].path, path.c_str(), path.size() + 1);
      slots_[i].state.store(kLive, std::memory_order_release);
      return i;
    }
    return kNotRegistered;
  }

  void Remove(TemporaryId id) noexcept {
    if (id < slots_.size()) slots_[id].state.store(kFree, std::memory_order_release);
  }

  void UnlinkAll() noexcept {
    for (Slot& slot : slots_) {
      if (slot.state.load(std::memory_order_acquire) == kLive) unlink(slot.path);
    }
  }

 private:
  enum State : int { kFree, kClaimed, kLive };
  struct Slot {
    std::atomic<int> state{kFree};
    char path[PATH_MAX]{};
  };
  static_assert(std::atomic<int>::is_always_lock_free);
  // One per file being written at the same time: a few even with many encoders. Untouched pages cost nothing.
  std::array<Slot, 256> slots_{};
};

namespace {

constinit TemporaryRegistry own_registry;
constinit std::atomic<TemporaryRegistry*> current_registry{&own_registry};

}  // namespace

TemporaryRegistry& Temporaries() { return *current_registry.load(); }

void ShareTemporaries(TemporaryRegistry& registry) { current_registry.store(&registry); }

TemporaryId RegisterTemporary(const std::string& path) noexcept { return Temporaries().Add(path); }

void UnregisterTemporary(TemporaryId id) noexcept { Temporaries().Remove(id); }

void RemoveTemporaries() noexcept {
  const int saved = errno;  // the interrupted code may be about to look at it
  Temporaries().UnlinkAll();
  errno = saved;
}

}  // namespace burin::base

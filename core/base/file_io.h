// SPDX-License-Identifier: Apache-2.0
#pragma once
// read(2) and write(2) that finish: they go on after EINTR and short counts.

#include <sys/types.h>

#include <cstddef>
#include <span>

namespace burin::base {

/// Writes all of `bytes`; 0 or an errno value. A closed pipe is EPIPE, never a signal: SIGPIPE is held back for the
/// call.
[[nodiscard]] int WriteAll(int descriptor, std::span<const std::byte> bytes) noexcept;

struct ReadCount {
  std::size_t bytes = 0;  ///< less than asked for only at the end of the stream or on an error
  int error = 0;          ///< errno
};

/// Reads until `bytes` is full or the stream ends.
[[nodiscard]] ReadCount ReadAll(int descriptor, std::span<std::byte> bytes) noexcept;

/// One read that got something: the count, 0 at the end of the stream, or minus an errno value.
[[nodiscard]] ssize_t ReadSome(int descriptor, std::span<std::byte> bytes) noexcept;

/// Asks for a pipe that holds a good part of a frame, so that two processes wake each other less often. Nothing happens
/// when the descriptor is no pipe or the system's limit is lower.
void WidenPipe(int descriptor) noexcept;

}  // namespace burin::base

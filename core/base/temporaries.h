// SPDX-License-Identifier: Apache-2.0
#pragma once
// The files that this process has begun and not yet given their names, so that a signal can remove them.

#include <cstddef>
#include <string>

namespace burin::base {

class TemporaryRegistry;

/// The registry of this process. A module (its own copy of this room) takes the program's with ShareTemporaries.
[[nodiscard]] TemporaryRegistry& Temporaries();

/// Makes Temporaries() of this copy of the room answer `registry`. Called once, by a module's factory, before any use.
void ShareTemporaries(TemporaryRegistry& registry);

/// Unlinks every registered file. Async-signal-safe: no locks, no memory, only unlink(2) on fixed buffers.
void RemoveTemporaries() noexcept;

/// A number for Unregister; kNotRegistered when every slot was taken or the path was too long.
using TemporaryId = std::size_t;
inline constexpr TemporaryId kNotRegistered = static_cast<TemporaryId>(-1);

/// `path` must be absolute if the working folder can change.
[[nodiscard]] TemporaryId RegisterTemporary(const std::string& path) noexcept;
void UnregisterTemporary(TemporaryId id) noexcept;

}  // namespace burin::base

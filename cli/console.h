// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "core/base/error.h"

namespace burin::cli {

inline constexpr int kExitDone = 0;
inline constexpr int kExitUsage = 2;
inline constexpr int kExitInput = 3;

[[nodiscard]] int ExitStatus(const Error& error);

/// Whether ANSI colours may go to this descriptor: a terminal, with NO_COLOR empty or unset and TERM not "dumb".
[[nodiscard]] bool UsesColor(int descriptor);

/// "burin: error: MESSAGE" on stderr; a usage error adds where help is.
void PrintError(const Error& error);
void PrintWarning(std::string_view message);

/// Writes data to stdout. The exit status: 0, 141 (128 + SIGPIPE) when the reader has gone, else 1 with a message.
[[nodiscard]] int PrintData(std::string_view text);

/// Whether the reader of this pipe has gone.
[[nodiscard]] bool ReaderGone(int descriptor);

/// Writes all of it; failures are ignored: messages have nowhere else to go.
void WriteText(int descriptor, std::string_view text);

}  // namespace burin::cli

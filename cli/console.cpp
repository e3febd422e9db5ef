// SPDX-License-Identifier: Apache-2.0
#include "cli/console.h"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string>

#include "core/base/file_io.h"

namespace burin::cli {
namespace {

bool IsSet(const char* name) {
  const char* const value = std::getenv(name);
  return value != nullptr && *value != '\0';
}

void PrintMessage(std::string_view color, std::string_view kind, std::string_view message) {
  const bool colored = UsesColor(STDERR_FILENO);
  WriteText(STDERR_FILENO,
            fmt::format("burin: {}{}:{} {}\n", colored ? color : "", kind, colored ? "\x1b[0m" : "", message));
}

}  // namespace

int ExitStatus(const Error& error) { return static_cast<int>(error.kind); }

bool UsesColor(int descriptor) {
  const char* const term = std::getenv("TERM");
  return isatty(descriptor) == 1 && !IsSet("NO_COLOR") && (term == nullptr || std::strcmp(term, "dumb") != 0);
}

void PrintError(const Error& error) { PrintMessage("\x1b[1;31m", "error", error.message); }

void PrintWarning(std::string_view message) { PrintMessage("\x1b[1;35m", "warning", message); }

int PrintData(std::string_view text) {
  const int status = base::WriteAll(STDOUT_FILENO, std::as_bytes(std::span(text)));
  if (status == 0) return kExitDone;
  if (status == EPIPE) return 128 + SIGPIPE;
  PrintError({ErrorKind::kFailed, fmt::format("stdout: {}", std::strerror(status))});
  return static_cast<int>(ErrorKind::kFailed);
}

bool ReaderGone(int descriptor) {
  pollfd entry{descriptor, POLLOUT, 0};
  return poll(&entry, 1, 0) == 1 && (entry.revents & POLLERR) != 0;
}

void WriteText(int descriptor, std::string_view text) {
  (void)base::WriteAll(descriptor, std::as_bytes(std::span(text)));
}

}  // namespace burin::cli

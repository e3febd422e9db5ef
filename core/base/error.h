// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <expected>
#include <string>
#include <utility>

namespace burin {

/// What went wrong, as the exit status tells it (burin(1), EXIT STATUS).
enum class ErrorKind {
  kFailed = 1,  ///< the work failed: an output could not be written, a limit was met
  kUsage = 2,   ///< the command line is wrong
  kInput = 3,   ///< an effect, scene, image or video has errors
  kDevice = 4,  ///< no usable GL device
};

/// One failure: a message that names the file and object, what was found and what was expected.
/// The message has no trailing newline and no "error:" in front.
struct Error {
  ErrorKind kind = ErrorKind::kFailed;
  std::string message;
};

template <class T>
using Result = std::expected<T, Error>;

/// Shorthand for a failed Result: `return Fail(ErrorKind::kInput, "...")`.
[[nodiscard]] inline std::unexpected<Error> Fail(ErrorKind kind, std::string message) {
  return std::unexpected(Error{kind, std::move(message)});
}

}  // namespace burin

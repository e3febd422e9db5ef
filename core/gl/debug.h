// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

namespace burin::gl {

/// Names an object in debuggers and driver messages. `identifier`: GL_TEXTURE, GL_BUFFER ...
void SetLabel(std::uint32_t identifier, std::uint32_t name, std::string_view label);

/// From here on every error or undefined behaviour that the driver reports ends the process with its message. Running
/// out of memory does not: callers check for that one.
void AbortOnDriverErrors();

/// Ends the process when called on another thread than the context's, or while there is none: a bug of ours.
void AssertContextThread();

}  // namespace burin::gl

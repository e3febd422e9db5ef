// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace burin::cli {

/// A script for bash (complete -F) that follows the command and option tables.
[[nodiscard]] std::string BashCompletion();

}  // namespace burin::cli

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace burin::cli {

/// The whole program: finds the command, reads its options, runs it. `words` come without the program's name. The
/// result is the exit status.
[[nodiscard]] int Run(const std::vector<std::string>& words);

}  // namespace burin::cli

// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "cli/progress_modes.h"

namespace burin::cli {

void PlainProgress::OnFrame(long frame, const std::string& path) {
  Write(total() > 0 ? fmt::format("frame {} ({}/{}) {}\n", frame, done(), total(), path)
                    : fmt::format("frame {} ({}) {}\n", frame, done(), path));
}

}  // namespace burin::cli

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "cli/settings.h"
#include "core/render/progress.h"

namespace burin::cli {

/// The progress that --progress, --quiet and --verbose ask for; kAuto is a bar on a terminal and plain lines elsewhere.
[[nodiscard]] std::unique_ptr<render::Progress> MakeProgress(const Settings& settings);

}  // namespace burin::cli

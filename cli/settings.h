// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/render/job.h"

namespace burin::cli {

/// How much goes to stderr. Errors always do.
enum class LogLevel { kError, kWarning, kInfo };

enum class ProgressMode { kAuto, kBar, kPlain, kJson, kOpenJd, kNone };

/// What the command line says, whatever the command.
struct Settings {
  render::Job job;
  std::vector<std::string> arguments;  ///< those that are no options, in order
  LogLevel log_level = LogLevel::kWarning;
  ProgressMode progress = ProgressMode::kAuto;
  int progress_descriptor = 2;
  bool json = false;
  bool dot = false;
  std::string glsl_folder;             ///< of --glsl; empty: not given
  bool help = false;
};

}  // namespace burin::cli

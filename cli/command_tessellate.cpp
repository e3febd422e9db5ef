// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <csignal>

#include "cli/command_table.h"
#include "cli/console.h"
#include "cli/signals.h"
#include "core/render/tessellate_model.h"

namespace burin::cli {

int RunTessellate(const Settings& settings) {
  render::Job job = settings.job;
  if (settings.arguments.size() > 1) {
    PrintError({ErrorKind::kUsage,
                fmt::format("two models, {} and {}; expected one", settings.arguments[0], settings.arguments[1])});
    return kExitUsage;
  }
  if (!settings.arguments.empty()) job.source = settings.arguments.front();
  Result<render::TessellatedModel> model;
  int signal = 0;
  {
    const SignalGuard guard([] {});
    model = render::TessellateModel(job);
    signal = guard.signal();
  }
  if (signal != 0) return 128 + signal;
  if (!model) {
    if (job.output == "-" && ReaderGone(STDOUT_FILENO)) return 128 + SIGPIPE;
    PrintError(model.error());
    return ExitStatus(model.error());
  }
  if (settings.log_level >= LogLevel::kWarning) {
    for (const std::string& warning : model->warnings) PrintWarning(warning);
  }
  if (settings.log_level >= LogLevel::kInfo) {
    for (const std::string& note : model->notes) WriteText(STDERR_FILENO, fmt::format("burin: {}\n", note));
  }
  return kExitDone;
}

}  // namespace burin::cli

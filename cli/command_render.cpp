// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include "cli/command_table.h"
#include "cli/console.h"
#include "cli/progress.h"
#include "cli/signals.h"
#include "core/render/effect_library.h"
#include "core/render/render.h"

namespace burin::cli {
namespace {

/// The job with what the environment and the arguments say.
Result<render::Job> CompleteJob(const Settings& settings) {
  render::Job job = settings.job;
  auto inputs = render::SortInputs(settings.arguments);
  if (!inputs) return std::unexpected(inputs.error());
  job.effects = std::move(inputs->effects);
  job.source = std::move(inputs->source);
  if (const char* config = std::getenv("OCIO"); job.color.config.empty() && config != nullptr)
    job.color.config = config;
  if (settings.progress_descriptor == STDOUT_FILENO && job.output == "-") {
    return Fail(ErrorKind::kUsage, "--progress-fd 1: stdout takes the video stream; expected another descriptor");
  }
  if (fcntl(settings.progress_descriptor, F_GETFD) == -1) {
    return Fail(ErrorKind::kUsage,
                fmt::format("--progress-fd {}: {}", settings.progress_descriptor, std::strerror(errno)));
  }
  return job;
}

int Report(const Error& error) {
  PrintError(error);
  return ExitStatus(error);
}

}  // namespace

int RunRender(const Settings& settings) {
  const auto job = CompleteJob(settings);
  if (!job) return Report(job.error());
  const std::unique_ptr<render::Progress> progress = MakeProgress(settings);
  Result<void> result;
  int signal = 0;
  {
    const SignalGuard guard([&progress] { progress->Finished(Fail(ErrorKind::kFailed, "interrupted"), 0); });
    result = render::Run(*job, *progress, guard.stop());
    signal = guard.signal();
  }
  if (result) return kExitDone;
  if (signal != 0) return 128 + signal;
  // Whoever read our stream has had enough: a pipe's usual end, which shells report as SIGPIPE.
  if (job->output == "-" && ReaderGone(STDOUT_FILENO)) return 128 + SIGPIPE;
  return Report(result.error());
}

}  // namespace burin::cli

// SPDX-License-Identifier: Apache-2.0
#include "cli/progress.h"

#include <unistd.h>

#include "cli/message_progress.h"
#include "cli/progress_modes.h"

namespace burin::cli {

std::unique_ptr<render::Progress> MakeProgress(const Settings& settings) {
  ProgressMode mode = settings.progress;
  if (mode == ProgressMode::kAuto) {
    mode = settings.log_level == LogLevel::kError      ? ProgressMode::kNone
           : isatty(settings.progress_descriptor) == 1 ? ProgressMode::kBar
                                                       : ProgressMode::kPlain;
  }
  switch (mode) {
    case ProgressMode::kBar:
      return std::make_unique<BarProgress>(settings);
    case ProgressMode::kPlain:
      return std::make_unique<PlainProgress>(settings);
    case ProgressMode::kJson:
      return std::make_unique<JsonProgress>(settings);
    case ProgressMode::kOpenJd:
      return std::make_unique<OpenJdProgress>(settings);
    case ProgressMode::kAuto:
    case ProgressMode::kNone:
      break;
  }
  return std::make_unique<MessageProgress>(settings);
}

}  // namespace burin::cli

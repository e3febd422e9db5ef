// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "cli/command_table.h"
#include "cli/console.h"
#include "core/render/versions.h"

namespace burin::cli {

int RunVersion(const Settings& settings) {
  if (!settings.arguments.empty()) {
    PrintError({ErrorKind::kUsage, fmt::format("burin --version: unexpected '{}'", settings.arguments.front())});
    return kExitUsage;
  }
  std::string text = fmt::format("burin {}\n", render::ProgramVersion());
  if (settings.log_level < LogLevel::kInfo) return PrintData(text);
  for (const std::string& line : render::LibraryVersions()) text += line + "\n";
  const auto device = render::DescribeDevice(settings.job.device);
  if (!device) {
    const int printed = PrintData(text);
    PrintError(device.error());
    return printed != kExitDone ? printed : ExitStatus(device.error());
  }
  return PrintData(text + *device);
}

}  // namespace burin::cli

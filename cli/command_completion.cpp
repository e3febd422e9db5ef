// SPDX-License-Identifier: Apache-2.0
#include "cli/command_table.h"
#include "cli/completion.h"
#include "cli/console.h"

namespace burin::cli {

int RunCompletion(const Settings& settings) {
  if (settings.arguments.size() == 1 && settings.arguments.front() == "bash") return PrintData(BashCompletion());
  PrintError({ErrorKind::kUsage, "burin completion: expected the shell's name: bash"});
  return kExitUsage;
}

}  // namespace burin::cli

// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <vector>

#include "cli/run.h"

int main(int argument_count, char** arguments) {
  return burin::cli::Run(
      std::vector<std::string>(arguments + (argument_count > 0 ? 1 : 0), arguments + argument_count));
}

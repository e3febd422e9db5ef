// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/base/error.h"

namespace burin::base {

/// Opens the shared object `name`.so (for instance "burin_image_module") from the first of ModuleFolders() that holds
/// it and returns the address of its extern "C" function `factory`. The object stays loaded until the process ends.
/// Errors: kFailed, with every path tried and what the dynamic linker said. Any thread.
[[nodiscard]] Result<void*> LoadModuleFunction(const std::string& name, const char* factory);

}  // namespace burin::base

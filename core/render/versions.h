// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"

namespace burin::render {

[[nodiscard]] std::string ProgramVersion();
/// A line for each group of libraries; loads the modules, and says so when one cannot be.
[[nodiscard]] std::vector<std::string> LibraryVersions();
/// Lines about the device that --device gives and those that it can name. Errors: kDevice, kUsage.
[[nodiscard]] Result<std::string> DescribeDevice(const std::string& device);

}  // namespace burin::render

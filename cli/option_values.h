// SPDX-License-Identifier: Apache-2.0
#pragma once
// The forms that option values take. Each error is kUsage and names the option, what was found and what was expected.

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/render/job.h"

namespace burin::cli {

/// "1920x1080"
[[nodiscard]] Result<std::pair<int, int>> ParseSize(std::string_view text);
/// "24", "23.976", "30000/1001"; the usual decimals of the NTSC rates become their ratios.
[[nodiscard]] Result<video::FrameRate> ParseFrameRate(std::string_view text);
/// "#rrggbb[aa]" (sRGB), "r,g,b[,a]" (scene-linear), "black", "white", "transparent". The result is scene-linear with
/// unassociated alpha.
[[nodiscard]] Result<std::array<float, 4>> ParseColor(std::string_view text);
[[nodiscard]] Result<double> ParseNumber(std::string_view option, std::string_view text);
[[nodiscard]] Result<long> ParseInteger(std::string_view option, std::string_view text, long lowest, long highest);
/// "NAME=VALUE"; without "=" the value is `otherwise`, or an error when that is null. `kind`: what the message calls
/// the value.
[[nodiscard]] Result<std::pair<std::string, std::string>> ParseAssignment(std::string_view option,
                                                                          std::string_view text, const char* otherwise,
                                                                          std::string_view kind = "VALUE");
/// Names separated by commas; empty ones are refused.
[[nodiscard]] Result<std::vector<std::string>> ParseNames(std::string_view option, std::string_view text);

}  // namespace burin::cli

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace burin::render {

/// The most frames that one list may hold, so that a slip of the finger cannot eat the memory.
inline constexpr std::size_t kMaxFrames = 10'000'000;

/// Reads `--frames`: numbers and ranges separated by commas, where a range is `a-b` or `a..b` with an optional step
/// `xN` or `:N`, and every number may be negative (`-3--1`). The result is in ascending order without repetitions.
/// Errors: kUsage, saying what was found and how it is written.
[[nodiscard]] Result<std::vector<long>> ParseFrameList(std::string_view text);

/// The shortest list that ParseFrameList reads back as `frames` (ascending): "1-10x3,20". For messages.
[[nodiscard]] std::string FormatFrameList(std::span<const long> frames);

}  // namespace burin::render

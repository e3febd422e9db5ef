// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace burin::image {

/// Which of a file's channels make its picture, in order: R G B (A), else Y (A), else those of the first layer
/// ("diffuse.R" ...), else all when there are at most four. Empty when nothing of that is there.
[[nodiscard]] std::optional<std::vector<int>> ChoosePictureChannels(std::span<const std::string> names);

}  // namespace burin::image

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace burin::base {

/// The extension of a path in lower case without its dot: "a/B.Exr" gives "exr", ".hidden" and "a" give "".
[[nodiscard]] std::string LowerExtension(std::string_view path);

}  // namespace burin::base

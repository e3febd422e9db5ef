// SPDX-License-Identifier: Apache-2.0
#pragma once
// The extension's names of textures: GBA<attribute>_<FORMAT>[_S<scale>] and PASS<k>_<FORMAT>[_S<scale>][_RT<j>].
// Prefixes are upper case; attribute, format and modifiers compare without case. _S3 is 3, _S0_5 is 0.5.

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "fx_parser/effect/effect.h"

namespace burin::fx {

/// Largest scale against the frame, pass number and render target that a name may give.
inline constexpr double kMaxScale = 16.0;
inline constexpr int kMaxPass = 999;

struct ExtensionName {
  std::variant<AttributeRole, PassResultRole> role;
  Format format = Format::kA8R8G8B8;
  double scale = 1.0;
};

struct NamingError {
  std::string code;
  std::string text;
};

/// True for names that the extension takes for its own, well formed or not.
[[nodiscard]] bool IsExtensionName(std::string_view name);

/// `attributes` are lower case. Does not know whether a technique makes a custom attribute: pass those names too.
[[nodiscard]] std::variant<ExtensionName, NamingError> ParseExtensionName(std::string_view name,
                                                                          const std::vector<std::string>& attributes);

}  // namespace burin::fx

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <unordered_set>

namespace burin::fx {

/// Hands out identifiers that GLSL takes: no keyword, no gl_ name, no two underscores in a row, each only once.
class NameTable {
 public:
  /// `prefix` keeps `base` apart from keywords and from the names of other kinds.
  [[nodiscard]] std::string Unique(std::string_view prefix, std::string_view base);

 private:
  std::unordered_set<std::string> taken_;
};

/// What the host and its users call something of a namespace: "outer_inner" for "outer::inner".
[[nodiscard]] std::string PublicName(std::string_view name);

/// `name` with everything that GLSL's identifiers lack replaced.
[[nodiscard]] std::string SanitisedName(std::string_view name);

}  // namespace burin::fx

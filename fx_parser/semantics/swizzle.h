// SPDX-License-Identifier: Apache-2.0
#pragma once
// `.xyz`, `.rgba`, `._m00_m11`, `._11_22` as component lists.

#include <optional>
#include <string_view>
#include <vector>

#include "fx_parser/semantics/type.h"

namespace burin::fx {

struct SwizzleComponent {
  int row = 0;  ///< 0 for vectors and scalars
  int column = 0;
  bool operator==(const SwizzleComponent&) const = default;
};

/// Empty when `name` is no swizzle of `type`. One to four components.
[[nodiscard]] std::optional<std::vector<SwizzleComponent>> ParseSwizzle(const Type& type, std::string_view name);

/// A scalar for one component, a vector for more.
[[nodiscard]] Type SwizzleType(const Type& type, std::size_t components);

/// For messages: ": its components are x, y or r, g"; empty for what has none.
[[nodiscard]] std::string DescribeComponents(const Type& type);

[[nodiscard]] bool HasDuplicates(const std::vector<SwizzleComponent>& swizzle);

}  // namespace burin::fx

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "fx_parser/semantics/type.h"

namespace burin::fx {

/// A constant. Numeric types: `numbers` holds every component, arrays and structs element after element, matrices row by
/// row (bool as 0/1). String types: `strings`.
struct Value {
  Type type;
  std::vector<double> numbers;
  std::vector<std::string> strings;

  [[nodiscard]] bool empty() const { return numbers.empty() && strings.empty(); }
};

}  // namespace burin::fx

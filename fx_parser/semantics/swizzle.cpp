// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/semantics/swizzle.h"

#include <algorithm>

namespace burin::fx {
namespace {

std::optional<std::vector<SwizzleComponent>> VectorSwizzle(int columns, std::string_view name) {
  if (name.empty() || name.size() > 4) return std::nullopt;
  for (const std::string_view set : {"xyzw", "rgba"}) {
    std::vector<SwizzleComponent> swizzle;
    for (const char c : name) {
      const std::size_t at = set.find(c);
      if (at == std::string_view::npos || static_cast<int>(at) >= columns) break;
      swizzle.push_back({0, static_cast<int>(at)});
    }
    if (swizzle.size() == name.size()) return swizzle;
  }
  return std::nullopt;
}

/// `_m00_m01` counts from zero, `_11_12` from one; one swizzle keeps to one of them.
std::optional<std::vector<SwizzleComponent>> MatrixSwizzle(const Type& type, std::string_view name) {
  const bool zero_based = name.size() > 1 && name[1] == 'm';
  const std::size_t step = zero_based ? 4 : 3;
  const int base = zero_based ? 0 : 1;
  if (name.empty() || name.size() % step != 0 || name.size() / step > 4) return std::nullopt;
  std::vector<SwizzleComponent> swizzle;
  for (std::size_t i = 0; i < name.size(); i += step) {
    if (name[i] != '_' || (zero_based && name[i + 1] != 'm')) return std::nullopt;
    const int row = name[i + step - 2] - '0' - base;
    const int column = name[i + step - 1] - '0' - base;
    if (row < 0 || column < 0 || row >= type.rows || column >= type.columns) return std::nullopt;
    swizzle.push_back({row, column});
  }
  return swizzle;
}

}  // namespace

std::optional<std::vector<SwizzleComponent>> ParseSwizzle(const Type& type, std::string_view name) {
  if (!type.is_numeric()) return std::nullopt;
  return type.is_matrix ? MatrixSwizzle(type, name) : VectorSwizzle(type.columns, name);
}

Type SwizzleType(const Type& type, std::size_t components) {
  return components == 1 ? ScalarType(type.scalar) : VectorType(type.scalar, static_cast<int>(components));
}

std::string DescribeComponents(const Type& type) {
  if (!type.is_numeric()) return {};
  if (type.is_matrix) {
    const auto last = [&](int base) {
      return std::to_string(type.rows - 1 + base) + std::to_string(type.columns - 1 + base);
    };
    return ": its components are _m00 to _m" + last(0) + " or _11 to _" + last(1);
  }
  const auto list = [&](std::string_view letters) {
    std::string text;
    for (int i = 0; i < type.columns; ++i)
      text += (i > 0 ? ", " : "") + std::string(1, letters[static_cast<std::size_t>(i)]);
    return text;
  };
  return (type.columns == 1 ? ": its component is " : ": its components are ") + list("xyzw") + " or " + list("rgba");
}

bool HasDuplicates(const std::vector<SwizzleComponent>& swizzle) {
  for (std::size_t i = 0; i < swizzle.size(); ++i) {
    if (std::find(swizzle.begin() + static_cast<std::ptrdiff_t>(i) + 1, swizzle.end(), swizzle[i]) != swizzle.end())
      return true;
  }
  return false;
}

}  // namespace burin::fx

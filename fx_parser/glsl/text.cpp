// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/glsl/text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "fx_parser/semantics/conversion.h"

namespace burin::fx {

Storage StorageOf(const Type& numeric) {
  Storage storage;
  const bool is_full = numeric.is_matrix && numeric.rows > 1 && numeric.columns > 1;
  storage.scalar = IsFloating(numeric.scalar) || is_full ? Scalar::kFloat : numeric.scalar;
  if (is_full) {
    storage.columns = numeric.rows;
    storage.size = numeric.columns;
  } else {
    storage.size = numeric.components();
  }
  return storage;
}

std::string StorageText(const Storage& storage) {
  if (storage.is_matrix()) return "mat" + std::to_string(storage.columns) + "x" + std::to_string(storage.size);
  const char* scalar = "float";
  const char* prefix = "";
  switch (storage.scalar) {
    case Scalar::kBool:
      scalar = "bool";
      prefix = "b";
      break;
    case Scalar::kInt:
      scalar = "int";
      prefix = "i";
      break;
    case Scalar::kUint:
      scalar = "uint";
      prefix = "u";
      break;
    default:
      break;
  }
  return storage.size == 1 ? scalar : std::string(prefix) + "vec" + std::to_string(storage.size);
}

std::string NumberText(double number, Scalar scalar) {
  if (scalar == Scalar::kBool) return number != 0 ? "true" : "false";
  if (scalar == Scalar::kUint)
    return std::to_string(static_cast<std::uint32_t>(static_cast<std::int64_t>(number))) + "u";
  if (scalar == Scalar::kInt) {
    const auto value = static_cast<std::int32_t>(static_cast<std::uint32_t>(static_cast<std::int64_t>(number)));
    if (value == std::numeric_limits<std::int32_t>::min()) return "(-2147483647 - 1)";
    return value < 0 ? "(" + std::to_string(value) + ")" : std::to_string(value);
  }
  if (std::isnan(number)) return "(0.0 / 0.0)";
  const double largest = std::numeric_limits<float>::max();
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.9g", std::clamp(number, -largest, largest));
  std::string text = buffer;
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text[0] == '-' ? "(" + text + ")" : text;
}

bool IsSimpleText(const std::string& text) {
  return std::ranges::all_of(text, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.' ||
           c == '[' || c == ']';
  });
}

}  // namespace burin::fx

// SPDX-License-Identifier: Apache-2.0
#pragma once
// The glTF 2.0 JSON schema as tables: what each property may hold. tinygltf 2.7 skips or misreads values of a wrong
// type, so the text is checked against these before tinygltf sees it.

#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

namespace burin::scene {

enum class Shape : std::uint8_t {
  kString,
  kBoolean,
  kNumber,
  kInteger,  ///< not negative
  kIndex,    ///< of an entry in the root's array `of`
  kWord,     ///< one of the strings in `of`, separated by '|'
  kCode,     ///< one of the integers in `of`, separated by '|'
  kObject,   ///< of the type `of`
  kStrings,
  kNumbers,
  kIndices,
  kObjects,
  kAccessorMap,  ///< an object of accessor indices
  kAccessorMaps,
};

struct Rule {
  std::string_view name;
  Shape shape;
  bool required = false;
  std::string_view of = {};
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  int items = 0;  ///< exact length of a number array; 0: any
};

/// Stands for "greater than 0" in Rule::min.
inline constexpr double kPositive = std::numeric_limits<double>::min();

/// The rules of an object type: "root", "accessor" ... or of an extension's object by the extension's name; empty when
/// unknown.
[[nodiscard]] std::span<const Rule> RulesOf(std::string_view object_type);

}  // namespace burin::scene

// SPDX-License-Identifier: Apache-2.0
#pragma once
// Checked reading of glTF accessors (specification 3.6.2): strided, sparse, integer and normalised data to plain
// arrays. Every read is checked against the buffer view with arithmetic that cannot overflow, and does not need aligned
// data.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/scene/gltf_document.h"

namespace burin::scene {

struct AccessorShape {
  std::size_t count = 0;
  int components = 1;      ///< 16 for MAT4
  int component_type = 0;  ///< 5120 ... 5126
  bool normalized = false;
  [[nodiscard]] bool is_float() const { return component_type == 5126; }
};

/// Checks an accessor's ranges. Messages start "accessor N".
[[nodiscard]] Result<AccessorShape> CheckAccessor(const GltfDocument& document, int accessor);

enum class Integers : std::uint8_t {
  kAsDeclared,        ///< fractions when `normalized` is set, else whole numbers
  kAlwaysNormalised,  ///< fractions whatever is declared
};

/// Reads elements of `components` components as floats, all finite.
[[nodiscard]] Result<std::vector<float>> ReadFloats(GltfDocument& document, int accessor, int components,
                                                    Integers integers = Integers::kAsDeclared);

/// The same into vectors: V is glm::vec2, vec3, vec4, mat4.
template <class V>
[[nodiscard]] Result<std::vector<V>> ReadVectors(GltfDocument& document, int accessor,
                                                 Integers integers = Integers::kAsDeclared);

/// Reads unsigned integers (indices, joints), `components` an element.
[[nodiscard]] Result<std::vector<std::uint32_t>> ReadIntegers(GltfDocument& document, int accessor, int components);

}  // namespace burin::scene

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/effect/frame_context.h"
#include "fx_parser/effect/effect.h"

namespace burin::effect {

/// What of the host a parameter asks for, by its semantic or by one of the extension's names.
struct HostValue {
  enum class Kind {
    kMatrix,
    kTime,
    kLastTime,
    kElapsedTime,
    kFrame,
    kFrameSize,
    kTexelSize,
    kHalfPixelSize,
    kEyePosition,
    kViewDirection,
    kLightPosition,
    kLightDirection,
    kLightColor,
    kLightAmbient,
    kLightRange,
    kLightCount,
    kMaterialDiffuse,
    kMaterialAmbient,
    kMaterialSpecular,
    kMaterialEmissive,
    kMaterialPower,
    kMaterialHasTexture,
    kMaterialOpacity,
    kConstant
  };
  enum class Space { kWorld, kView, kObject };
  Kind kind = Kind::kMatrix;
  bool world = false, view = false, projection = false;  ///< the factors of a matrix
  bool previous = false;                                 ///< of the frame before
  bool inverse = false, transpose = false;
  Space space = Space::kWorld;      ///< of positions and directions
  std::size_t light = 0;            ///< which; those of an array are it and the next
  bool is_seen_from_light = false;  ///< a matrix of that light's view, for shadow maps
  bool points_to_light = false;     ///< of kLightDirection: not as it shines
  bool yields_to_default = false;   ///< the file's own value is better than what is made up for a picture
  std::array<double, 4> constant{};
  std::optional<std::size_t> texture;  ///< of kTexelSize: TexelSize_<texture>

  [[nodiscard]] bool is_of_material() const { return kind >= Kind::kMaterialDiffuse && kind <= Kind::kMaterialOpacity; }
  [[nodiscard]] bool depends_on_object() const { return world || space == Space::kObject || is_of_material(); }
  bool operator==(const HostValue&) const = default;
};

/// Nothing when the parameter keeps its default. Appends to `warnings` when its semantic is one that nobody knows, its
/// type cannot hold what the semantic means, or TexelSize_<texture> names no texture.
[[nodiscard]] std::optional<HostValue> FindHostValue(const fx::Effect& effect, const fx::Parameter& parameter,
                                                     std::vector<std::string>& warnings);

/// A part of a parameter: a member of a struct of DXSAS's lights, or of one in an array of them.
struct HostPart {
  std::size_t offset = 0;  ///< in fx::Value::numbers
  fx::Type type;
  HostValue host;
};
/// Of a struct whose SasBindAddress names a light, ambient light or camera; else empty.
[[nodiscard]] std::vector<HostPart> FindHostParts(const fx::Parameter& parameter);

/// Writes the value into `numbers`, which has as many as the parameter's type has components, arrays element after
/// element. Matrices are written as Direct3D's rows: `mul(vector, matrix)` transforms. `column_vectors`: as CgFX's, for
/// `mul(matrix, vector)`. Where the context has no such thing (a second light), `numbers` stay as they are.
void Evaluate(const HostValue& host, const FrameContext& context, std::span<const glm::ivec2> texture_sizes,
              const fx::Type& type, bool column_vectors, std::span<double> numbers);

}  // namespace burin::effect

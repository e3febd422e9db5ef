// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

namespace burin::scene {

enum class TessellationMode : std::uint8_t {
  kAuto,  ///< patch models and subdivision surfaces fractionally, meshes if a length or factor is given
  kOff,
  kInteger,
  kFractional,  ///< meshes too, as PN triangles
};

struct TessellationOptions {
  TessellationMode mode = TessellationMode::kAuto;
  std::optional<float> edge_length_px;  ///< how long a side may be on screen before it is split; otherwise 8
  std::optional<float> factor;          ///< of every side instead, 1 to 256
  float crease_angle_deg = 60.0f;       ///< meshes without normals: edges that bend by more stay sharp

  /// True when meshes without patches become PN triangles: asked for by the mode, or by saying how finely.
  [[nodiscard]] bool curves_meshes() const {
    if (mode == TessellationMode::kAuto) return edge_length_px || factor;
    return mode != TessellationMode::kOff;
  }
};

}  // namespace burin::scene

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace burin::overdraw {

/// How discontinuity edges are antialiased. kUnsorted and kSorted are the two ways of Sander et al. 2001: antialiased
/// lines drawn over the edges, in any order or back to front. kResolve mixes the pixels on the two sides of an edge by
/// area instead (resolve_glsl.h).
enum class EdgeMode : std::uint8_t { kOff, kUnsorted, kSorted, kResolve };

struct EdgeOptions {
  EdgeMode mode = EdgeMode::kResolve;
  /// Faces that meet at more are a crease even where the shading is smooth. 0..180.
  float crease_angle_deg = 60.0f;
  /// Of the asymmetric map (Sander et al. 2001, section 3.3): how far a sharp edge is turned before the shading of its
  /// right face joins that of its left one. 0..1.
  float tau = 0.9f;
  /// kSorted: the edges of all objects in one order; else object by object, as the paper draws single models.
  bool sorts_whole_scene = true;
};

}  // namespace burin::overdraw

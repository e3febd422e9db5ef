// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/scene/pose.h"
#include "core/scene/scene.h"

namespace burin::scene {

/// A view ready to draw with. Right-handed view space looking along -z; clip z 0..w (0 at the near plane).
struct View {
  glm::mat4 view_from_world{1.0f};
  glm::mat4 clip_from_view{1.0f};
  bool orthographic = false;
  float znear = 0.1f;
  float zfar = 100.0f;          ///< infinity for an infinite projection
};

/// How to look at the scene: --camera NAME|INDEX|auto and --orbit.
struct CameraChoice {
  int camera_node = kNone;      ///< kNone: auto, framed on `bounds`
  Bounds bounds;                ///< of the whole scene over the rendered time, for auto
};

/// The node of the camera that --camera names. Empty choice: the file's first camera, or kNone (framed) when it has none;
/// "auto": kNone. kUsage for an unknown name or index, naming what there is.
[[nodiscard]] Result<int> SelectCamera(const Scene& scene, const std::string& choice);

/// `orbit_deg` turns the eye about the vertical axis through the bounds' centre.
[[nodiscard]] View MakeView(const Scene& scene, const CameraChoice& choice, const Pose& pose, int width, int height,
                            double orbit_deg);

}  // namespace burin::scene

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

/// The node of the camera that --camera names: the name of a camera or of its node, or an index among the shown scene's
/// camera nodes in node order. Empty choice: the first of them, or kNone (framed) when there is none; "auto": kNone.
/// kUsage for an unknown name or index, naming what there is.
[[nodiscard]] Result<int> SelectCamera(const Scene& scene, const std::string& choice);

/// `orbit_deg` turns the eye about the vertical (y) axis through the bounds' centre, counter-clockwise seen from above:
/// from +z towards +x. This holds for the file's cameras too.
///
/// A file's perspective camera keeps its vertical field of view (an orthographic one its ymag) and the frame decides
/// the aspect: the camera's own aspectRatio (xmag) is not used, so pixels stay square. A camera node's scale is
/// ignored.
///
/// Auto: from the front, right and above (30 and 20 degrees), 35 degrees of vertical field of view, at a distance that
/// shows the whole of `bounds` with a margin at every orbit angle (the distance does not change while it turns).
[[nodiscard]] View MakeView(const Scene& scene, const CameraChoice& choice, const Pose& pose, int width, int height,
                            double orbit_deg);

}  // namespace burin::scene

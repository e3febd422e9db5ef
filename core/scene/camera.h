// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
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
  /// Auto: the bounds of the scene as each matrix of AutoReach maps it; the picture is then filled. Absent: the distance
  /// shows `bounds` at every orbit angle.
  std::optional<std::array<Bounds, 2>> reach;
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
/// Auto: from the front, right and above (30 and 20 degrees), 35 degrees of vertical field of view. With
/// CameraChoice::reach the scene fills the picture but for a margin; without it the eye looks at the middle of `bounds`
/// from a distance that shows them whole at every orbit angle, so that it does not change while it turns.
[[nodiscard]] View MakeView(const Scene& scene, const CameraChoice& choice, const Pose& pose, int width, int height,
                            double orbit_deg);

/// Affine maps of world space whose maxima over the scene say how far it reaches beyond each side of the automatic
/// camera's picture and towards its eye: for CameraChoice::reach.
[[nodiscard]] std::array<glm::mat4, 2> AutoReach(int width, int height, double orbit_deg);

}  // namespace burin::scene

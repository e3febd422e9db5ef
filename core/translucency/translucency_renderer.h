// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/gbuffer/translucency_stage.h"
#include "core/image/image.h"
#include "core/scene/scene.h"
#include "core/translucency/translucency_options.h"

namespace burin::translucency {

/// The translucency stage of one scene: light that enters its translucent objects, scatters and comes out elsewhere.
/// Nothing is precomputed: each frame the object's surface is drawn on the six faces of its bounding box, as the
/// cube-map atlas of the 2009 paper on deforming translucent objects has it, and gathered there. Context's thread only.
class TranslucencyRenderer : public gbuffer::TranslucencyStage {
 public:
  /// Null when no material of the scene is translucent. `scene` outlives this; `environment` is only looked at: as for
  /// gbuffer::SceneRenderer. Errors: kInput for a material's extras.
  [[nodiscard]] static Result<std::unique_ptr<TranslucencyRenderer>> Create(const scene::Scene& scene,
                                                                            const image::Image* environment,
                                                                            const TranslucencyOptions& options);
  /// What is worth a line of --verbose, and what is likely to be wrong; each once.
  [[nodiscard]] virtual std::vector<std::string> TakeNotes() = 0;
  [[nodiscard]] virtual std::vector<std::string> TakeWarnings() = 0;
};

}  // namespace burin::translucency

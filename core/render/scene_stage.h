// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>

#include "core/base/error.h"
#include "core/effect/effect_runner.h"
#include "core/gbuffer/attribute_renderer.h"
#include "core/render/picture_stage.h"
#include "core/render/source.h"

namespace burin::render {

/// Fills attributes from a scene, through the job's display transform. Context's thread only.
class SceneStage {
 public:
  /// `scene` and `pictures` outlive this. `background`: scene-linear with associated alpha.
  [[nodiscard]] static Result<std::unique_ptr<SceneStage>> Create(const scene::Scene& scene,
                                                                  const image::Image* environment,
                                                                  const glm::vec4& background, PictureStage& pictures);

  [[nodiscard]] Result<void> Fill(const SceneFrame& frame, std::span<const gbuffer::Request> requests);
  /// The draws for custom attributes; valid while `frame` is and until the next Fill.
  [[nodiscard]] effect::SceneDraws Draws(const SceneFrame& frame);

 private:
  SceneStage(std::unique_ptr<gbuffer::SceneRenderer> renderer, const glm::vec4& background, PictureStage& pictures);
  [[nodiscard]] gbuffer::FrameInput Input(const SceneFrame& frame) const;
  [[nodiscard]] Result<void> FillThroughTransform(const SceneFrame& frame, const gbuffer::Request& request);

  std::unique_ptr<gbuffer::SceneRenderer> renderer_;
  glm::vec4 background_;
  PictureStage& pictures_;
  gl::Texture linear_;
};

}  // namespace burin::render

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/effect/effect_runner.h"
#include "core/gbuffer/attribute_renderer.h"
#include "core/gbuffer/supersampler.h"
#include "core/overdraw/edge_renderer.h"
#include "core/render/picture_stage.h"
#include "core/render/source.h"
#include "core/translucency/translucency_renderer.h"

namespace burin::render {

/// How a scene is drawn, the same for all frames.
struct SceneOptions {
  const image::Image* environment = nullptr;  ///< null: the built-in one
  glm::vec4 background{0.0f};                 ///< scene-linear with associated alpha
  overdraw::EdgeOptions edges;
  translucency::TranslucencyOptions translucency;
  int samples = 1;  ///< --samples: of color, intensity and alpha, a pixel: 1, 4 or 16
};

/// Fills attributes from a scene, through the job's display transform. Context's thread only.
class SceneStage {
 public:
  /// `scene` and `pictures` outlive this; `options.environment` is only looked at.
  [[nodiscard]] static Result<std::unique_ptr<SceneStage>> Create(const scene::Scene& scene,
                                                                  const SceneOptions& options, PictureStage& pictures);

  [[nodiscard]] Result<void> Fill(const SceneFrame& frame, std::span<const gbuffer::Request> requests);
  /// What is worth a line of --verbose, each once.
  [[nodiscard]] std::vector<std::string> TakeNotes();
  [[nodiscard]] std::vector<std::string> TakeWarnings();
  /// The draws for custom attributes; valid while `frame` is and until the next Fill.
  [[nodiscard]] effect::SceneDraws Draws(const SceneFrame& frame);

 private:
  SceneStage(const scene::Scene& scene, std::unique_ptr<gbuffer::SceneRenderer> renderer, const SceneOptions& options,
             PictureStage& pictures);
  [[nodiscard]] gbuffer::FrameInput Input(const SceneFrame& frame) const;
  [[nodiscard]] Result<void> FillThroughTransform(const SceneFrame& frame, const gbuffer::Request& request);
  /// Requests of one size.
  [[nodiscard]] Result<void> FillSupersampled(const SceneFrame& frame, std::span<const gbuffer::Request> requests);

  const scene::Scene* scene_;
  std::unique_ptr<gbuffer::SceneRenderer> renderer_;
  std::unique_ptr<overdraw::EdgeRenderer> edges_;
  std::unique_ptr<translucency::TranslucencyRenderer> translucency_;  ///< null: nothing is translucent
  glm::vec4 background_;
  int samples_;
  PictureStage& pictures_;
  std::unique_ptr<gbuffer::Supersampler> supersampler_;  ///< null: one sample a pixel
  gl::Texture linear_;
};

}  // namespace burin::render

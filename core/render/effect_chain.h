// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/effect/effect_runner.h"
#include "core/render/effect_parameters.h"
#include "core/render/picture_stage.h"
#include "core/render/scene_stage.h"

namespace burin::render {

/// A picture on the device and what its colours mean.
struct Picture {
  const gl::Texture* texture = nullptr;
  image::Encoding encoding = image::Encoding::kDisplay;
};

struct ChainOptions {
  std::vector<std::shared_ptr<const fx::Effect>> effects;
  std::vector<std::string> techniques;         ///< one an effect; empty: the first valid
  std::vector<Assignments> parameters;         ///< one an effect
  std::vector<std::string> include_folders;    ///< textures are looked for there too
  std::function<std::uint32_t()> environment;  ///< RunnerOptions::environment
  bool has_source = false;
  int width = 0;
  int height = 0;
  gl::Format display_frame_format;
  gl::Format linear_frame_format;
};

/// Effects in a row: `color`, `intensity` and `alpha` of each but the first come from the result of the one before; all
/// else comes from the source. Context's thread only.
class EffectChain {
 public:
  /// `pictures` outlives this, as does `scene`, which is null for sources that are none.
  [[nodiscard]] static Result<std::unique_ptr<EffectChain>> Create(const ChainOptions& options, PictureStage& pictures,
                                                                   SceneStage* scene);

  /// What the scene has to fill before Run(); empty without a scene.
  [[nodiscard]] std::span<const gbuffer::Request> scene_requests() const { return scene_requests_; }

  /// The first effect's target that would be a mere copy of such a picture, so that the picture can be uploaded into it
  /// at once: same size and samples, and alpha either the same or hidden where the picture is opaque. Null: none is.
  [[nodiscard]] gl::Texture* CopyTarget(const gl::Format& format, int width, int height, image::Encoding encoding,
                                        bool is_opaque);

  /// The one target that the chain takes from the source, when it is an 8-bit intensity of the picture's size: the luma
  /// is then cheaper to compute before the upload, of which it leaves a quarter. Null: there is more, or other, to
  /// fill.
  [[nodiscard]] gl::Texture* LumaTarget(int width, int height, image::Encoding encoding);

  /// The last effect's frame; valid until the next Run(). `source` is the source's picture; `scene` its frame or null.
  [[nodiscard]] Result<Picture> Run(const effect::FrameContext& context, const Picture& source,
                                    const SceneFrame* scene);

  [[nodiscard]] std::vector<std::string> TakeWarnings();
  /// "edges.fx: technique 'Main'" each, with the rejected ones and why, for -v.
  [[nodiscard]] const std::vector<std::string>& choices() const { return choices_; }

 private:
  struct Link {
    std::unique_ptr<effect::EffectRunner> runner;
    std::string path;
    std::vector<gbuffer::Request> from_source;    ///< of a picture source
    std::vector<gbuffer::Request> from_previous;  ///< of the effect before
    std::size_t warnings_taken = 0;
  };

  EffectChain(PictureStage& pictures, SceneStage* scene) : pictures_(pictures), scene_(scene) {}
  [[nodiscard]] Result<void> Add(const ChainOptions& options, std::size_t index);
  void SortRequests(Link& link, bool is_first);

  PictureStage& pictures_;
  SceneStage* scene_;
  std::vector<Link> links_;
  std::vector<gbuffer::Request> scene_requests_;
  std::vector<std::string> choices_;
};

}  // namespace burin::render

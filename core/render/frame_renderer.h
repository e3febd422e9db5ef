// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/gbuffer/environment_cube.h"
#include "core/gl/readback.h"
#include "core/render/effect_chain.h"
#include "core/render/plan.h"
#include "core/render/sink.h"

namespace burin::render {

/// What a FrameRenderer is made from besides the plan.
struct RendererInput {
  const scene::Scene* scene = nullptr;             ///< null: pictures
  bool has_source = true;                          ///< a scene or pictures
  bool is_opaque = false;                          ///< pictures whose alpha is 1 everywhere
  const image::Image* environment = nullptr;       ///< null: the built-in one
  std::optional<std::array<float, 4>> background;  ///< scene-linear, unassociated alpha
  overdraw::EdgeOptions edges;
  translucency::TranslucencyOptions translucency;
  int samples = 1;  ///< of a scene's colour, a pixel
  std::vector<std::shared_ptr<const fx::Effect>> effects;
  std::vector<std::string> techniques;
  std::vector<Assignments> parameters;
  std::vector<std::string> include_folders;
  std::shared_ptr<const image::ColorTransform> transform;
};

/// Source frames in, pixels out, on the context's thread: attributes, effects, the output's encoding where the device
/// can do it, and asynchronous read-back of up to kInFlight frames.
class FrameRenderer {
 public:
  static constexpr int kInFlight = 2;

  [[nodiscard]] static Result<std::unique_ptr<FrameRenderer>> Create(const Plan& plan, RendererInput input);

  /// Draws and queues the read-back. Not with kInFlight frames under way.
  [[nodiscard]] Result<void> Render(const SourceFrame& frame);
  [[nodiscard]] int in_flight() const { return static_cast<int>(numbers_.size()); }
  /// The oldest frame under way.
  [[nodiscard]] RenderedFrame Finish();

  [[nodiscard]] std::vector<std::string> TakeWarnings();
  /// What is worth a line of --verbose, each once.
  [[nodiscard]] std::vector<std::string> TakeNotes();
  [[nodiscard]] const std::vector<std::string>& choices() const;

 private:
  /// One attribute of --attributes and how it is read back.
  struct Layer {
    gbuffer::Attribute attribute;
    gl::Texture target;
    image::SampleType type = image::SampleType::kF32;
    int channels = 4;
    image::Encoding encoding = image::Encoding::kData;
    bool is_id = false;
  };

  explicit FrameRenderer(const Plan& plan);
  [[nodiscard]] Result<void> Build(RendererInput input);
  [[nodiscard]] Result<void> AddLayer(gbuffer::Attribute attribute);
  [[nodiscard]] Result<Picture> Upload(const SourceFrame& frame);
  [[nodiscard]] Result<Picture> DrawFrame(const SourceFrame& frame, const Picture& source);
  [[nodiscard]] Result<Picture> DrawSource(const SourceFrame& frame, const Picture& source);
  [[nodiscard]] Result<void> FillLayers(const SourceFrame& frame, const Picture& source);
  [[nodiscard]] Result<void> QueueFrame(const Picture& frame);
  [[nodiscard]] effect::FrameContext Context(const SourceFrame& frame) const;
  [[nodiscard]] gl::Format OutputFormat() const;

  const Plan& plan_;
  std::shared_ptr<const image::ColorTransform> transform_;
  std::unique_ptr<PictureStage> pictures_;
  std::unique_ptr<SceneStage> scene_;
  std::unique_ptr<gbuffer::EnvironmentCube> environment_;  ///< for effects
  std::unique_ptr<EffectChain> chain_;
  std::vector<Layer> layers_;
  bool is_opaque_ = false;
  image::Image luma_;    ///< of the picture, where that is all the effects look at
  gl::Texture upload_;   ///< the source's picture
  gl::Texture frame_;    ///< the frame when there is no effect
  gl::Texture encoded_;  ///< the frame in the output's encoding
  std::deque<long> numbers_;
  std::unique_ptr<gl::ReadbackRing> ring_;
};

}  // namespace burin::render

// SPDX-License-Identifier: Apache-2.0
#include "core/render/scene_stage.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <vector>

#include "core/gbuffer/storage.h"
#include "core/render/effect_material.h"

namespace burin::render {

SceneStage::SceneStage(const scene::Scene& scene, std::unique_ptr<gbuffer::SceneRenderer> renderer,
                       const SceneOptions& options, PictureStage& pictures)
    : scene_(&scene),
      renderer_(std::move(renderer)),
      background_(options.background),
      samples_(options.samples),
      pictures_(pictures) {}

Result<std::unique_ptr<SceneStage>> SceneStage::Create(const scene::Scene& scene, const SceneOptions& options,
                                                       PictureStage& pictures) {
  auto renderer = gbuffer::SceneRenderer::Create(scene, options.environment);
  if (!renderer) return std::unexpected(renderer.error());
  std::unique_ptr<SceneStage> stage(new SceneStage(scene, *std::move(renderer), options, pictures));
  stage->edges_ = overdraw::EdgeRenderer::Create(scene, options.edges);
  auto translucency = translucency::TranslucencyRenderer::Create(scene, options.environment, options.translucency);
  if (!translucency) return std::unexpected(translucency.error());
  stage->translucency_ = *std::move(translucency);
  if (options.samples > 1) {
    auto supersampler = gbuffer::Supersampler::Create(options.samples);
    if (!supersampler) return std::unexpected(supersampler.error());
    stage->supersampler_ = *std::move(supersampler);
  }
  return stage;
}

gbuffer::FrameInput SceneStage::Input(const SceneFrame& frame) const {
  gbuffer::FrameInput input;
  input.view = frame.view;
  input.previous_view = frame.previous_view;
  input.pose = &frame.pose;
  input.items = frame.items;
  input.background = background_;
  input.edges = edges_.get();
  input.translucency = translucency_.get();
  return input;
}

std::vector<std::string> SceneStage::TakeNotes() {
  std::vector<std::string> notes = edges_->TakeNotes();
  if (translucency_) std::ranges::move(translucency_->TakeNotes(), std::back_inserter(notes));
  return notes;
}

std::vector<std::string> SceneStage::TakeWarnings() {
  return translucency_ ? translucency_->TakeWarnings() : std::vector<std::string>();
}

Result<void> SceneStage::Fill(const SceneFrame& frame, std::span<const gbuffer::Request> requests) {
  edges_->BeginFrame();
  std::vector<gbuffer::Request> direct;
  std::vector<gbuffer::Request> through_transform;
  std::map<std::pair<int, int>, std::vector<gbuffer::Request>> supersampled;
  for (const gbuffer::Request& request : requests) {
    if (supersampler_ && gbuffer::IsColorClass(request.attribute)) {
      supersampled[{request.target->width(), request.target->height()}].push_back(request);
      continue;
    }
    const bool is_plain = pictures_.transform().is_srgb() || request.encoding != image::Encoding::kDisplay ||
                          !gbuffer::Info(request.attribute).is_color;
    (is_plain ? direct : through_transform).push_back(request);
  }
  if (!direct.empty()) {
    if (auto filled = renderer_->Render(Input(frame), direct); !filled) return filled;
  }
  for (const gbuffer::Request& request : through_transform) {
    if (auto filled = FillThroughTransform(frame, request); !filled) return filled;
  }
  for (const auto& [size, of_size] : supersampled) {
    if (auto filled = FillSupersampled(frame, of_size); !filled) return filled;
  }
  return {};
}

Result<void> SceneStage::FillThroughTransform(const SceneFrame& frame, const gbuffer::Request& request) {
  using gbuffer::Attribute;
  const gl::Format format = gl::PlainFormat(gl::Numeric::kFloat, 32, 4);
  if (auto good = EnsureTexture(linear_, format, request.target->width(), request.target->height(), "linear colour");
      !good) {
    return good;
  }
  // Intensity follows from the display colour; the other colours are pictures by themselves.
  const bool is_intensity = request.attribute == Attribute::kIntensity;
  const gbuffer::Request linear{is_intensity ? Attribute::kColor : request.attribute, &linear_,
                                image::Encoding::kSceneLinear};
  if (auto filled = renderer_->Render(Input(frame), {&linear, 1}); !filled) return filled;
  const gbuffer::Request display{is_intensity ? Attribute::kIntensity : Attribute::kColor, request.target,
                                 image::Encoding::kDisplay};
  return pictures_.Fill(linear_, image::Encoding::kSceneLinear, {&display, 1});
}

Result<void> SceneStage::FillSupersampled(const SceneFrame& frame, std::span<const gbuffer::Request> requests) {
  const gl::Texture& target = *requests.front().target;
  const auto color = supersampler_->Render(*renderer_, Input(frame), target.width(), target.height());
  if (!color) {
    return Fail(color.error().kind, fmt::format("{}x{} at --samples {}: {}", target.width(), target.height(), samples_,
                                                color.error().message));
  }
  return pictures_.Fill(**color, image::Encoding::kSceneLinear, requests);
}

effect::SceneDraws SceneStage::Draws(const SceneFrame& frame) {
  return [this, &frame]() -> Result<std::vector<effect::SceneDraw>> {
    auto geometry = renderer_->Draws(Input(frame));
    if (!geometry) return std::unexpected(geometry.error());
    std::vector<effect::SceneDraw> draws;
    for (const gbuffer::GeometryDraw& item : *geometry) {
      draws.push_back({.world_from_object = item.world_from_object,
                       .draw =
                           [item] {
                             glBindVertexArray(item.vertex_array);
                             glDrawElements(item.mode, item.index_count, GL_UNSIGNED_INT, nullptr);
                             glBindVertexArray(0);
                           },
                       .material = MaterialFor(*scene_, item.material),
                       .texture =
                           [this, material = item.material](effect::TextureMeaning meaning, bool is_decoded) {
                             return MaterialTextureFor(*renderer_, material, meaning, is_decoded);
                           }});
    }
    return draws;
  };
}

}  // namespace burin::render

// SPDX-License-Identifier: Apache-2.0
#include "core/render/frame_renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <iterator>

#include "core/image/convert.h"
#include "core/image/luma.h"

namespace burin::render {
namespace {

using image::Encoding;
using image::SampleType;

/// Bounded attributes and colours are exact enough in half; distances, positions and motions are not.
bool FitsHalf(const gbuffer::AttributeInfo& info) {
  using enum gbuffer::Attribute;
  return info.is_color || info.attribute == kAlpha || info.attribute == kRoughness || info.attribute == kMetallic ||
         info.attribute == kFacing;
}

/// What a texture's samples are read as without loss.
SampleType NaturalType(const gl::Format& format) {
  if (format.numeric == gl::Numeric::kFloat) return format.bits > 16 ? SampleType::kF32 : SampleType::kF16;
  return format.bits > 8 ? SampleType::kU16 : SampleType::kU8;
}

gl::Format FormatOf(SampleType type, int components) {
  switch (type) {
    case SampleType::kU8:
      return gl::PlainFormat(gl::Numeric::kUnorm, 8, components);
    case SampleType::kU16:
      return gl::PlainFormat(gl::Numeric::kUnorm, 16, components);
    case SampleType::kF16:
      return gl::PlainFormat(gl::Numeric::kFloat, 16, components);
    case SampleType::kU32:
    case SampleType::kF32:
      break;
  }
  return gl::PlainFormat(gl::Numeric::kFloat, 32, components);
}

}  // namespace

FrameRenderer::FrameRenderer(const Plan& plan) : plan_(plan) {}

Result<std::unique_ptr<FrameRenderer>> FrameRenderer::Create(const Plan& plan, RendererInput input) {
  std::unique_ptr<FrameRenderer> renderer(new FrameRenderer(plan));
  if (auto built = renderer->Build(std::move(input)); !built) return std::unexpected(built.error());
  return renderer;
}

Result<void> FrameRenderer::Build(RendererInput input) {
  transform_ = input.transform;
  is_opaque_ = input.is_opaque;
  auto pictures = PictureStage::Create(transform_);
  if (!pictures) return std::unexpected(pictures.error());
  pictures_ = *std::move(pictures);
  if (input.scene != nullptr) {
    SceneOptions options;
    options.environment = input.environment;
    options.samples = input.samples;
    options.edges = input.edges;
    options.translucency = input.translucency;
    if (input.background) {
      const auto& [r, g, b, a] = *input.background;
      options.background = {r * a, g * a, b * a, a};
    }
    auto scene = SceneStage::Create(*input.scene, options, *pictures_);
    if (!scene) return std::unexpected(scene.error());
    scene_ = *std::move(scene);
  }
  ChainOptions options;
  options.effects = std::move(input.effects);
  options.techniques = std::move(input.techniques);
  options.parameters = std::move(input.parameters);
  options.include_folders = std::move(input.include_folders);
  options.has_source = input.has_source;
  environment_ = std::make_unique<gbuffer::EnvironmentCube>(input.environment);
  options.environment = [cube = environment_.get()] { return cube->id(); };
  options.width = plan_.width;
  options.height = plan_.height;
  const SampleType type = plan_.output.type;
  options.display_frame_format = FormatOf(type == SampleType::kU8 ? SampleType::kU8 : SampleType::kU16, 4);
  options.linear_frame_format =
      FormatOf(type == SampleType::kU16 || type == SampleType::kF32 ? SampleType::kF32 : SampleType::kF16, 4);
  if (!options.effects.empty()) {
    auto chain = EffectChain::Create(options, *pictures_, scene_.get());
    if (!chain) return std::unexpected(chain.error());
    chain_ = *std::move(chain);
  }
  for (const gbuffer::Attribute attribute : plan_.layers) {
    if (auto added = AddLayer(attribute); !added) return added;
  }
  const int copies = (plan_.has_frame ? 1 : 0) + static_cast<int>(layers_.size());
  ring_ = std::make_unique<gl::ReadbackRing>(copies * kInFlight);
  return {};
}

Result<void> FrameRenderer::AddLayer(gbuffer::Attribute attribute) {
  const gbuffer::AttributeInfo& info = gbuffer::Info(attribute);
  Layer layer;
  layer.attribute = attribute;
  if (plan_.output.is_exr) {
    const bool is_half = FitsHalf(info) && plan_.output.type != SampleType::kF32;
    layer.type = is_half ? SampleType::kF16 : SampleType::kF32;
    layer.channels = info.components;
    layer.encoding = info.is_color ? Encoding::kSceneLinear : Encoding::kData;
    layer.is_id = info.is_id;
  } else {
    layer.type = plan_.output.type;
    layer.encoding = info.is_color ? Encoding::kDisplay : Encoding::kData;
  }
  // GL knows no renderable three-component formats for sure.
  const int components = layer.channels == 3 ? 4 : layer.channels;
  auto target = gl::Texture::Create(FormatOf(layer.type, components), plan_.width, plan_.height, 1,
                                    fmt::format("layer {}", info.name));
  if (!target) return std::unexpected(target.error());
  layer.target = *std::move(target);
  layers_.push_back(std::move(layer));
  return {};
}

Result<void> FrameRenderer::Render(const SourceFrame& frame) {
  auto source = Upload(frame);
  if (!source) return std::unexpected(source.error());
  if (auto filled = FillLayers(frame, *source); !filled) return filled;
  if (plan_.has_frame) {
    auto drawn = DrawFrame(frame, *source);
    if (!drawn) return std::unexpected(drawn.error());
    if (auto queued = QueueFrame(*drawn); !queued) return queued;
  }
  for (const Layer& layer : layers_) ring_->Start(layer.target, layer.type, layer.channels, layer.encoding);
  numbers_.push_back(frame.number);
  return {};
}

Result<Picture> FrameRenderer::Upload(const SourceFrame& frame) {
  if (frame.scene) return Picture{};
  if (!frame.picture) {
    if (!upload_) {
      const image::Image nothing = image::MakeImage(1, 1, 4, SampleType::kU8, Encoding::kDisplay);
      if (auto good = EnsureTexture(upload_, gl::FormatFor(nothing), 1, 1, "no picture"); !good) {
        return std::unexpected(good.error());
      }
      upload_.Upload(nothing);
    }
    return Picture{&upload_, Encoding::kDisplay};
  }
  const image::Image& picture = *frame.picture;
  if (chain_) {
    const gl::Format format = gl::FormatFor(picture);
    if (gl::Texture* const target =
            chain_->CopyTarget(format, picture.width, picture.height, picture.encoding, is_opaque_)) {
      target->Upload(picture);
      return Picture{target, picture.encoding};
    }
    const bool is_rgba8 = picture.channels == 4 && picture.type == SampleType::kU8;
    if (is_rgba8 && is_opaque_ && layers_.empty()) {
      if (gl::Texture* const target = chain_->LumaTarget(picture.width, picture.height, picture.encoding)) {
        image::LumaOfRgba8(picture, luma_);
        target->Upload(luma_);
        return Picture{target, picture.encoding};
      }
    }
  }
  if (auto good = EnsureTexture(upload_, gl::FormatFor(picture), picture.width, picture.height, "source picture");
      !good) {
    return std::unexpected(good.error());
  }
  upload_.Upload(picture);
  return Picture{&upload_, picture.encoding};
}

Result<void> FrameRenderer::FillLayers(const SourceFrame& frame, const Picture& source) {
  std::vector<gbuffer::Request> requests;
  for (const Layer& layer : layers_) requests.push_back({layer.attribute, &layer.target, layer.encoding});
  if (frame.scene) {
    // One call for effects and layers, so that they share geometry passes.
    if (chain_) requests.insert(requests.end(), chain_->scene_requests().begin(), chain_->scene_requests().end());
    return requests.empty() ? Result<void>() : scene_->Fill(*frame.scene, requests);
  }
  return requests.empty() ? Result<void>() : pictures_->Fill(*source.texture, source.encoding, requests);
}

effect::FrameContext FrameRenderer::Context(const SourceFrame& frame) const {
  effect::FrameContext context;
  if (frame.scene) {
    context = frame.scene->context;
  } else {
    // A picture lies at z = 0, fills the view of an eye in front of it without perspective, and is lit from above left.
    context.has_scene = false;
    context.eye_world = {0.0f, 0.0f, 1.0f};
    context.view_from_world = glm::translate(glm::mat4(1.0f), -context.eye_world);
    context.clip_from_view = glm::orthoRH_ZO(-1.0f, 1.0f, -1.0f, 1.0f, 0.0f, 2.0f);
    context.previous_view_from_world = context.view_from_world;
    context.previous_clip_from_view = context.clip_from_view;
    context.light_direction_world = glm::normalize(glm::vec3(0.45f, -0.75f, -0.6f));
    context.scene_radius = 1.0f;
  }
  context.frame = frame.number;
  context.time_s = static_cast<double>(frame.number - 1) / plan_.rate.value();
  context.elapsed_s = 1.0 / plan_.rate.value();
  context.width = plan_.width;
  context.height = plan_.height;
  return context;
}

Result<Picture> FrameRenderer::DrawFrame(const SourceFrame& frame, const Picture& source) {
  if (chain_) return chain_->Run(Context(frame), source, frame.scene.get());
  return DrawSource(frame, source);
}

Result<Picture> FrameRenderer::DrawSource(const SourceFrame& frame, const Picture& source) {
  // The device converts to and from sRGB by itself; other transforms are the sink's, from what the source holds.
  const Encoding held = frame.scene ? Encoding::kSceneLinear : source.encoding;
  const Encoding encoding = transform_->is_srgb() ? plan_.output.encoding : held;
  gl::Format format = OutputFormat();
  if (encoding != plan_.output.encoding) {
    format = FormatOf(encoding == Encoding::kSceneLinear ? SampleType::kF32 : SampleType::kU16, 4);
  }
  if (auto good = EnsureTexture(frame_, format, plan_.width, plan_.height, "frame"); !good) {
    return std::unexpected(good.error());
  }
  const gbuffer::Request request{gbuffer::Attribute::kColor, &frame_, encoding};
  const auto filled = frame.scene ? scene_->Fill(*frame.scene, {&request, 1})
                                  : pictures_->Fill(*source.texture, source.encoding, {&request, 1});
  if (!filled) return std::unexpected(filled.error());
  return Picture{&frame_, encoding};
}

gl::Format FrameRenderer::OutputFormat() const { return FormatOf(plan_.output.type, 4); }

Result<void> FrameRenderer::QueueFrame(const Picture& frame) {
  const bool same = frame.encoding == plan_.output.encoding || frame.encoding == Encoding::kData;
  if (same) {
    ring_->Start(*frame.texture, NaturalType(frame.texture->format()), 4, plan_.output.encoding);
    return {};
  }
  if (!transform_->is_srgb()) {  // OpenColorIO, in the sink
    ring_->Start(*frame.texture, SampleType::kF32, 4, frame.encoding);
    return {};
  }
  if (auto good = EnsureTexture(encoded_, OutputFormat(), plan_.width, plan_.height, "encoded frame"); !good)
    return good;
  const gbuffer::Request request{gbuffer::Attribute::kColor, &encoded_, plan_.output.encoding};
  if (auto filled = pictures_->Fill(*frame.texture, frame.encoding, {&request, 1}); !filled) return filled;
  ring_->Start(encoded_, plan_.output.type, 4, plan_.output.encoding);
  return {};
}

RenderedFrame FrameRenderer::Finish() {
  RenderedFrame frame;
  frame.number = numbers_.front();
  numbers_.pop_front();
  if (plan_.has_frame) frame.picture = ring_->Finish();
  for (const Layer& layer : layers_) {
    image::Image pixels = ring_->Finish();
    // Ids are whole numbers up to 2^24 in the float target: the conversion is exact.
    frame.layers.push_back(layer.is_id ? image::ToType(pixels, SampleType::kU32) : std::move(pixels));
  }
  if (!plan_.has_frame && !plan_.output.is_exr) {
    frame.picture = std::move(frame.layers.front());
    frame.layers.clear();
  }
  return frame;
}

std::vector<std::string> FrameRenderer::TakeNotes() {
  return scene_ ? scene_->TakeNotes() : std::vector<std::string>();
}

std::vector<std::string> FrameRenderer::TakeWarnings() {
  std::vector<std::string> warnings = scene_ ? scene_->TakeWarnings() : std::vector<std::string>();
  if (chain_) std::ranges::move(chain_->TakeWarnings(), std::back_inserter(warnings));
  return warnings;
}

const std::vector<std::string>& FrameRenderer::choices() const {
  static const std::vector<std::string> kNone;
  return chain_ ? chain_->choices() : kNone;
}

}  // namespace burin::render

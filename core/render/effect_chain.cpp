// SPDX-License-Identifier: Apache-2.0
#include "core/render/effect_chain.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/render/effect_textures.h"

namespace burin::render {
namespace {

bool FollowsFromFrame(gbuffer::Attribute attribute) {
  using enum gbuffer::Attribute;
  return attribute == kColor || attribute == kIntensity || attribute == kAlpha;
}

/// Whether reading `target` gives what reading `picture` does when both hold the same bits.
bool ReadsAlike(const gl::Format& picture, const gl::Format& target, bool is_opaque) {
  const bool same_colors = std::equal(picture.swizzle.begin(), picture.swizzle.begin() + 3, target.swizzle.begin());
  return picture.internal == target.internal && same_colors && (picture.swizzle[3] == target.swizzle[3] || is_opaque);
}

Error WithPath(Error error, const std::string& path) {
  if (error.message.find(path) == std::string::npos) error.message = fmt::format("{}: {}", path, error.message);
  return error;
}

}  // namespace

Result<std::unique_ptr<EffectChain>> EffectChain::Create(const ChainOptions& options, PictureStage& pictures,
                                                         SceneStage* scene) {
  std::unique_ptr<EffectChain> chain(new EffectChain(pictures, scene));
  for (std::size_t i = 0; i < options.effects.size(); ++i) {
    if (auto added = chain->Add(options, i); !added) return std::unexpected(added.error());
  }
  return chain;
}

Result<void> EffectChain::Add(const ChainOptions& options, std::size_t index) {
  const std::shared_ptr<const fx::Effect>& effect = options.effects[index];
  effect::RunnerOptions runner_options;
  runner_options.technique = options.techniques[index];
  runner_options.parameters = options.parameters[index];
  runner_options.load_texture = TextureLoaderFor(effect->path, options.include_folders);
  runner_options.texture_folders = TextureFolders(effect->path, options.include_folders);
  runner_options.environment = options.environment;
  runner_options.open_effect = EffectOpenerFor(effect->path, options.include_folders);
  runner_options.has_source = options.has_source;
  runner_options.has_scene = scene_ != nullptr;
  runner_options.width = options.width;
  runner_options.height = options.height;
  runner_options.display_frame_format = options.display_frame_format;
  runner_options.linear_frame_format = options.linear_frame_format;
  auto runner = effect::EffectRunner::Create(effect, runner_options);
  if (!runner) return std::unexpected(WithPath(runner.error(), effect->path));
  Link link;
  link.runner = *std::move(runner);
  link.path = effect->path;
  if (link.runner->needs_scene() && scene_ == nullptr) {
    return Fail(ErrorKind::kInput,
                fmt::format("{}: it draws the geometry of a scene, but the source is none", effect->path));
  }
  const effect::TechniqueChoice& choice = link.runner->choice();
  choices_.push_back(fmt::format("{}: technique '{}'", effect->path, effect->techniques[choice.technique].name));
  for (const auto& [name, reason] : choice.rejected) {
    choices_.push_back(fmt::format("{}: not technique '{}': {}", effect->path, name, reason));
  }
  SortRequests(link, index == 0);
  links_.push_back(std::move(link));
  return {};
}

void EffectChain::SortRequests(Link& link, bool is_first) {
  for (const effect::AttributeTarget& target : link.runner->attributes()) {
    const auto attribute = gbuffer::FindAttribute(target.attribute);
    if (!attribute) continue;  // a custom one, which the runner fills
    const gbuffer::Request request{*attribute, target.texture, target.encoding};
    if (!is_first && FollowsFromFrame(*attribute)) {
      link.from_previous.push_back(request);
    } else if (scene_ != nullptr) {
      scene_requests_.push_back(request);
    } else {
      link.from_source.push_back(request);
    }
  }
}

gl::Texture* EffectChain::CopyTarget(const gl::Format& format, int width, int height, image::Encoding encoding,
                                     bool is_opaque) {
  for (const gbuffer::Request& request : links_.front().from_source) {
    const gl::Texture& target = *request.target;
    const bool is_picture =
        request.attribute == gbuffer::Attribute::kColor || request.attribute == gbuffer::Attribute::kVideo;
    if (is_picture && request.encoding == encoding && target.width() == width && target.height() == height &&
        ReadsAlike(format, target.format(), is_opaque)) {
      // An attribute's target is the caller's to fill; only drawing into it needs no more than a const reference.
      return const_cast<gl::Texture*>(request.target);
    }
  }
  return nullptr;
}

gl::Texture* EffectChain::LumaTarget(int width, int height, image::Encoding encoding) {
  const gbuffer::Request* only = nullptr;
  for (const Link& link : links_) {
    for (const gbuffer::Request& request : link.from_source) {
      if (only != nullptr) return nullptr;
      only = &request;
    }
  }
  if (only == nullptr || only->attribute != gbuffer::Attribute::kIntensity || only->encoding != encoding)
    return nullptr;
  const gl::Texture& target = *only->target;
  const gl::Format& format = target.format();
  const bool is_l8 =
      format.numeric == gl::Numeric::kUnorm && format.bits == 8 && format.components == 1 && gl::IsLuminance(format);
  if (!is_l8 || target.width() != width || target.height() != height) return nullptr;
  return const_cast<gl::Texture*>(only->target);  // as in CopyTarget()
}

Result<Picture> EffectChain::Run(const effect::FrameContext& context, const Picture& source, const SceneFrame* scene) {
  Picture picture = source;
  const effect::SceneDraws draws = scene != nullptr ? scene_->Draws(*scene) : effect::SceneDraws();
  for (Link& link : links_) {
    std::vector<gbuffer::Request> from_source = link.from_source;
    std::erase_if(from_source, [&source](const gbuffer::Request& request) {
      return request.target == source.texture;  // uploaded there: CopyTarget()
    });
    if (!from_source.empty()) {
      if (auto filled = pictures_.Fill(*source.texture, source.encoding, from_source); !filled) {
        return std::unexpected(filled.error());
      }
    }
    if (!link.from_previous.empty()) {
      if (auto filled = pictures_.Fill(*picture.texture, picture.encoding, link.from_previous); !filled) {
        return std::unexpected(filled.error());
      }
    }
    auto frame = link.runner->Run(context, draws);
    if (!frame) return std::unexpected(WithPath(frame.error(), link.path));
    picture = {*frame, link.runner->frame_encoding()};
  }
  return picture;
}

std::vector<std::string> EffectChain::TakeWarnings() {
  std::vector<std::string> warnings;
  for (Link& link : links_) {
    const std::vector<std::string>& all = link.runner->warnings();
    for (; link.warnings_taken < all.size(); ++link.warnings_taken) {
      const std::string& warning = all[link.warnings_taken];
      warnings.push_back(warning.find(link.path) == std::string::npos ? fmt::format("{}: {}", link.path, warning)
                                                                      : warning);
    }
  }
  return warnings;
}

}  // namespace burin::render

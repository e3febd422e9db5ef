// SPDX-License-Identifier: Apache-2.0
#include "core/effect/texture_store.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "core/effect/cube_texture.h"
#include "core/effect/srgb_view.h"
#include "core/effect/target_format.h"
#include "core/gl/framebuffer.h"

namespace burin::effect {
namespace {

// Whether any sampler of the texture looks at its smaller levels; a state that is not known yet may.
bool NeedsMipmaps(const fx::Effect& effect, std::size_t texture) {
  for (const fx::Sampler& sampler : effect.samplers) {
    if (sampler.texture != texture) continue;
    for (const fx::SamplerState& state : sampler.states) {
      if (state.name != fx::SamplerStateName::kMipFilter && state.name != fx::SamplerStateName::kMaxMipLevel) continue;
      const auto* value = std::get_if<fx::Value>(&state.value);
      if (value == nullptr || (!value->numbers.empty() && value->numbers[0] != 0)) return true;
    }
  }
  return false;
}

// Whether something better than a stand-in is at hand wherever the texture is looked up.
bool IsGivenByHost(const fx::Effect& effect, const Schedule& schedule, std::size_t texture, TextureMeaning meaning,
                   const RunnerOptions& options) {
  if (meaning == TextureMeaning::kEnvironment) return static_cast<bool>(options.environment);
  if (!IsOfMaterial(meaning)) return false;
  for (const Step& step : schedule.steps) {
    if (step.kind != Step::Kind::kPass) continue;
    const auto samplers = fx::SamplersOf(effect.techniques[step.technique].passes[step.pass]);
    const bool looks = std::any_of(samplers.begin(), samplers.end(),
                                   [&](std::size_t sampler) { return effect.samplers[sampler].texture == texture; });
    const bool is_given =
        step.draws_scene || (step.shows_source && options.has_source && meaning == TextureMeaning::kBaseColor);
    if (looks && !is_given) return false;
  }
  return true;
}

// Direct3D 9 itself has no such look-ups; what some of its drivers gave for them is a shadow map's comparison.
void WarnOfDepthLookUps(const fx::Effect& effect, const Schedule& schedule, std::vector<std::string>& warnings) {
  std::set<std::size_t> told;
  for (const Step& step : schedule.steps) {
    if (step.kind != Step::Kind::kPass) continue;
    for (const std::size_t sampler : fx::SamplersOf(effect.techniques[step.technique].passes[step.pass])) {
      const auto& texture = effect.samplers[sampler].texture;
      const auto* role = texture ? std::get_if<fx::ScriptTargetRole>(&effect.textures[*texture].role) : nullptr;
      if (role == nullptr || !role->is_depth_stencil || !told.insert(*texture).second) continue;
      warnings.push_back(fmt::format("{}: texture '{}' is a depth-stencil target: looked up, it is white", effect.path,
                                     effect.textures[*texture].name));
    }
  }
}

std::string_view InsteadOf(TextureMeaning meaning) {
  return meaning == TextureMeaning::kEnvironment ? "the surroundings are shown" : "what is drawn gives its own";
}

}  // namespace

Result<TextureStore> TextureStore::Create(const fx::Effect& effect, Schedule& schedule, const Overrides& overrides,
                                          const RunnerOptions& options, std::vector<std::string>& warnings) {
  TextureStore store;
  store.slots_.resize(effect.textures.size());
  for (std::size_t i = 0; i < effect.textures.size(); ++i) {
    store.slots_[i].meaning = MeaningOf(effect.textures[i]);
    store.slots_[i].is_file = std::holds_alternative<fx::FileRole>(effect.textures[i].role);
  }
  for (const auto* group : {&schedule.attributes, &schedule.custom_attributes, &schedule.pass_results}) {
    for (const std::size_t index : *group) {
      if (auto added = store.AddTarget(effect, index, schedule.texture_sizes[index]); !added) {
        return std::unexpected(added.error());
      }
    }
  }
  WarnOfDepthLookUps(effect, schedule, warnings);
  for (const std::size_t index : schedule.files) {
    const bool is_given = IsGivenByHost(effect, schedule, index, store.slots_[index].meaning, options);
    if (auto added = store.AddFile(effect, index, overrides, options, is_given, warnings); !added) {
      return std::unexpected(added.error());
    }
    if (const gl::Texture* texture = store.texture(index)) {
      schedule.texture_sizes[index] = {texture->width(), texture->height()};
    }
  }
  return store;
}

Result<void> TextureStore::AddTarget(const fx::Effect& effect, std::size_t index, glm::ivec2 size) {
  const fx::Texture& declared = effect.textures[index];
  auto texture = gl::Texture::Create(TargetFormat(declared.format), size.x, size.y, 1,
                                     fmt::format("{}: {}", effect.path, declared.name));
  if (!texture) return std::unexpected(texture.error());
  slots_[index].texture = std::move(*texture);
  return {};
}

Result<void> TextureStore::AddFile(const fx::Effect& effect, std::size_t index, const Overrides& overrides,
                                   const RunnerOptions& options, bool is_given_by_host,
                                   std::vector<std::string>& warnings) {
  const fx::Texture& declared = effect.textures[index];
  const auto overridden = overrides.textures.find(index);
  const bool is_asked_for = overridden != overrides.textures.end();
  const std::string& file = is_asked_for ? overridden->second : std::get<fx::FileRole>(declared.role).file;
  const std::string_view otherwise = is_given_by_host ? InsteadOf(slots_[index].meaning) : "a stand-in is used";
  const auto stand_in = [&](std::string_view why) {
    warnings.push_back(fmt::format("{}: texture '{}' {}: {}", effect.path, declared.name, why, otherwise));
    return Result<void>();
  };
  if (file.empty()) return is_given_by_host ? Result<void>() : stand_in("names no file");
  const bool is_default = !is_asked_for && IsDefaultFile(file);
  const bool is_cube = declared.dimension == fx::Dimension::kCube;
  const bool is_flat = declared.dimension == fx::Dimension::k2D || declared.dimension == fx::Dimension::kUnknown;
  const bool can_load = static_cast<bool>(options.load_texture) && (is_flat || is_cube);
  if (!can_load && is_default && is_given_by_host) return {};
  if (!is_flat && !is_cube) return stand_in(fmt::format("is not two-dimensional, and '{}' is", file));
  if (!can_load) return stand_in("cannot be loaded here");
  auto image = options.load_texture(file);
  if (!image) {
    return Fail(image.error().kind,
                fmt::format("texture '{}' of {}: {}", declared.name, effect.path, image.error().message));
  }
  if (!image->has_value()) {
    const std::string missing = fmt::format("'{}' not found; searched: {}", file, options.texture_folders);
    if (is_asked_for)
      return Fail(ErrorKind::kInput, fmt::format("texture '{}' of {}: {}", declared.name, effect.path, missing));
    if (is_default && is_given_by_host) return {};
    return is_default ? stand_in(fmt::format("names the default '{}'", file))
                      : stand_in(fmt::format("names a file that is not there ({})", missing));
  }
  const image::Image& picture = **image;
  if (is_cube) {
    auto cube = CubeTextureOf(picture, fmt::format("texture '{}' of {} ({})", declared.name, effect.path, file));
    if (!cube) {
      return Fail(cube.error().kind,
                  fmt::format("texture '{}' of {}: {}: {}", declared.name, effect.path, file, cube.error().message));
    }
    slots_[index].other = std::move(*cube);
    return {};
  }
  auto texture =
      gl::Texture::Create(gl::FormatFor(picture), picture.width, picture.height, NeedsMipmaps(effect, index) ? 0 : 1,
                          fmt::format("texture '{}' of {} ({})", declared.name, effect.path, file));
  if (!texture) return std::unexpected(texture.error());
  texture->Upload(picture);
  texture->GenerateMipmaps();
  slots_[index].texture = std::move(*texture);
  return {};
}

const gl::Texture* TextureStore::texture(std::size_t index) const {
  return slots_[index].texture ? &slots_[index].texture : nullptr;
}

bool TextureStore::AddSrgbView(std::size_t index) {
  Slot& slot = slots_[index];
  if (!slot.texture) return true;  // stand-ins decode to themselves, near enough
  if (!slot.srgb) slot.srgb = CreateSrgbView(slot.texture);
  return static_cast<bool>(slot.srgb);
}

std::uint32_t TextureStore::srgb_view(std::size_t index) const { return slots_[index].srgb.id(); }

std::uint32_t TextureStore::ForSampler(const fx::Sampler& sampler, bool srgb) const {
  const bool is_2d = sampler.dimension == fx::Dimension::k2D || sampler.dimension == fx::Dimension::kUnknown;
  if (!sampler.texture) return stand_ins_.Get(MeaningOf(sampler), sampler.dimension);
  const Slot& slot = slots_[*sampler.texture];
  if (slot.other) return slot.other.id();
  if (is_2d && srgb && slot.srgb) return slot.srgb.id();
  if (is_2d && slot.texture) return slot.texture.id();
  return stand_ins_.Get(slot.meaning, sampler.dimension);
}

std::optional<TextureMeaning> TextureStore::HostMeaning(const fx::Sampler& sampler) const {
  if (!sampler.texture) return MeaningOf(sampler);
  const Slot& slot = slots_[*sampler.texture];
  if (!slot.is_file || slot.texture || slot.other) return std::nullopt;
  return slot.meaning;
}

Result<const gl::Texture*> TextureStore::DepthStencil(glm::ivec2 size, std::optional<std::size_t> owner) {
  gl::Texture& buffer = depth_stencils_[{size.x, size.y, owner}];
  if (!buffer) {
    auto created = gl::CreateDepthStencil(size.x, size.y, fmt::format("depth-stencil {}x{}", size.x, size.y));
    if (!created) return std::unexpected(created.error());
    buffer = std::move(*created);
  }
  return &buffer;
}

}  // namespace burin::effect

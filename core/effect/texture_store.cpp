// SPDX-License-Identifier: Apache-2.0
#include "core/effect/texture_store.h"

#include <algorithm>
#include <array>

#include <epoxy/gl.h>
#include <fmt/format.h>

#include "core/effect/srgb_view.h"
#include "core/effect/target_format.h"
#include "core/effect/text.h"
#include "core/gl/framebuffer.h"

namespace burin::effect {
namespace {

using Pixel = std::array<std::uint8_t, 4>;
constexpr Pixel kWhite = {255, 255, 255, 255};
constexpr Pixel kFlatNormal = {128, 128, 255, 255};
constexpr Pixel kMidGrey = {128, 128, 128, 255};

// FX Composer's library names these for textures that the user will replace; none of them comes with the effects.
constexpr std::string_view kDefaultFiles[] = {"default_color.dds", "default_reflection.dds", "default_bump_normal.dds",
                                              "default_gloss.dds"};

gl::TextureHandle OneTexel(GLenum target, const Pixel& pixel) {
  GLuint id = 0;
  glCreateTextures(target, 1, &id);
  gl::TextureHandle texture(id);
  switch (target) {
    case GL_TEXTURE_1D:
      glTextureStorage1D(id, 1, GL_RGBA8, 1);
      glTextureSubImage1D(id, 0, 0, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
      break;
    case GL_TEXTURE_3D:
      glTextureStorage3D(id, 1, GL_RGBA8, 1, 1, 1);
      glTextureSubImage3D(id, 0, 0, 0, 0, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
      break;
    case GL_TEXTURE_CUBE_MAP:
      glTextureStorage2D(id, 1, GL_RGBA8, 1, 1);
      for (GLint face = 0; face < 6; ++face) {
        glTextureSubImage3D(id, 0, 0, 0, face, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
      }
      break;
    default:
      glTextureStorage2D(id, 1, GL_RGBA8, 1, 1);
      glTextureSubImage2D(id, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
      break;
  }
  return texture;
}

bool IsNormalMap(const fx::Texture& texture) {
  const std::string name = LowerCase(texture.name);
  return EqualsIgnoringCase(texture.semantic, "normal") || name.find("normal") != std::string::npos ||
         name.find("bump") != std::string::npos;
}

bool IsDefaultFile(const std::string& file) {
  const std::size_t folder = file.find_last_of("/\\");
  const std::string name = LowerCase(folder == std::string::npos ? file : file.substr(folder + 1));
  return std::find(std::begin(kDefaultFiles), std::end(kDefaultFiles), name) != std::end(kDefaultFiles);
}

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

}  // namespace

Result<TextureStore> TextureStore::Create(const fx::Effect& effect, Schedule& schedule, const Overrides& overrides,
                                          const TextureLoader& load, std::vector<std::string>& warnings) {
  TextureStore store;
  store.slots_.resize(effect.textures.size());
  for (const fx::Texture& texture : effect.textures) store.is_normal_map_.push_back(IsNormalMap(texture));
  store.AddStandIns();
  for (const auto* group : {&schedule.attributes, &schedule.custom_attributes, &schedule.pass_results}) {
    for (const std::size_t index : *group) {
      if (auto added = store.AddTarget(effect, index, schedule.texture_sizes[index]); !added) {
        return std::unexpected(added.error());
      }
    }
  }
  for (const std::size_t index : schedule.files) {
    if (auto added = store.AddFile(effect, index, overrides, load, warnings); !added) {
      return std::unexpected(added.error());
    }
    if (const gl::Texture* texture = store.texture(index)) {
      schedule.texture_sizes[index] = {texture->width(), texture->height()};
    }
  }
  return store;
}

void TextureStore::AddStandIns() {
  stand_ins_.emplace(fx::Dimension::k1D, OneTexel(GL_TEXTURE_1D, kWhite));
  stand_ins_.emplace(fx::Dimension::k2D, OneTexel(GL_TEXTURE_2D, kWhite));
  stand_ins_.emplace(fx::Dimension::k3D, OneTexel(GL_TEXTURE_3D, kWhite));
  stand_ins_.emplace(fx::Dimension::kCube, OneTexel(GL_TEXTURE_CUBE_MAP, kMidGrey));
  flat_normal_ = OneTexel(GL_TEXTURE_2D, kFlatNormal);
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
                                   const TextureLoader& load, std::vector<std::string>& warnings) {
  const fx::Texture& declared = effect.textures[index];
  const auto overridden = overrides.textures.find(index);
  const std::string& file =
      overridden != overrides.textures.end() ? overridden->second : std::get<fx::FileRole>(declared.role).file;
  const auto stand_in = [&](std::string_view why) {
    warnings.push_back(fmt::format("{}: texture '{}' {}: a stand-in is used", effect.path, declared.name, why));
    return Result<void>();
  };
  if (file.empty()) return stand_in("names no file");
  if (declared.dimension != fx::Dimension::k2D && declared.dimension != fx::Dimension::kUnknown) {
    return stand_in(fmt::format("is not two-dimensional, and '{}' is", file));
  }
  if (!load) return stand_in("cannot be loaded here");
  auto image = load(file);
  if (!image) {
    if (overridden == overrides.textures.end() && IsDefaultFile(file)) {
      return stand_in(fmt::format("names the default '{}'", file));
    }
    return Fail(image.error().kind,
                fmt::format("texture '{}' of {}: {}", declared.name, effect.path, image.error().message));
  }
  auto texture = gl::Texture::Create(gl::FormatFor(*image), image->width, image->height,
                                     NeedsMipmaps(effect, index) ? 0 : 1,
                                     fmt::format("texture '{}' of {} ({})", declared.name, effect.path, file));
  if (!texture) return std::unexpected(texture.error());
  texture->Upload(*image);
  texture->GenerateMipmaps();
  slots_[index].texture = std::move(*texture);
  return {};
}

const gl::Texture* TextureStore::texture(std::size_t index) const {
  return slots_[index].texture ? &slots_[index].texture : nullptr;
}

bool TextureStore::AddSrgbView(std::size_t index) {
  Slot& slot = slots_[index];
  if (!slot.texture) return true;   // stand-ins decode to themselves, near enough
  if (!slot.srgb) slot.srgb = CreateSrgbView(slot.texture);
  return static_cast<bool>(slot.srgb);
}

std::uint32_t TextureStore::srgb_view(std::size_t index) const { return slots_[index].srgb.id(); }

std::uint32_t TextureStore::ForSampler(const fx::Sampler& sampler, bool srgb) const {
  if (sampler.texture && slots_[*sampler.texture].procedural) return slots_[*sampler.texture].procedural.id();
  const bool is_2d = sampler.dimension == fx::Dimension::k2D || sampler.dimension == fx::Dimension::kUnknown;
  if (sampler.texture && is_2d) {
    const Slot& slot = slots_[*sampler.texture];
    if (srgb && slot.srgb) return slot.srgb.id();
    if (slot.texture) return slot.texture.id();
    if (is_normal_map_[*sampler.texture]) return flat_normal_.id();
  }
  const auto found = stand_ins_.find(is_2d ? fx::Dimension::k2D : sampler.dimension);
  return found->second.id();
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

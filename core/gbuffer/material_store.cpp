// SPDX-License-Identifier: Apache-2.0
#include "core/gbuffer/material_store.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "core/gbuffer/geometry_shader.h"
#include "core/gbuffer/material_texture.h"
#include "core/gl/debug.h"
#include "core/gl/device_choice.h"

namespace burin::gbuffer {
namespace {

constexpr float kMaxAnisotropy = 8.0f;

struct TextureRole {
  const scene::TextureUse scene::Material::*use;
  DrawFeature feature;
  bool is_color;  ///< sRGB by glTF's definition
};
// In the order of MaterialTexture.
constexpr std::array<TextureRole, kMaterialTextures> kRoles = {{
    {&scene::Material::base_color_texture, kHasBaseColorTexture, true},
    {&scene::Material::metallic_roughness_texture, kHasMetallicRoughnessTexture, false},
    {&scene::Material::normal_texture, kHasNormalTexture, false},
    {&scene::Material::occlusion_texture, kHasOcclusionTexture, false},
    {&scene::Material::emissive_texture, kHasEmissiveTexture, true},
}};

GLint WrapOf(scene::Wrap wrap) {
  switch (wrap) {
    case scene::Wrap::kRepeat:
      return GL_REPEAT;
    case scene::Wrap::kClampToEdge:
      return GL_CLAMP_TO_EDGE;
    case scene::Wrap::kMirroredRepeat:
      return GL_MIRRORED_REPEAT;
  }
  return GL_REPEAT;
}

GLint MinFilterOf(const scene::TextureSampler& sampler) {
  const bool linear = sampler.min == scene::Filter::kLinear;
  if (!sampler.mipmaps) return linear ? GL_LINEAR : GL_NEAREST;
  if (sampler.mip == scene::Filter::kLinear) return linear ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_LINEAR;
  return linear ? GL_LINEAR_MIPMAP_NEAREST : GL_NEAREST_MIPMAP_NEAREST;
}

std::uint32_t SamplerKey(const scene::TextureSampler& sampler) {
  return static_cast<std::uint32_t>(sampler.wrap_s) | static_cast<std::uint32_t>(sampler.wrap_t) << 4 |
         static_cast<std::uint32_t>(sampler.mag) << 8 | static_cast<std::uint32_t>(sampler.min) << 12 |
         static_cast<std::uint32_t>(sampler.mip) << 16 | static_cast<std::uint32_t>(sampler.mipmaps) << 20;
}

// Hardware filters along the footprint for next to nothing; a software rasterizer takes every sample by itself.
float DeviceAnisotropy() {
  if (!epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic")) return 1.0f;
  const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  if (renderer != nullptr && gl::IsSoftwareRenderer(renderer)) return 1.0f;
  GLfloat most = 1.0f;
  glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &most);
  return std::min(most, kMaxAnisotropy);
}

}  // namespace

MaterialBlock MakeMaterialBlock(const scene::Material& material) {
  MaterialBlock block{};
  block.base_color = material.base_color;
  block.emissive = glm::vec4(material.emissive, material.alpha_cutoff);
  block.factors = glm::vec4(material.metallic, material.roughness, material.normal_scale, material.occlusion_strength);
  const float ratio = (material.ior - 1.0f) / (material.ior + 1.0f);  // Fresnel at normal incidence, from air
  block.reflectance = glm::vec4(ratio * ratio);
  for (std::size_t i = 0; i < kMaterialTextures; ++i) {
    const scene::TextureUse& use = material.*kRoles[i].use;
    const glm::mat3& m = use.uv_transform;
    block.uv_rows[2 * i] = glm::vec4(m[0][0], m[1][0], m[2][0], static_cast<float>(use.texcoord));
    block.uv_rows[2 * i + 1] = glm::vec4(m[0][1], m[1][1], m[2][1], 0.0f);
  }
  return block;
}

MaterialStore::MaterialStore(const scene::Scene& scene) : scene_(&scene), anisotropy_(DeviceAnisotropy()) {
  // The default material comes first, so that kNone + 1 is its place.
  const std::size_t stride = AlignBlock(sizeof(MaterialBlock));
  std::vector<std::byte> bytes(stride * (scene.materials.size() + 1));
  for (std::size_t i = 0; i <= scene.materials.size(); ++i) {
    const MaterialBlock block = MakeMaterialBlock(i == 0 ? default_ : scene.materials[i - 1]);
    std::memcpy(bytes.data() + i * stride, &block, sizeof(block));
  }
  GLuint id = 0;
  glCreateBuffers(1, &id);
  blocks_ = gl::BufferHandle(id);
  glNamedBufferStorage(id, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), 0);
  gl::SetLabel(GL_BUFFER, id, "materials");
}

const scene::Material& MaterialStore::Get(int material) const {
  return material == scene::kNone ? default_ : scene_->materials.at(static_cast<std::size_t>(material));
}

std::uint32_t MaterialStore::Features(int material) const {
  const scene::Material& source = Get(material);
  std::uint32_t features = 0;
  for (const TextureRole& role : kRoles) {
    if (source.*role.use) features |= role.feature;
  }
  if (source.unlit) features |= kIsUnlit;
  if (source.alpha_mode == scene::AlphaMode::kMask) features |= kIsMasked;
  return features;
}

Result<void> MaterialStore::Bind(int material, std::uint32_t features) {
  const auto stride = static_cast<GLintptr>(AlignBlock(sizeof(MaterialBlock)));
  glBindBufferRange(GL_UNIFORM_BUFFER, kMaterialBinding, blocks_.id(), (material + 1) * stride, sizeof(MaterialBlock));
  const scene::Material& source = Get(material);
  for (std::size_t unit = 0; unit < kMaterialTextures; ++unit) {
    if ((features & kRoles[unit].feature) == 0) continue;
    const scene::TextureUse& use = source.*kRoles[unit].use;
    const Result<const gl::Texture*> texture = TextureOfImage(use.image, kRoles[unit].is_color);
    if (!texture) return std::unexpected(texture.error());
    glBindTextureUnit(static_cast<GLuint>(unit), (*texture)->id());
    glBindSampler(static_cast<GLuint>(unit), SamplerOf(use.sampler));
  }
  return {};
}

Result<const gl::Texture*> MaterialStore::TextureOf(int material, MaterialTextureKind kind, bool is_decoded) {
  const scene::TextureUse& use = Get(material).*kRoles[static_cast<std::size_t>(kind)].use;
  if (!use) return nullptr;
  return TextureOfImage(use.image, is_decoded);
}

Result<const gl::Texture*> MaterialStore::TextureOfImage(int image, bool is_color) {
  const std::pair key(image, is_color);
  auto found = textures_.find(key);
  if (found == textures_.end()) {
    const auto index = static_cast<std::size_t>(image);
    Result<gl::Texture> texture =
        UploadMaterialTexture(scene_->images.at(index), is_color, fmt::format("{}: images[{}]", scene_->path, index));
    if (!texture) return std::unexpected(texture.error());
    found = textures_.emplace(key, std::move(*texture)).first;
  }
  return &found->second;
}

std::uint32_t MaterialStore::SamplerOf(const scene::TextureSampler& sampler) {
  const auto [entry, is_new] = samplers_.try_emplace(SamplerKey(sampler));
  if (is_new) {
    GLuint id = 0;
    glCreateSamplers(1, &id);
    entry->second = gl::SamplerHandle(id);
    glSamplerParameteri(id, GL_TEXTURE_WRAP_S, WrapOf(sampler.wrap_s));
    glSamplerParameteri(id, GL_TEXTURE_WRAP_T, WrapOf(sampler.wrap_t));
    glSamplerParameteri(id, GL_TEXTURE_MAG_FILTER, sampler.mag == scene::Filter::kLinear ? GL_LINEAR : GL_NEAREST);
    glSamplerParameteri(id, GL_TEXTURE_MIN_FILTER, MinFilterOf(sampler));
    if (anisotropy_ > 1.0f && MinFilterOf(sampler) == GL_LINEAR_MIPMAP_LINEAR) {
      glSamplerParameterf(id, GL_TEXTURE_MAX_ANISOTROPY_EXT, anisotropy_);
    }
  }
  return entry->second.id();
}

}  // namespace burin::gbuffer

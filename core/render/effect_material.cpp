// SPDX-License-Identifier: Apache-2.0
#include "core/render/effect_material.h"

#include <algorithm>
#include <glm/common.hpp>

#include "core/image/srgb.h"

namespace burin::render {
namespace {

constexpr float kLeastPower = 4.0f;
constexpr float kMostPower = 128.0f;

float Encode(float linear) { return image::SrgbFromLinear(std::clamp(linear, 0.0f, 1.0f)); }

glm::vec3 Encode(const glm::vec3& linear) { return {Encode(linear.r), Encode(linear.g), Encode(linear.b)}; }

// Blinn and Phong's exponent for a roughness: Karis, "Specular BRDF Reference" (2013), 2 / alpha^2 - 2, in bounds that
// effects of the fixed pipeline's time are made for.
float SpecularPower(float roughness) {
  const float alpha = std::max(roughness * roughness, 1.0e-3f);
  return std::clamp(2.0f / (alpha * alpha) - 2.0f, kLeastPower, kMostPower);
}

}  // namespace

effect::MaterialContext MaterialFor(const scene::Scene& scene, int material) {
  static const scene::Material kDefault;
  const bool is_own = material >= 0 && static_cast<std::size_t>(material) < scene.materials.size();
  const scene::Material& source = is_own ? scene.materials[static_cast<std::size_t>(material)] : kDefault;
  effect::MaterialContext context;
  context.index = is_own ? material : -1;
  context.has_texture = static_cast<bool>(source.base_color_texture);
  const glm::vec3 base(source.base_color);
  context.diffuse =
      glm::vec4(Encode(base), source.alpha_mode == scene::AlphaMode::kOpaque ? 1.0f : source.base_color.a);
  context.emissive = Encode(source.emissive);
  // What a metal does not scatter it reflects in its own colour; what is rough shows little of a highlight.
  const glm::vec3 reflected =
      glm::mix(glm::vec3(0.04f), base, source.metallic_roughness_texture ? 0.0f : source.metallic);
  context.specular = Encode(reflected) * (1.0f - 0.5f * source.roughness);
  context.specular_power = SpecularPower(source.roughness);
  return context;
}

std::uint32_t MaterialTextureFor(gbuffer::SceneRenderer& renderer, int material, effect::TextureMeaning meaning,
                                 bool is_decoded) {
  using effect::TextureMeaning;
  using Kind = gbuffer::MaterialTextureKind;
  Kind kind = Kind::kBaseColor;
  switch (meaning) {
    case TextureMeaning::kBaseColor:
      break;
    case TextureMeaning::kNormal:
      kind = Kind::kNormal;
      break;
    case TextureMeaning::kEmissive:
      kind = Kind::kEmissive;
      break;
    case TextureMeaning::kOcclusion:
      kind = Kind::kOcclusion;
      break;
    default:
      return 0;
  }
  const auto texture = renderer.TextureOf(material, kind, is_decoded);
  return texture && *texture != nullptr ? (*texture)->id() : 0;
}

}  // namespace burin::render

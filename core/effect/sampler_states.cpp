// SPDX-License-Identifier: Apache-2.0
#include "core/effect/sampler_states.h"

#include <algorithm>

#include <epoxy/gl.h>
#include <fmt/format.h>

#include "core/effect/render_states.h"

namespace burin::effect {
namespace {

constexpr std::array<std::string_view, static_cast<std::size_t>(fx::SamplerStateName::kCount)> kNames = {
    "AddressU", "AddressV", "AddressW", "BorderColor", "MagFilter", "MinFilter", "MipFilter", "MipMapLodBias",
    "MaxMipLevel", "MaxAnisotropy", "SRGBTexture"};

constexpr int kLinear = 2;
constexpr int kAnisotropic = 3;
constexpr int kMaxLevel = 31;

GLint Address(int d3d) {
  constexpr GLint kModes[] = {GL_REPEAT, GL_MIRRORED_REPEAT, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER,
                              GL_MIRROR_CLAMP_TO_EDGE};
  return kModes[d3d - 1];
}

GLint MinFilter(const SamplerStates& states) {
  const bool linear = states.min_filter >= kLinear;
  if (!states.uses_mipmaps()) return linear ? GL_LINEAR : GL_NEAREST;
  if (states.mip_filter >= kLinear) return linear ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_LINEAR;
  return linear ? GL_LINEAR_MIPMAP_NEAREST : GL_NEAREST_MIPMAP_NEAREST;
}

}  // namespace

std::string_view StateName(fx::SamplerStateName name) { return kNames[static_cast<std::size_t>(name)]; }

std::string SetState(SamplerStates& states, fx::SamplerStateName name, const fx::Value& value) {
  if (value.numbers.empty()) return fmt::format("{} has no number for a value", StateName(name));
  const double number = value.numbers[0];
  std::string fault;
  const auto enumerant = [&](int& target, int first, int last) {
    if (number >= first && number <= last) {
      target = static_cast<int>(number);
    } else {
      fault = fmt::format("{} is {}, not one of {} to {}", StateName(name), number, first, last);
    }
  };
  switch (name) {
    case fx::SamplerStateName::kAddressU: enumerant(states.address[0], 1, 5); break;
    case fx::SamplerStateName::kAddressV: enumerant(states.address[1], 1, 5); break;
    case fx::SamplerStateName::kAddressW: enumerant(states.address[2], 1, 5); break;
    case fx::SamplerStateName::kBorderColor: states.border = ColorFromState(value); break;
    case fx::SamplerStateName::kMagFilter: enumerant(states.mag_filter, 0, kAnisotropic); break;
    case fx::SamplerStateName::kMinFilter: enumerant(states.min_filter, 0, kAnisotropic); break;
    case fx::SamplerStateName::kMipFilter: enumerant(states.mip_filter, 0, kAnisotropic); break;
    case fx::SamplerStateName::kMipMapLodBias: states.lod_bias = static_cast<float>(number); break;
    case fx::SamplerStateName::kMaxMipLevel: enumerant(states.max_mip_level, 0, kMaxLevel); break;
    case fx::SamplerStateName::kMaxAnisotropy: enumerant(states.max_anisotropy, 1, 16); break;
    case fx::SamplerStateName::kSrgbTexture: states.srgb = number != 0; break;
    case fx::SamplerStateName::kCount: break;
  }
  return fault;
}

gl::SamplerHandle CreateSampler() {
  GLuint id = 0;
  glCreateSamplers(1, &id);
  return gl::SamplerHandle(id);
}

void UpdateSampler(const gl::SamplerHandle& sampler, const SamplerStates& states) {
  const GLuint id = sampler.id();
  constexpr GLenum kWraps[] = {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R};
  for (std::size_t i = 0; i < 3; ++i) glSamplerParameteri(id, kWraps[i], Address(states.address[i]));
  glSamplerParameterfv(id, GL_TEXTURE_BORDER_COLOR, states.border.data());
  glSamplerParameteri(id, GL_TEXTURE_MIN_FILTER, MinFilter(states));
  glSamplerParameteri(id, GL_TEXTURE_MAG_FILTER, states.mag_filter >= kLinear ? GL_LINEAR : GL_NEAREST);
  glSamplerParameterf(id, GL_TEXTURE_LOD_BIAS, states.lod_bias);
  const auto level = static_cast<float>(states.max_mip_level);
  glSamplerParameterf(id, GL_TEXTURE_MIN_LOD, states.max_mip_level > 0 ? level : -1000.0f);
  // MipFilter None with a MaxMipLevel stays on that level.
  glSamplerParameterf(id, GL_TEXTURE_MAX_LOD, states.mip_filter == 0 && states.max_mip_level > 0 ? level : 1000.0f);
  const bool anisotropic = states.min_filter == kAnisotropic || states.mag_filter == kAnisotropic;
  if (epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic") ||
      epoxy_has_gl_extension("GL_ARB_texture_filter_anisotropic")) {
    float limit = 1.0f;
    glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &limit);
    const float degree = anisotropic ? std::min(limit, static_cast<float>(states.max_anisotropy)) : 1.0f;
    glSamplerParameterf(id, GL_TEXTURE_MAX_ANISOTROPY_EXT, degree);
  }
}

}  // namespace burin::effect

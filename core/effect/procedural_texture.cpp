// SPDX-License-Identifier: Apache-2.0
#include "core/effect/procedural_texture.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

#include "core/effect/pass_program.h"
#include "core/effect/target_format.h"
#include "core/gl/framebuffer.h"
#include "core/gl/fullscreen_quad.h"
#include "core/gl/state.h"

namespace burin::effect {
namespace {

constexpr int kFaces = 6;

GLenum TargetOf(fx::Dimension dimension) {
  switch (dimension) {
    case fx::Dimension::k1D:
      return GL_TEXTURE_1D;
    case fx::Dimension::k3D:
      return GL_TEXTURE_3D;
    case fx::Dimension::kCube:
      return GL_TEXTURE_CUBE_MAP;
    case fx::Dimension::k2D:
    case fx::Dimension::kUnknown:
      break;
  }
  return GL_TEXTURE_2D;
}

gl::TextureHandle Allocate(const fx::Texture& texture, const fx::ProceduralRole& role, GLenum target,
                           const std::string& label) {
  GLuint id = 0;
  glCreateTextures(target, 1, &id);
  gl::TextureHandle handle(id);
  glObjectLabel(GL_TEXTURE, id, static_cast<GLsizei>(label.size()), label.data());
  const gl::Format format = TargetFormat(texture.format);
  const int longest = std::max({role.width, role.height, role.depth});
  const int levels = std::bit_width(static_cast<unsigned>(longest));
  if (target == GL_TEXTURE_1D)
    glTextureStorage1D(id, levels, format.internal, role.width);
  else if (target == GL_TEXTURE_3D)
    glTextureStorage3D(id, levels, format.internal, role.width, role.height, role.depth);
  else
    glTextureStorage2D(id, levels, format.internal, role.width, role.height);
  glTextureParameteriv(id, GL_TEXTURE_SWIZZLE_RGBA, format.swizzle.data());
  return handle;
}

}  // namespace

Result<gl::TextureHandle> FillProceduralTexture(const fx::Effect& effect, std::size_t texture,
                                                const ParameterValues& values) {
  const fx::Texture& declared = effect.textures[texture];
  const auto& role = std::get<fx::ProceduralRole>(declared.role);
  const std::string label = fmt::format("texture '{}' of {}", declared.name, effect.path);
  auto program = PassProgram::Create(effect, role.program, label);
  if (!program) return std::unexpected(program.error());
  auto quad = gl::FullscreenQuad::Create();
  if (!quad) return std::unexpected(quad.error());
  const GLenum target = TargetOf(declared.dimension);
  gl::TextureHandle handle = Allocate(declared, role, target, label);
  GLuint framebuffer = 0;
  glCreateFramebuffers(1, &framebuffer);
  const gl::FramebufferHandle framebuffer_handle(framebuffer);

  gl::ResetState();
  glDisable(GL_CULL_FACE);
  glDisable(GL_DEPTH_TEST);
  glViewport(0, 0, role.width, role.height);
  program->Use(values, {});
  const bool is_cube = target == GL_TEXTURE_CUBE_MAP;
  const int layers = is_cube ? kFaces : role.depth;
  for (int layer = 0; layer < layers; ++layer) {
    if (layers > 1 || target == GL_TEXTURE_3D)
      glNamedFramebufferTextureLayer(framebuffer, GL_COLOR_ATTACHMENT0, handle.id(), 0, layer);
    else
      glNamedFramebufferTexture(framebuffer, GL_COLOR_ATTACHMENT0, handle.id(), 0);
    if (glCheckNamedFramebufferStatus(framebuffer, GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
      return Fail(ErrorKind::kFailed, label + ": this device cannot draw into a texture of its format and size");
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    program->SetTexel({1.0f / static_cast<float>(role.width), 1.0f / static_cast<float>(role.height),
                       is_cube ? 0.0f : 1.0f / static_cast<float>(role.depth), static_cast<float>(layer)});
    quad->Draw();
  }
  gl::ResetState();
  glGenerateTextureMipmap(handle.id());
  return handle;
}

}  // namespace burin::effect

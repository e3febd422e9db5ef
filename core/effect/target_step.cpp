// SPDX-License-Identifier: Apache-2.0
#include "core/effect/target_step.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/effect/srgb_view.h"
#include "core/effect/target_format.h"

namespace burin::effect {
namespace {

double NumberOf(const ParameterValues& values, std::optional<std::size_t> parameter, std::size_t component,
                double otherwise) {
  if (!parameter) return otherwise;
  const std::vector<double>& numbers = values.value(*parameter).numbers;
  return component < numbers.size() ? numbers[component] : otherwise;
}

}  // namespace

Result<TargetStep> TargetStep::Create(const fx::Effect& effect, const Step& step, const FrameTexture& frame,
                                      TextureStore& textures) {
  TargetStep result;
  result.step_ = step;
  std::vector<std::uint32_t> colors;
  if (step.targets.empty()) {
    colors.push_back(frame.texture->id());
    result.has_alpha_.push_back(true);
  }
  for (const std::size_t target : step.targets) {
    colors.push_back(textures.texture(target)->id());
    result.has_alpha_.push_back(HasAlpha(effect.textures[target].format));
  }
  std::uint32_t depth_stencil = 0;
  if (step.uses_depth_stencil) {
    const auto buffer = textures.DepthStencil(step.size, step.depth_stencil);
    if (!buffer) return std::unexpected(buffer.error());
    depth_stencil = (*buffer)->id();
  }
  const std::string label =
      fmt::format("{}: script of technique '{}'", effect.path, effect.techniques[step.technique].name);
  auto framebuffer = CreateFramebuffer(colors, depth_stencil, label);
  if (!framebuffer) return std::unexpected(framebuffer.error());
  result.framebuffer_ = std::move(*framebuffer);
  return result;
}

void TargetStep::Clear(const ParameterValues& values) const {
  const ClearStep& clear = step_.clear;
  glDisable(GL_SCISSOR_TEST);
  if (clear.color) {
    std::array<float, 4> color{};
    for (std::size_t i = 0; i < 4; ++i) color[i] = static_cast<float>(NumberOf(values, clear.color_parameter, i, 0.0));
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    for (std::size_t i = 0; i < has_alpha_.size(); ++i) {
      std::array<float, 4> own = color;
      if (!has_alpha_[i]) own[3] = 1.0f;
      glClearNamedFramebufferfv(framebuffer_.id(), GL_COLOR, static_cast<GLint>(i), own.data());
    }
  }
  const auto depth = static_cast<float>(std::clamp(NumberOf(values, clear.depth_parameter, 0, 1.0), 0.0, 1.0));
  const auto stencil = static_cast<GLint>(std::clamp(NumberOf(values, clear.stencil_parameter, 0, 0.0), 0.0, 255.0));
  // The first to touch a buffer in a frame leaves nothing of the frame before.
  const bool clears_depth = clear.depth || step_.clears_depth_stencil;
  const bool clears_stencil = clear.stencil || step_.clears_depth_stencil;
  glDepthMask(GL_TRUE);
  glStencilMask(0xFFFFFFFFu);
  if (clears_depth && clears_stencil) {
    glClearNamedFramebufferfi(framebuffer_.id(), GL_DEPTH_STENCIL, 0, clear.depth ? depth : 1.0f,
                              clear.stencil ? stencil : 0);
  } else if (clears_depth) {
    glClearNamedFramebufferfv(framebuffer_.id(), GL_DEPTH, 0, &depth);
  } else if (clears_stencil) {
    glClearNamedFramebufferiv(framebuffer_.id(), GL_STENCIL, 0, &stencil);
  }
}

void TargetStep::Copy(const gl::Texture& source) {
  if (!source_framebuffer_) {
    GLuint id = 0;
    glCreateFramebuffers(1, &id);
    source_framebuffer_ = gl::FramebufferHandle(id);
    glNamedFramebufferTexture(id, GL_COLOR_ATTACHMENT0, source.id(), 0);
  }
  glDisable(GL_SCISSOR_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  const bool same_size = source.width() == step_.size.x && source.height() == step_.size.y;
  glBlitNamedFramebuffer(source_framebuffer_.id(), framebuffer_.id(), 0, 0, source.width(), source.height(), 0, 0,
                         step_.size.x, step_.size.y, GL_COLOR_BUFFER_BIT, same_size ? GL_NEAREST : GL_LINEAR);
}

void TargetStep::Run(const ParameterValues& values, const gl::Texture& source) {
  if (step_.kind == Step::Kind::kClear)
    Clear(values);
  else
    Copy(source);
}

}  // namespace burin::effect

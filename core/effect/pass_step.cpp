// SPDX-License-Identifier: Apache-2.0
#include "core/effect/pass_step.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>

#include "core/effect/fixed_values.h"
#include "core/effect/srgb_view.h"
#include "core/effect/state_binder.h"
#include "core/effect/target_format.h"

namespace burin::effect {
namespace {

constexpr int kAllComponents = 15;
constexpr int kNoAlpha = 7;

// Direct3D 9 has its pixel centres on integers. As in wined3d, a little less than half a pixel, so that no edge of a
// quadrilateral falls on a pixel's centre.
constexpr float kHalfPixel = 63.0f / 64.0f;

bool SetsState(const fx::Pass& pass, fx::RenderState name) {
  return std::any_of(pass.states.begin(), pass.states.end(),
                     [&](const fx::PassState& state) { return state.name == name; });
}

const fx::Pass& PassOf(const fx::Effect& effect, const Step& step) {
  return effect.techniques[step.technique].passes[step.pass];
}

}  // namespace

Result<PassStep> PassStep::Create(const fx::Effect& effect, const Step& step, std::vector<PassProgram> programs,
                                  const FrameTexture& frame, TextureStore& textures, const fx::ParameterLookup& lookup,
                                  std::vector<std::string>& warnings) {
  PassStep result;
  result.step_ = step;
  const fx::Pass& pass = PassOf(effect, step);
  result.label_ = fmt::format("{}: technique '{}', pass {}", effect.path, effect.techniques[step.technique].name,
                              pass.name.empty() ? fmt::format("{}", step.pass) : fmt::format("'{}'", pass.name));
  result.lights_material_ =
      pass.fixed && pass.fixed->is_lit && std::ranges::none_of(pass.fixed->states, [](const fx::FixedState& state) {
        return state.name == fx::FixedName::kMaterialDiffuse;
      });
  for (const fx::PassState& state : pass.states) {
    if (const auto* value = std::get_if<fx::Value>(&state.value)) {
      if (const std::string fault = SetState(result.states_, state.name, *value); !fault.empty()) {
        warnings.push_back(fmt::format("{}: {}: ignored", result.label_, fault));
      }
    } else {
      result.dynamic_states_.push_back(&state);
    }
  }
  if (result.states_.scissor_test) {
    warnings.push_back(fmt::format("{}: ScissorTestEnable is ignored: there is no scissor rectangle", result.label_));
  }
  if (auto made = result.CreateTargets(effect, frame, textures, warnings); !made) return std::unexpected(made.error());
  const auto add = [&](const fx::ShaderProgram& shaders) {
    Variant variant{.program = std::move(programs[result.variants_.size()]), .samplers = {}};
    result.CreateSamplers(effect, shaders.samplers, textures, lookup, variant.samplers, warnings);
    result.variants_.push_back(std::move(variant));
  };
  add(pass.program);
  for (const fx::ShaderProgram& choice : pass.choices) {
    const bool is_there = !choice.vertex_glsl.empty();
    if (is_there) add(choice);
    result.choices_.push_back(is_there ? result.variants_.size() - 1 : 0);
  }
  return result;
}

Result<void> PassStep::CreateTargets(const fx::Effect& effect, const FrameTexture& frame, TextureStore& textures,
                                     std::vector<std::string>& warnings) {
  const fx::Pass& pass = PassOf(effect, step_);
  std::vector<std::uint32_t> colors;
  int written = pass.program.targets;
  for (const fx::ShaderProgram& choice : pass.choices) written = std::max(written, choice.targets);
  const auto add = [&](const gl::Texture& texture, int components, const std::array<float, 4>& clear) {
    writable_.push_back(static_cast<int>(colors.size()) < written ? components : 0);
    clear_colors_.push_back(clear);
    colors.push_back(texture.id());
  };
  if (step_.targets.empty()) add(*frame.texture, kAllComponents, frame.clear_color);
  for (const std::size_t target : step_.targets) {
    const fx::Texture& texture = effect.textures[target];
    add(*textures.texture(target), HasAlpha(texture.format) ? kAllComponents : kNoAlpha, ClearColor(texture));
  }
  std::uint32_t depth_stencil = 0;
  if (step_.uses_depth_stencil) {
    auto buffer = textures.DepthStencil(step_.size, step_.depth_stencil);
    if (!buffer) return std::unexpected(buffer.error());
    depth_stencil = (*buffer)->id();
  }
  auto framebuffer = CreateFramebuffer(colors, depth_stencil, label_);
  if (!framebuffer) return std::unexpected(framebuffer.error());
  framebuffer_ = std::move(*framebuffer);
  if (!SetsState(pass, fx::RenderState::kSrgbWriteEnable)) return {};
  auto srgb = CreateSrgbFramebuffer(effect, frame, textures, depth_stencil, warnings);
  if (!srgb) return std::unexpected(srgb.error());
  srgb_framebuffer_ = std::move(*srgb);
  return {};
}

Result<gl::FramebufferHandle> PassStep::CreateSrgbFramebuffer(const fx::Effect& effect, const FrameTexture& frame,
                                                              TextureStore& textures, std::uint32_t depth_stencil,
                                                              std::vector<std::string>& warnings) {
  std::vector<std::uint32_t> colors;
  const auto warn = [&](std::string_view what) {
    warnings.push_back(
        fmt::format("{}: SRGBWriteEnable has no effect on {}, whose format has no sRGB form", label_, what));
  };
  if (step_.targets.empty()) {
    if (!*frame.srgb) *frame.srgb = CreateSrgbView(*frame.texture);
    if (!*frame.srgb) warn("the frame");
    colors.push_back(*frame.srgb ? frame.srgb->id() : frame.texture->id());
  }
  for (const std::size_t target : step_.targets) {
    const bool has_view = textures.AddSrgbView(target);
    if (!has_view) warn(effect.textures[target].name);
    colors.push_back(has_view ? textures.srgb_view(target) : textures.texture(target)->id());
  }
  return CreateFramebuffer(colors, depth_stencil, label_);
}

void PassStep::CreateSamplers(const fx::Effect& effect, const std::vector<std::size_t>& samplers,
                              TextureStore& textures, const fx::ParameterLookup& lookup, std::vector<BoundSampler>& all,
                              std::vector<std::string>& warnings) {
  for (const std::size_t index : samplers) {
    const fx::Sampler& sampler = effect.samplers[index];
    BoundSampler bound{.index = index,
                       .sampler = CreateSampler(),
                       .states = {},
                       .is_dynamic = false,
                       .texture = 0,
                       .meaning = textures.HostMeaning(sampler)};
    bool may_be_srgb = false;
    for (const fx::SamplerState& state : sampler.states) {
      may_be_srgb |= state.name == fx::SamplerStateName::kSrgbTexture;
      std::optional<fx::Value> value;
      if (const auto* constant = std::get_if<fx::Value>(&state.value)) {
        value = *constant;
      } else {
        bound.is_dynamic = true;
        value = fx::EvaluateExpression(effect, *std::get<const fx::ast::Expression*>(state.value), lookup);
      }
      const std::string fault =
          value ? SetState(bound.states, state.name, *value) : fmt::format("{} has no value", StateName(state.name));
      if (!fault.empty())
        warnings.push_back(fmt::format("{}: sampler '{}': {}: ignored", effect.path, sampler.name, fault));
    }
    if (!sampler.texture) {
      const bool is_given = bound.meaning && IsOfMaterial(*bound.meaning) && (step_.draws_scene || step_.shows_source);
      if (!is_given)
        warnings.push_back(
            fmt::format("{}: sampler '{}' has no texture: a stand-in is used", effect.path, sampler.name));
    } else if (may_be_srgb && !textures.AddSrgbView(*sampler.texture)) {
      warnings.push_back(fmt::format("{}: sampler '{}': SRGBTexture has no effect on {}, whose format has no sRGB form",
                                     effect.path, sampler.name, effect.textures[*sampler.texture].name));
    }
    UpdateSampler(bound.sampler, bound.states);
    bound.texture = textures.ForSampler(sampler, bound.states.srgb);
    all.push_back(std::move(bound));
  }
}

void PassStep::Clear() const {
  // Clears go through the masks, so these are opened first; BindStates() sets them anew.
  if (step_.clears_targets) {
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    for (std::size_t i = 0; i < clear_colors_.size(); ++i) {
      glClearBufferfv(GL_COLOR, static_cast<GLint>(i), clear_colors_[i].data());
    }
  }
  if (step_.clears_depth_stencil) {
    glDepthMask(GL_TRUE);
    glStencilMask(0xFFFFFFFFu);
    glClearBufferfi(GL_DEPTH_STENCIL, 0, 1.0f, 0);
  }
}

HostUniforms PassStep::MakeHostUniforms(const fx::Effect& effect, const RenderStates& states) const {
  HostUniforms host;
  const auto width = static_cast<float>(step_.size.x);
  const auto height = static_cast<float>(step_.size.y);
  if (!effect.uses_extension) host.pixel_offset = {kHalfPixel / width, -kHalfPixel / height, 0, 0};
  constexpr float kAlways = 8.0f;
  host.alpha_test = {states.alpha_test ? static_cast<float>(states.alpha_func) : kAlways,
                     static_cast<float>(states.alpha_ref) / 255.0f};
  host.target_size = {width, height, 1.0f / width, 1.0f / height};
  return host;
}

void PassStep::BindSamplers(const fx::Effect& effect, const TextureStore& textures, const fx::ParameterLookup& lookup) {
  std::vector<BoundSampler>& samplers = variants_[current_].samplers;
  for (std::size_t unit = 0; unit < samplers.size(); ++unit) {
    BoundSampler& bound = samplers[unit];
    if (bound.is_dynamic) {
      const fx::Sampler& sampler = effect.samplers[bound.index];
      SamplerStates states = bound.states;
      for (const fx::SamplerState& state : sampler.states) {
        const auto* expression = std::get_if<const fx::ast::Expression*>(&state.value);
        if (expression == nullptr) continue;
        const auto value = fx::EvaluateExpression(effect, **expression, lookup);
        if (value) static_cast<void>(SetState(states, state.name, *value));
      }
      if (states != bound.states) {
        bound.states = states;
        UpdateSampler(bound.sampler, states);
        bound.texture = textures.ForSampler(sampler, states.srgb);
      }
    }
    glBindTextureUnit(static_cast<GLuint>(unit), bound.texture);
    glBindSampler(static_cast<GLuint>(unit), bound.sampler.id());
  }
}

Result<void> PassStep::Begin(const fx::Effect& effect, const TextureStore& textures, const ParameterValues& values,
                             const fx::ParameterLookup& lookup, std::vector<std::string>& warnings) {
  current_ = Choose(effect, lookup);
  RenderStates states = states_;
  for (const fx::PassState* state : dynamic_states_) {
    const auto value = fx::EvaluateExpression(effect, *std::get<const fx::ast::Expression*>(state->value), lookup);
    const std::string fault =
        value ? SetState(states, state->name, *value) : fmt::format("{} has no value", StateName(state->name));
    if (!fault.empty() && !said_bad_state_) {
      said_bad_state_ = true;
      warnings.push_back(fmt::format("{}: {}: ignored", label_, fault));
    }
  }
  const bool srgb = states.srgb_write && srgb_framebuffer_;
  glBindFramebuffer(GL_FRAMEBUFFER, srgb ? srgb_framebuffer_.id() : framebuffer_.id());
  glViewport(0, 0, step_.size.x, step_.size.y);
  glDisable(GL_SCISSOR_TEST);
  Clear();
  BindStates(states, {.writable = writable_, .has_depth_stencil = step_.uses_depth_stencil},
             /*front_is_clockwise=*/true);
  BindSamplers(effect, textures, lookup);
  variants_[current_].program.Use(values, MakeHostUniforms(effect, states));
  return {};
}

// The variant that the parameters choose now; an index outside its array is its nearest end.
std::size_t PassStep::Choose(const fx::Effect& effect, const fx::ParameterLookup& lookup) const {
  if (choices_.empty()) return 0;
  const fx::Pass& pass = PassOf(effect, step_);
  const auto index = [&](const fx::ShaderChoice& choice) -> std::size_t {
    if (choice.index == nullptr) return 0;
    const auto value = fx::EvaluateExpression(effect, *choice.index, lookup);
    const double at = value && !value->numbers.empty() ? value->numbers[0] : 0.0;
    return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(choice.count - 1)));
  };
  return choices_[index(pass.vertex_choice) * pass.pixel_choice.count + index(pass.pixel_choice)];
}

void PassStep::UpdateObject(const fx::Effect& effect, const ParameterValues& values, const FrameContext& context,
                            const fx::ParameterLookup& lookup) {
  PassProgram& program = variants_[current_].program;
  program.UpdateParameters(values);
  const fx::Pass& pass = PassOf(effect, step_);
  if (pass.fixed && program.has_fixed()) program.SetFixed(FixedValues(effect, *pass.fixed, context, lookup));
}

bool PassStep::Shows(TextureMeaning meaning) const {
  const std::vector<BoundSampler>& samplers = variants_[current_].samplers;
  return std::any_of(samplers.begin(), samplers.end(),
                     [&](const BoundSampler& bound) { return bound.meaning == meaning; });
}

void PassStep::BindHostTextures(const std::function<std::uint32_t(TextureMeaning, bool)>& texture) const {
  if (!texture) return;
  const std::vector<BoundSampler>& samplers = variants_[current_].samplers;
  for (std::size_t unit = 0; unit < samplers.size(); ++unit) {
    const BoundSampler& bound = samplers[unit];
    if (!bound.meaning) continue;
    const std::uint32_t given = texture(*bound.meaning, bound.states.srgb);
    glBindTextureUnit(static_cast<GLuint>(unit), given != 0 ? given : bound.texture);
  }
}

void PassStep::SetFrontFace(bool clockwise) const { glFrontFace(clockwise ? GL_CW : GL_CCW); }

void PassStep::End() const {
  for (std::size_t unit = 0; unit < variants_[current_].samplers.size(); ++unit) {
    glBindSampler(static_cast<GLuint>(unit), 0);
    glBindTextureUnit(static_cast<GLuint>(unit), 0);
  }
}

}  // namespace burin::effect

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "fx_parser/effect/effect.h"

namespace burin::effect {

/// Effects put together without the front end.
class EffectBuilder {
 public:
  EffectBuilder() { effect.path = "test.fx"; }

  std::size_t Texture(const std::string& name, decltype(fx::Texture::role) role,
                      fx::Format format = fx::Format::kA8R8G8B8, double scale = 1.0) {
    fx::Texture texture;
    texture.name = name;
    texture.role = std::move(role);
    texture.format = format;
    texture.scale = scale;
    effect.textures.push_back(std::move(texture));
    return effect.textures.size() - 1;
  }
  /// A sampler of the texture, by its index.
  std::size_t Sampler(std::size_t texture) {
    fx::Sampler sampler;
    sampler.name = "s" + std::to_string(effect.samplers.size());
    sampler.texture = texture;
    effect.samplers.push_back(std::move(sampler));
    return effect.samplers.size() - 1;
  }
  fx::Parameter& Parameter(const std::string& name, const fx::Type& type, const std::string& semantic = {}) {
    fx::Parameter parameter;
    parameter.name = name;
    parameter.type = type;
    parameter.semantic = semantic;
    parameter.default_value.type = type;
    parameter.default_value.numbers.assign(static_cast<std::size_t>(type.components()), 0.0);
    effect.parameters.push_back(std::move(parameter));
    return effect.parameters.back();
  }
  fx::Technique& Technique(const std::string& name, const std::string& custom_attribute = {}) {
    fx::Technique technique;
    technique.name = name;
    technique.custom_attribute = custom_attribute;
    effect.techniques.push_back(std::move(technique));
    return effect.techniques.back();
  }
  /// A pass that looks up `samplers` and draws into `targets` (none: the frame).
  static fx::Pass Pass(std::vector<std::size_t> samplers, std::vector<std::size_t> targets = {}) {
    fx::Pass pass;
    pass.program.samplers = std::move(samplers);
    pass.targets = std::move(targets);
    return pass;
  }
  static fx::EffectAnnotation Text(const std::string& name, const std::string& value) {
    fx::EffectAnnotation annotation;
    annotation.name = name;
    annotation.value.type.kind = fx::TypeKind::kString;
    annotation.value.strings = {value};
    return annotation;
  }
  static fx::PassState Set(fx::RenderState name, double number) {
    fx::PassState state;
    state.name = name;
    fx::Value value;
    value.type = fx::ScalarType(fx::Scalar::kInt);
    value.numbers = {number};
    state.value = std::move(value);
    return state;
  }

  fx::Effect effect;
};

}  // namespace burin::effect

// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/effect/effect.h"

#include <algorithm>

#include "fx_parser/effect/case.h"

namespace burin::fx {

const EffectAnnotation* FindAnnotation(const std::vector<EffectAnnotation>& annotations, std::string_view name) {
  for (const EffectAnnotation& annotation : annotations) {
    if (EqualsIgnoringCase(annotation.name, name)) return &annotation;
  }
  return nullptr;
}

std::vector<std::size_t> SamplersOf(const Pass& pass) {
  std::vector<std::size_t> samplers = pass.program.samplers;
  for (const ShaderProgram& choice : pass.choices) {
    for (const std::size_t sampler : choice.samplers) {
      if (std::ranges::find(samplers, sampler) == samplers.end()) samplers.push_back(sampler);
    }
  }
  return samplers;
}

}  // namespace burin::fx

// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/effect/effect.h"

#include "fx_parser/effect/case.h"

namespace burin::fx {

const EffectAnnotation* FindAnnotation(const std::vector<EffectAnnotation>& annotations, std::string_view name) {
  for (const EffectAnnotation& annotation : annotations) {
    if (EqualsIgnoringCase(annotation.name, name)) return &annotation;
  }
  return nullptr;
}

}  // namespace burin::fx

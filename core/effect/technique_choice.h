// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/image/image.h"
#include "core/effect/effect_runner.h"
#include "fx_parser/effect/effect.h"

namespace burin::effect {

/// Of the technique's annotation `string ColorSpace = "linear" | "display"`.
[[nodiscard]] std::optional<image::Encoding> AnnotatedEncoding(const fx::Technique& technique);

/// Moves on to the next technique that the effect itself allows, noting why others before it are not; false at the end.
[[nodiscard]] bool NextTechnique(const fx::Effect& effect, TechniqueChoice& choice);

}  // namespace burin::effect

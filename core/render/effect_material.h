// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/effect/effect_runner.h"
#include "core/gbuffer/attribute_renderer.h"
#include "core/scene/scene.h"

namespace burin::render {

/// glTF's material in the terms of the fixed pipeline: colours display-encoded, a highlight as sharp as the surface is
/// smooth. `material`: scene::kNone for the default one.
[[nodiscard]] effect::MaterialContext MaterialFor(const scene::Scene& scene, int material);

/// effect::SceneDraw::texture. Specular maps do not exist in glTF.
[[nodiscard]] std::uint32_t MaterialTextureFor(gbuffer::SceneRenderer& renderer, int material,
                                               effect::TextureMeaning meaning, bool is_decoded);

}  // namespace burin::render

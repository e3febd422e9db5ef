// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string_view>

#include "core/effect/frame_context.h"

namespace burin::effect {

/// Which light a name means: "Light", "PointLight1", "SpotLight_0", "lamp 2"; empty for what is none. Lower case.
[[nodiscard]] std::optional<std::size_t> LightOf(std::string_view object);

/// The light of that number; empty when the scene has not so many.
[[nodiscard]] std::optional<LightContext> LightAt(const FrameContext& context, std::size_t index);

/// Where a light stands; one from far away is put a few of the scene's radii off.
[[nodiscard]] glm::vec3 PositionOf(const LightContext& light, const FrameContext& context);
/// Towards which it shines: one with a place at the scene's middle.
[[nodiscard]] glm::vec3 DirectionOf(const LightContext& light, const FrameContext& context);

/// The scene as a light sees it, for shadow maps: from its place towards the scene's middle, the scene's sphere filling
/// the picture.
struct LightView {
  glm::mat4 view_from_world{1.0f};
  glm::mat4 clip_from_view{1.0f};
  glm::vec3 eye_world{0.0f};
};
/// A light that is not there is the key light.
[[nodiscard]] LightView LightViewOf(const FrameContext& context, std::size_t index);

}  // namespace burin::effect

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "core/base/error.h"
#include "core/gbuffer/attribute_renderer.h"
#include "core/gbuffer/geometry_pass.h"
#include "core/gbuffer/gpu_blocks.h"

namespace burin::gbuffer {

/// What scatters light in a frame, ready to draw.
struct TranslucencyInput {
  const FrameInput* frame = nullptr;
  const FrameDraws* draws = nullptr;
  MaterialStore* materials = nullptr;
  std::span<const LightRecord> lights;  ///< bound at kLightBinding already
  float environment_strength = 1.0f;    ///< that the environment is multiplied by
  int height = 0;                       ///< pixels, of the largest target
  bool wants_parts = false;             ///< attributes of scattering near and far are asked for
};

/// Shades surfaces that light scatters through: core/translucency. Context's thread only.
class TranslucencyStage {
 public:
  virtual ~TranslucencyStage() = default;
  /// `material`: index, or scene::kNone.
  [[nodiscard]] virtual bool IsTranslucent(int material) const = 0;
  /// Before a frame's geometry is drawn; what did not change since the last call is kept. Changes framebuffer, program
  /// and render states.
  [[nodiscard]] virtual Result<void> Update(const TranslucencyInput& input) = 0;
  /// Uniform blocks and textures for one of the frame's items that IsTranslucent.
  virtual void Bind(std::size_t item) const = 0;
  /// GLSL after BlockDeclarations() and LightFunctions(), with PARTS 1 where near and far are told apart:
  ///   float FresnelTransmittance(float cosine)
  ///   vec3 EnteringLight(vec3 world, vec3 n, vec3 g)   irradiance times transmittance; n: shading normal, g: the
  ///   mesh's void Radiosity(vec3 world, vec3 g, out vec3 all, out vec3 near)
  [[nodiscard]] virtual const std::string& ShaderText() const = 0;
};

}  // namespace burin::gbuffer

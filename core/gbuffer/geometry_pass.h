// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/gbuffer/geometry_shader.h"
#include "core/gbuffer/material_store.h"
#include "core/gbuffer/mesh_store.h"
#include "core/gl/program.h"

namespace burin::gbuffer {

/// One item, ready to draw.
struct PreparedDraw {
  const GpuPrimitive* primitive = nullptr;
  int material = scene::kNone;
  std::uint32_t features = 0;  ///< of material and primitive
  std::size_t block = 0;       ///< index of its DrawBlock
  float view_depth = 0.0f;     ///< of its centre
  bool is_blend = false;
  bool is_double_sided = false;
  bool is_mirrored = false;
};

class TranslucencyStage;

/// A frame's draws: blended ones apart, farthest first.
struct FrameDraws {
  std::vector<PreparedDraw> opaque;
  std::vector<PreparedDraw> blended;
  const TranslucencyStage* translucency = nullptr;  ///< of draws with kIsTranslucent
  std::uint32_t block_buffer = 0;                   ///< GL name; DrawBlocks every AlignBlock(sizeof(DrawBlock)) bytes
};

/// Draws a frame into one set of outputs. Programs are made when a kind of draw first occurs.
class GeometryPass {
 public:
  explicit GeometryPass(std::vector<Output> outputs) : outputs_(std::move(outputs)) {}

  [[nodiscard]] const std::vector<Output>& outputs() const { return outputs_; }

  /// Into the bound framebuffer, cleared already (depth to 0); frame and light blocks bound. Opaque and masked surfaces
  /// first; then `after_opaque`, if any, which binds this framebuffer again; then blended colour, back to front; then
  /// what blended surfaces leave in the other outputs.
  [[nodiscard]] Result<void> Draw(const FrameDraws& draws, MaterialStore& materials,
                                  const std::function<Result<void>()>& after_opaque);

 private:
  enum class Phase : std::uint8_t { kOpaque, kBlendedColor, kBlendedOthers };
  [[nodiscard]] std::vector<Output> OutputsOf(Phase phase) const;
  [[nodiscard]] Result<void> DrawPhase(Phase phase, std::span<const PreparedDraw> draws, const FrameDraws& frame,
                                       MaterialStore& materials);
  [[nodiscard]] Result<const gl::Program*> ProgramOf(Phase phase, std::uint32_t features,
                                                     const TranslucencyStage* translucency);

  std::vector<Output> outputs_;
  std::map<std::pair<Phase, std::uint32_t>, gl::Program> programs_;
};

}  // namespace burin::gbuffer

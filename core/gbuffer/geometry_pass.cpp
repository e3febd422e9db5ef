// SPDX-License-Identifier: Apache-2.0
#include "core/gbuffer/geometry_pass.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/gbuffer/gpu_blocks.h"
#include "core/gbuffer/translucency_stage.h"

namespace burin::gbuffer {
namespace {

constexpr std::uint32_t kBlendFeatures = kIsBlend | kIsBlendedColor;

// Single-sided triangles show their fronts only. Lines and points have no back.
void SetCulling(const PreparedDraw& draw) {
  glFrontFace(draw.is_mirrored ? GL_CW : GL_CCW);
  const bool culls = !draw.is_double_sided && draw.primitive->mode == GL_TRIANGLES;
  culls ? glEnable(GL_CULL_FACE) : glDisable(GL_CULL_FACE);
}

void SetDepthTest() {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GEQUAL);  // depth is reversed; of equals the last wins, as Direct3D's LessEqual has it
  glDepthMask(GL_TRUE);
  glCullFace(GL_BACK);
}

void DrawElements(const PreparedDraw& draw) {
  glDrawElements(draw.primitive->mode, draw.primitive->index_count, GL_UNSIGNED_INT, nullptr);
}

// A blended surface that shows both sides: the far side lies behind the near one.
void DrawBacksThenFronts(const PreparedDraw& draw) {
  glEnable(GL_CULL_FACE);
  glCullFace(GL_FRONT);
  DrawElements(draw);
  glCullFace(GL_BACK);
  DrawElements(draw);
}

}  // namespace

std::vector<Output> GeometryPass::OutputsOf(Phase phase) const {
  std::vector<Output> chosen;
  for (const Output& output : outputs_) {
    const bool is_in = phase == Phase::kOpaque || output.is_blended == (phase == Phase::kBlendedColor);
    if (is_in) chosen.push_back(output);
  }
  return chosen;
}

Result<const gl::Program*> GeometryPass::ProgramOf(Phase phase, std::uint32_t features,
                                                   const TranslucencyStage* translucency) {
  const std::pair key(phase, features);
  const auto found = programs_.find(key);
  if (found != programs_.end()) return &found->second;
  const std::string_view scattering = translucency != nullptr ? translucency->ShaderText() : std::string_view();
  Result<gl::Program> program =
      gl::Program::Create(GeometryVertexText(features), GeometryFragmentText(OutputsOf(phase), features, scattering),
                          fmt::format("geometry pass, features 0x{:x}", features));
  if (!program) return std::unexpected(program.error());
  return &programs_.emplace(key, std::move(*program)).first->second;
}

Result<void> GeometryPass::DrawPhase(Phase phase, std::span<const PreparedDraw> draws, const FrameDraws& frame,
                                     MaterialStore& materials) {
  const std::vector<Output> outputs = OutputsOf(phase);
  // Without any outputs the pass is there for its depth.
  if (outputs.empty() && (!outputs_.empty() || phase == Phase::kBlendedColor)) return {};
  for (const Output& output : outputs_) {
    const bool is_written = std::ranges::find(outputs, output.location, &Output::location) != outputs.end();
    const GLboolean mask = is_written ? GL_TRUE : GL_FALSE;
    glColorMaski(static_cast<GLuint>(output.location), mask, mask, mask, mask);
  }
  std::optional<std::pair<int, std::uint32_t>> bound;
  for (const PreparedDraw& draw : draws) {
    std::uint32_t features = draw.features & ~kBlendFeatures;
    if (phase == Phase::kBlendedColor) features |= kIsBlendedColor;
    if (phase == Phase::kBlendedOthers) features |= kIsBlend;
    features = RelevantFeatures(outputs, features);
    if (bound != std::pair(draw.material, features)) {
      const Result<const gl::Program*> program = ProgramOf(phase, features, frame.translucency);
      if (!program) return std::unexpected(program.error());
      glUseProgram((*program)->id());
      if (Result<void> result = materials.Bind(draw.material, features); !result) return result;
      bound = {draw.material, features};
    }
    if ((features & kIsTranslucent) != 0) frame.translucency->Bind(draw.block);
    glBindBufferRange(GL_UNIFORM_BUFFER, kDrawBinding, frame.block_buffer,
                      static_cast<GLintptr>(draw.block * AlignBlock(sizeof(DrawBlock))), sizeof(DrawBlock));
    glBindVertexArray(draw.primitive->vertex_array.id());
    SetCulling(draw);
    const bool both_sides =
        phase == Phase::kBlendedColor && draw.is_double_sided && draw.primitive->mode == GL_TRIANGLES;
    both_sides ? DrawBacksThenFronts(draw) : DrawElements(draw);
  }
  return {};
}

Result<void> GeometryPass::Draw(const FrameDraws& draws, MaterialStore& materials,
                                const std::function<Result<void>()>& after_opaque) {
  SetDepthTest();
  if (Result<void> result = DrawPhase(Phase::kOpaque, draws.opaque, draws, materials); !result) return result;
  if (after_opaque) {
    if (Result<void> result = after_opaque(); !result) return result;
    SetDepthTest();
  }
  if (draws.blended.empty()) return {};

  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  Result<void> result = DrawPhase(Phase::kBlendedColor, draws.blended, draws, materials);
  if (!result) return result;
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
  glCullFace(GL_BACK);
  return DrawPhase(Phase::kBlendedOthers, draws.blended, draws, materials);
}

}  // namespace burin::gbuffer

// SPDX-License-Identifier: Apache-2.0
#include "core/gbuffer/line_pass.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <glm/vec4.hpp>
#include <vector>

#include "core/gbuffer/gpu_blocks.h"
#include "core/gbuffer/translucency_stage.h"
#include "core/gl/buffer.h"

namespace burin::gbuffer {
namespace {

constexpr int kFirstLineLocation = 0;

Output ColorOutput() {
  return {.location = 0,
          .storage = {Attribute::kColor, gl::PlainFormat(gl::Numeric::kFloat, 32, 4), image::Encoding::kSceneLinear},
          .is_blended = true};
}

std::vector<const PreparedDraw*> ByItem(const FrameDraws& draws) {
  std::vector<const PreparedDraw*> by_item;
  for (const std::vector<PreparedDraw>* list : {&draws.opaque, &draws.blended}) {
    for (const PreparedDraw& draw : *list) {
      if (by_item.size() <= draw.block) by_item.resize(draw.block + 1, nullptr);
      by_item[draw.block] = &draw;
    }
  }
  return by_item;
}

}  // namespace

LinePass::LinePass() : indices_(gl::CreateBuffer("lines: indices")), records_(gl::CreateBuffer("lines")) {}

void LinePass::Upload(std::span<const ShadedLine> lines) {
  std::vector<std::uint32_t> indices;
  std::vector<glm::vec4> records;
  indices.reserve(2 * lines.size());
  records.reserve(lines.size());
  for (const ShadedLine& line : lines) {
    indices.insert(indices.end(), line.vertices.begin(), line.vertices.end());
    const int flags = (line.is_back ? 1 : 0) + (line.is_outline ? 2 : 0) + (line.is_flipped ? 4 : 0);
    records.emplace_back(line.alpha, line.slack, static_cast<float>(flags), 0.0f);
  }
  gl::StreamInto(indices_, indices.data(), indices.size() * sizeof(std::uint32_t));
  gl::StreamInto(records_, records.data(), records.size() * sizeof(glm::vec4));
}

Result<const gl::Program*> LinePass::ProgramOf(std::uint32_t features, const TranslucencyStage* translucency) {
  const auto found = programs_.find(features);
  if (found != programs_.end()) return &found->second;
  const std::string vertex = GeometryVertexText();
  const std::string geometry = LineGeometryText();
  const std::string_view scattering = translucency != nullptr ? translucency->ShaderText() : std::string_view();
  const std::string fragment = GeometryFragmentText({ColorOutput()}, features, scattering);
  Result<gl::Program> program =
      gl::Program::Create({vertex, geometry, fragment}, fmt::format("lines, features 0x{:x}", features));
  if (!program) return std::unexpected(program.error());
  return &programs_.emplace(features, std::move(*program)).first->second;
}

// Lines of one item after another share a call.
Result<void> LinePass::DrawAll(std::span<const ShadedLine> lines, const FrameDraws& draws, std::uint32_t feature,
                               MaterialStore& materials) {
  Upload(lines);
  const std::vector<const PreparedDraw*> by_item = ByItem(draws);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kLineBinding, records_.id());
  for (std::size_t begin = 0, end = 0; begin < lines.size(); begin = end) {
    const std::uint32_t item = lines[begin].item;
    while (end < lines.size() && lines[end].item == item) ++end;
    if (item >= by_item.size() || by_item[item] == nullptr) continue;
    const PreparedDraw& draw = *by_item[item];
    std::uint32_t features = draw.features | feature | (draw.is_blend ? kIsBlendedColor : 0u);
    features = RelevantFeatures({ColorOutput()}, features);
    const Result<const gl::Program*> program = ProgramOf(features, draws.translucency);
    if (!program) return std::unexpected(program.error());
    glUseProgram((*program)->id());
    if (Result<void> bound = materials.Bind(draw.material, features); !bound) return bound;
    if ((features & kIsTranslucent) != 0) draws.translucency->Bind(draw.block);
    glUniform1i(kFirstLineLocation, static_cast<GLint>(begin));
    glBindBufferRange(GL_UNIFORM_BUFFER, kDrawBinding, draws.block_buffer,
                      static_cast<GLintptr>(draw.block * AlignBlock(sizeof(DrawBlock))), sizeof(DrawBlock));
    const GLuint array = draw.primitive->vertex_array.id();
    glVertexArrayElementBuffer(array, indices_.id());
    glBindVertexArray(array);
    glDrawElements(GL_LINES, static_cast<GLsizei>(2 * (end - begin)), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(2 * begin * sizeof(std::uint32_t)));
    glVertexArrayElementBuffer(array, draw.primitive->indices.id());
  }
  return {};
}

Result<void> LinePass::Draw(std::span<const ShadedLine> lines, const FrameDraws& draws, int location, int output_count,
                            MaterialStore& materials) {
  if (lines.empty()) return {};
  for (int i = 0; i < output_count; ++i) {
    const GLboolean mask = i == location ? GL_TRUE : GL_FALSE;
    glColorMaski(static_cast<GLuint>(i), mask, mask, mask, mask);
  }
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GEQUAL);
  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  Result<void> drawn = DrawAll(lines, draws, kIsLine, materials);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
  for (int i = 0; i < output_count; ++i) glColorMaski(static_cast<GLuint>(i), GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  return drawn;
}

Result<void> LinePass::AddAreas(std::span<const ShadedLine> lines, const FrameDraws& draws, const gl::Texture& depth,
                                MaterialStore& materials) {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ONE, GL_ONE);
  glBindSampler(kDepthUnit, 0);
  glBindTextureUnit(kDepthUnit, depth.id());
  Result<void> drawn = DrawAll(lines, draws, kIsLine | kIsArea, materials);
  glDisable(GL_BLEND);
  return drawn;
}

}  // namespace burin::gbuffer

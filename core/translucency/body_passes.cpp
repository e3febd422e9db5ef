// SPDX-License-Identifier: Apache-2.0
#include "core/translucency/body_passes.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <array>
#include <bit>

#include "core/gbuffer/geometry_shader.h"
#include "core/gl/buffer.h"
#include "core/translucency/face_glsl.h"
#include "core/translucency/gather_glsl.h"
#include "core/translucency/pass_target.h"

namespace burin::translucency {
namespace {

Result<void> Ensure(gl::Program& program, const gl::ProgramText& text, std::string_view label) {
  if (program) return {};
  Result<gl::Program> made = gl::Program::Create(text, label);
  if (!made) return std::unexpected(made.error());
  program = *std::move(made);
  return {};
}

// One viewport a face, in each of `rows` rows.
void SetFaceViewports(const BodyBlock& block, int rows) {
  const auto s = static_cast<float>(block.texels.w);
  for (int face = 0; face < 6; ++face) {
    const int axis = face / 2;
    for (int row = 0; row < rows; ++row) {
      glViewportIndexedf(static_cast<GLuint>(face + 6 * row), static_cast<float>(face) * s, static_cast<float>(row) * s,
                         static_cast<float>(block.texels[(axis + 1) % 3]),
                         static_cast<float>(block.texels[(axis + 2) % 3]));
    }
  }
}

void DrawTriangles(const gbuffer::PreparedDraw& draw, std::uint32_t draw_blocks) {
  glBindBufferRange(GL_UNIFORM_BUFFER, gbuffer::kDrawBinding, draw_blocks,
                    static_cast<GLintptr>(draw.block * gbuffer::AlignBlock(sizeof(gbuffer::DrawBlock))),
                    sizeof(gbuffer::DrawBlock));
  glBindVertexArray(draw.primitive->vertex_array.id());
  glDrawElements(GL_TRIANGLES, draw.primitive->index_count, GL_UNSIGNED_INT, nullptr);
}

constexpr std::uint32_t kSourceFeatures = gbuffer::kHasBaseColorTexture | gbuffer::kHasMetallicRoughnessTexture |
                                          gbuffer::kHasNormalTexture | gbuffer::kIsMasked | gbuffer::kHasNormals |
                                          gbuffer::kHasTangents | gbuffer::kHasTexcoords | gbuffer::kHasLights;

std::uint32_t FeaturesOf(const gbuffer::PreparedDraw& draw) {
  std::uint32_t features = draw.features & kSourceFeatures;
  if ((features & gbuffer::kHasNormalTexture) == 0) features &= ~(gbuffer::kHasTangents | gbuffer::kHasTexcoords);
  if ((features & gbuffer::kHasTangents) != 0) features &= ~gbuffer::kHasTexcoords;
  return features;
}

}  // namespace

BodyPasses::BodyPasses(const Quality& quality) : quality_(quality), frame_block_(gl::CreateBuffer("faces' frame")) {
  GLuint id = 0;
  glCreateVertexArrays(1, &id);
  no_vertices_ = gl::VertexArrayHandle(id);
  // Surfaces are looked at from nowhere here.
  const gbuffer::FrameBlock frame{};
  glNamedBufferStorage(frame_block_.id(), sizeof(frame), &frame, 0);
}

Result<void> BodyPasses::DrawDepth(const BodyItems& body, const BodyBlock& block, std::uint32_t draw_blocks,
                                   const BodyMaps& maps) {
  if (!depth_program_) {
    const std::string vertex = FaceDepthVertexText();
    const std::string geometry = FaceDepthGeometryText(quality_.kernel > 0);
    auto ready = Ensure(depth_program_, {vertex, geometry, {}}, "translucency: depth of faces");
    if (!ready) return ready;
  }
  constexpr float kFarthest = 1.0f;
  glClearNamedFramebufferfv(maps.depth_target.id(), GL_DEPTH, 0, &kFarthest);
  glBindFramebuffer(GL_FRAMEBUFFER, maps.depth_target.id());
  SetFaceViewports(block, 1);
  glUseProgram(depth_program_.id());
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glDisable(GL_CULL_FACE);
  for (const gbuffer::PreparedDraw* draw : body.draws) DrawTriangles(*draw, draw_blocks);
  glDisable(GL_DEPTH_TEST);
  return {};
}

Result<const gl::Program*> BodyPasses::SourceProgram(std::uint32_t features) {
  gl::Program& program = source_programs_[features];
  if (program) return &program;
  const std::string vertex = SourceVertexText();
  const std::string geometry = SourceGeometryText(quality_.kernel > 0);
  const std::string fragment = SourceFragmentText(features);
  auto ready = Ensure(program, {vertex, geometry, fragment}, fmt::format("translucency: sources 0x{:x}", features));
  if (!ready) return std::unexpected(ready.error());
  return &program;
}

Result<void> BodyPasses::DrawSources(const BodyItems& body, const BodyBlock& block, std::uint32_t draw_blocks,
                                     gbuffer::MaterialStore& materials, const BodyMaps& maps) {
  if (auto ready = sums_.Ensure(quality_.face_texels); !ready) return ready;
  constexpr std::array<float, 4> kNothing{};
  glClearNamedFramebufferfv(sums_.target.id(), GL_COLOR, 0, kNothing.data());
  glClearNamedFramebufferfv(sums_.target.id(), GL_COLOR, 1, kNothing.data());
  glBindFramebuffer(GL_FRAMEBUFFER, sums_.target.id());
  SetFaceViewports(block, 2);
  glBindBufferBase(GL_UNIFORM_BUFFER, gbuffer::kFrameBinding, frame_block_.id());
  BindForFetch(kFaceDepthUnit, maps.face_depth);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ONE, GL_ONE);
  for (const gbuffer::PreparedDraw* draw : body.draws) {
    const std::uint32_t features = FeaturesOf(*draw);
    const Result<const gl::Program*> program = SourceProgram(features);
    if (!program) return std::unexpected(program.error());
    glUseProgram((*program)->id());
    if (auto bound = materials.Bind(draw->material, features); !bound) return bound;
    DrawTriangles(*draw, draw_blocks);
  }
  glDisable(GL_BLEND);
  return {};
}

Result<void> BodyPasses::BuildPyramid(const BodyMaps& maps) {
  const std::string vertex = CoveringVertexText();
  if (!base_program_) {
    const std::string base = PyramidBaseFragmentText();
    const std::string level = PyramidLevelFragmentText();
    if (auto ready = Ensure(base_program_, {vertex, {}, base}, "translucency: sources packed"); !ready) return ready;
    if (auto ready = Ensure(level_program_, {vertex, {}, level}, "translucency: sources summed"); !ready) return ready;
  }
  const int s = quality_.face_texels;
  glBindFramebuffer(GL_FRAMEBUFFER, maps.pyramid_target.id());
  glBindVertexArray(no_vertices_.id());
  glDisable(GL_DEPTH_TEST);
  glViewport(0, 0, 6 * s, 2 * s);
  glUseProgram(base_program_.id());
  BindForFetch(0, sums_.light);
  BindForFetch(1, sums_.place);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glUseProgram(level_program_.id());
  BindForFetch(kSourceUnit, maps.sources);
  for (int level = 1; s >> level > 0; ++level) {
    glTextureBarrier();  // the level below lies in the same texture
    glViewport(0, 4 * s - (4 * s >> level), 6 * (s >> level), 2 * (s >> level));
    glUniform1i(0, level);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
  glTextureBarrier();
  return {};
}

Result<void> BodyPasses::Gather(const BodyMaps& maps, bool has_parts) {
  gl::Program& program = receiver_programs_[has_parts];
  if (!program) {
    const std::string vertex = CoveringVertexText();
    const std::string fragment = ReceiverFragmentText(quality_, has_parts);
    if (auto ready = Ensure(program, {vertex, {}, fragment}, "translucency: radiosity"); !ready) return ready;
  }
  const int r = quality_.face_texels >> quality_.receiver_shift;
  glBindFramebuffer(GL_FRAMEBUFFER, maps.receiver_target.id());
  glBindVertexArray(no_vertices_.id());
  glViewport(0, 0, 6 * r, 2 * r);
  glUseProgram(program.id());
  BindForFetch(kSourceUnit, maps.sources);
  BindForFetch(kFaceDepthUnit, maps.face_depth);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  return {};
}

}  // namespace burin::translucency

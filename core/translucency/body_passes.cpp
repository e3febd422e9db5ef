// SPDX-License-Identifier: Apache-2.0
#include "core/translucency/body_passes.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

#include "core/gbuffer/geometry_shader.h"
#include "core/gl/buffer.h"
#include "core/translucency/face_glsl.h"
#include "core/translucency/gather_glsl.h"
#include "core/translucency/irradiance_glsl.h"
#include "core/translucency/pass_target.h"
#include "core/translucency/receiver_glsl.h"

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
  if (quality_.is_paper()) return {};  // DrawSources keeps what is nearest
  if (!depth_program_) {
    const std::string vertex = FaceDepthVertexText();
    const std::string geometry = FaceDepthGeometryText();
    auto ready = Ensure(depth_program_, {vertex, geometry, {}}, "translucency: depth of faces");
    if (!ready) return ready;
  }
  SetFaceViewports(block, 1);
  glUseProgram(depth_program_.id());
  glDisable(GL_CULL_FACE);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
  const auto draw_into = [&](const gl::FramebufferHandle& target, GLenum keeps, float beyond) {
    glClearNamedFramebufferfv(target.id(), GL_DEPTH, 0, &beyond);
    glBindFramebuffer(GL_FRAMEBUFFER, target.id());
    glDepthFunc(keeps);
    for (const gbuffer::PreparedDraw* draw : body.draws) DrawTriangles(*draw, draw_blocks);
  };
  draw_into(maps.depth_target, GL_LESS, 1.0f);
  draw_into(maps.deepest_target, GL_GREATER, 0.0f);
  glDisable(GL_DEPTH_TEST);
  return {};
}

Result<const gl::Program*> BodyPasses::SourceProgram(std::uint32_t features, int fixed_lights) {
  gl::Program& program = source_programs_[{features, fixed_lights}];
  if (program) return &program;
  const std::string vertex = SourceVertexText();
  const std::string geometry = SourceGeometryText(quality_.is_paper());
  const std::string fragment = SourceFragmentText(quality_, features, fixed_lights);
  auto ready = Ensure(program, {vertex, geometry, fragment}, fmt::format("translucency: sources 0x{:x}", features));
  if (!ready) return std::unexpected(ready.error());
  return &program;
}

Result<void> BodyPasses::DrawSources(const BodyItems& body, const BodyBlock& block, std::uint32_t draw_blocks,
                                     const ShadowBlock& shadows, gbuffer::MaterialStore& materials,
                                     const BodyMaps& maps) {
  if (auto ready = sums_.Ensure(quality_.face_texels); !ready) return ready;
  constexpr std::array<float, 4> kNothing{};
  glClearNamedFramebufferfv(sums_.target.id(), GL_COLOR, 0, kNothing.data());
  glClearNamedFramebufferfv(sums_.target.id(), GL_COLOR, 1, kNothing.data());
  glBindFramebuffer(GL_FRAMEBUFFER, sums_.target.id());
  SetFaceViewports(block, 2);
  glBindBufferBase(GL_UNIFORM_BUFFER, gbuffer::kFrameBinding, frame_block_.id());
  BindForFetch(kFaceDepthUnit, maps.face_depth);
  glDisable(GL_CULL_FACE);
  if (quality_.is_paper()) {
    glNamedFramebufferTexture(sums_.target.id(), GL_DEPTH_ATTACHMENT, maps.face_depth.id(), 0);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    constexpr float kFarthest = 1.0f;
    glClearNamedFramebufferfv(sums_.target.id(), GL_DEPTH, 0, &kFarthest);
  } else {
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE);
  }
  for (const gbuffer::PreparedDraw* draw : body.draws) {
    const std::uint32_t features = FeaturesOf(*draw);
    const Result<const gl::Program*> program = SourceProgram(features, FixedLights(shadows, block.levels.w));
    if (!program) return std::unexpected(program.error());
    glUseProgram((*program)->id());
    if (auto bound = materials.Bind(draw->material, features); !bound) return bound;
    DrawTriangles(*draw, draw_blocks);
  }
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  return {};
}

Result<void> BodyPasses::BuildPyramid(const BodyBlock& block, const BodyMaps& maps) {
  const std::string vertex = CoveringVertexText();
  // Receivers are read from level 1 on, and the paper's way from level 0.
  const int lowest = quality_.is_paper() ? 0 : std::min({block.levels.x, quality_.receiver_shift, 1});
  gl::Program& base_program = base_programs_[static_cast<std::size_t>(lowest)];
  const std::string base = PyramidBaseFragmentText(lowest);
  if (auto ready = Ensure(base_program, {vertex, {}, base}, "translucency: sources packed"); !ready) return ready;
  const std::string next = PyramidLevelFragmentText();
  if (auto ready = Ensure(level_program_, {vertex, {}, next}, "translucency: sources summed"); !ready) return ready;
  const int s = quality_.face_texels;
  glBindFramebuffer(GL_FRAMEBUFFER, maps.pyramid_target.id());
  glBindVertexArray(no_vertices_.id());
  glDisable(GL_DEPTH_TEST);
  glUseProgram(base_program.id());
  BindForFetch(0, sums_.light);
  BindForFetch(1, sums_.place);
  for (int level = lowest; s >> level > 0; ++level) {
    if (level == lowest + 1) {
      glUseProgram(level_program_.id());
      BindForFetch(kSourceUnit, maps.sources);
    }
    if (level > lowest) {
      glTextureBarrier();  // the level below lies in the same texture
      glUniform1i(0, level);
    }
    glViewport(0, 4 * s - (4 * s >> level), 6 * (s >> level), 2 * (s >> level));
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
  glTextureBarrier();
  return {};
}

Result<void> BodyPasses::Gather(const BodyMaps& maps, bool has_parts) {
  ReceiverPrograms& programs = receiver_programs_[has_parts];
  if (!programs.gather) {
    const std::string choice = ReceiverChoiceText(quality_, has_parts);
    const std::string gather = ReceiverText(quality_, has_parts);
    auto ready = Ensure(programs.choice, {{}, {}, {}, choice}, "translucency: receivers");
    if (ready) ready = Ensure(programs.gather, {{}, {}, {}, gather}, "translucency: radiosity");
    if (!ready) return ready;
  }
  const int side = quality_.face_texels >> quality_.receiver_shift;
  if (!wanted_) {
    wanted_ = gl::CreateBuffer("translucency: receivers to gather");
    constexpr int kMost = 12;  // faces in two rows
    glNamedBufferStorage(wanted_.id(), static_cast<GLsizeiptr>(kMost * side * side + 4) * 4, nullptr, 0);
  }
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kWantedBinding, wanted_.id());
  glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, wanted_.id());
  glBindImageTexture(0, maps.receivers.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
  BindForFetch(kSourceUnit, maps.sources);
  BindForFetch(kFaceDepthUnit, maps.face_depth);
  if (maps.face_deepest) BindForFetch(kFaceDeepestUnit, maps.face_deepest);
  BindForFetch(kReceiverUnit, maps.receivers);
  if (maps.near_receivers) {
    glBindImageTexture(1, maps.near_receivers.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    BindForFetch(kLocalUnit, maps.near_receivers);
  }
  const int spacing = quality_.lattice;
  GatherLattices(programs, side, {{0, 0, spacing, 0}});
  for (int step = spacing / 2; step > 0; step /= 2) {
    GatherLattices(programs, side, {{step, step, 2 * step, step}});
    GatherLattices(programs, side, {{step, 0, 2 * step, step}, {0, step, 2 * step, step}});
  }
  return {};
}

void BodyPasses::GatherLattices(const ReceiverPrograms& programs, int side,
                                std::initializer_list<glm::ivec4> lattices) {
  constexpr std::array<GLuint, 4> kNoGroups = {0, 1, 1, 0};
  glClearNamedBufferSubData(wanted_.id(), GL_RGBA32UI, 0, sizeof(kNoGroups), GL_RGBA_INTEGER, GL_UNSIGNED_INT,
                            kNoGroups.data());
  glUseProgram(programs.choice.id());
  for (const glm::ivec4& lattice : lattices) {
    const int across = side / lattice.z / 8;
    glUniform4i(0, lattice.x, lattice.y, lattice.z, lattice.w);
    glDispatchCompute(static_cast<GLuint>(across * across), 12, 1);
  }
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
  glUseProgram(programs.gather.id());
  glDispatchComputeIndirect(0);
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

}  // namespace burin::translucency

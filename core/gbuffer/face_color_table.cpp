// SPDX-License-Identifier: Apache-2.0
#include "core/gbuffer/face_color_table.h"

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>

#include "core/gbuffer/frame_blocks.h"
#include "core/gbuffer/translucency_stage.h"
#include "core/gl/buffer.h"
#include "core/gl/framebuffer.h"
#include "core/gl/state.h"

namespace burin::gbuffer {
namespace {

constexpr std::size_t kGrain = 256;
constexpr int kBlockSide = 4;  // texels
constexpr int kTableWidth = kBlockSide * static_cast<int>(kBlocksInRow);

constexpr std::string_view kVertexText = R"(#version 450 core
void main() { gl_Position = vec4(vec2(gl_VertexID % 2, gl_VertexID / 2) * 4.0 - 1.0, 0.0, 1.0); }
)";

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

// A range of blocks is up to three rectangles of them: the rest of a row, whole rows, the beginning of one.
void FillBlocks(const SampleRange& range) {
  std::uint32_t block = range.first_block;
  std::uint32_t left = range.blocks;
  while (left > 0) {
    const std::uint32_t column = block % kBlocksInRow;
    const std::uint32_t rows = column == 0 ? std::max(left / kBlocksInRow, 1u) : 1u;
    const std::uint32_t columns = std::min(left, kBlocksInRow - column);
    glScissor(static_cast<GLint>(column) * kBlockSide, static_cast<GLint>(block / kBlocksInRow) * kBlockSide,
              static_cast<GLsizei>(columns) * kBlockSide, static_cast<GLsizei>(rows) * kBlockSide);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    block += rows * columns;
    left -= rows * columns;
  }
}

}  // namespace

FaceColorTable::FaceColorTable(const scene::Scene& scene) : scene_(&scene), buffer_(gl::CreateBuffer("face samples")) {
  GLuint id = 0;
  glCreateVertexArrays(1, &id);
  vertex_array_ = gl::VertexArrayHandle(id);
}

void FaceColorTable::Gather(std::span<const FaceEdge> edges, const FrameInput& frame, const SampleView& view) {
  PlanSamples(edges, plan_);
  samples_.resize(std::size_t{plan_.blocks()} * kSampleBlock);
  std::vector<scene::ItemGeometry> geometry(frame.items.size());
  std::vector<DrawBlock> blocks(frame.items.size());
  for (const SampleRange& range : plan_.ranges) {
    geometry[range.item] = scene::GeometryOf(*scene_, frame.items[range.item]);
    blocks[range.item] = MakeDrawBlock(frame.items[range.item]);
  }
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, edges.size(), kGrain),
                    [&](const tbb::blocked_range<std::size_t>& some) {
                      for (std::size_t i = some.begin(); i < some.end(); ++i) {
                        const std::uint32_t item = edges[i].item;
                        SampleEdge(edges[i], geometry[item], blocks[item], view, &samples_[plan_.first[i]]);
                      }
                    });
}

Result<void> FaceColorTable::Reserve(std::uint32_t blocks) {
  const auto rows = static_cast<int>((blocks + kBlocksInRow - 1) / kBlocksInRow);
  const int height = kBlockSide * static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::max(rows, 1))));
  if (colors_ && colors_.height() >= height) return {};
  Result<gl::Texture> colors =
      gl::Texture::Create(gl::PlainFormat(gl::Numeric::kFloat, 32, 4), kTableWidth, height, 1, "face colours");
  if (!colors) {
    return Fail(colors.error().kind,
                fmt::format("the shading of edges at {} points: {}", blocks * kSampleBlock, colors.error().message));
  }
  colors_ = std::move(*colors);
  return {};
}

Result<const gl::Program*> FaceColorTable::ProgramOf(std::uint32_t features, const TranslucencyStage* translucency) {
  const auto found = programs_.find(features);
  if (found != programs_.end()) return &found->second;
  const std::string_view scattering = translucency != nullptr ? translucency->ShaderText() : std::string_view();
  Result<gl::Program> program =
      gl::Program::Create(kVertexText, GeometryFragmentText({ColorOutput()}, features, scattering),
                          fmt::format("face colours, features 0x{:x}", features));
  if (!program) return std::unexpected(program.error());
  return &programs_.emplace(features, std::move(*program)).first->second;
}

Result<const gl::Texture*> FaceColorTable::Shade(std::span<const FaceEdge> edges, const FrameInput& frame,
                                                 const FrameDraws& draws, const SampleView& view,
                                                 MaterialStore& materials, std::vector<std::uint32_t>& first) {
  Gather(edges, frame, view);
  if (Result<void> reserved = Reserve(plan_.blocks()); !reserved) return std::unexpected(reserved.error());
  gl::StreamInto(buffer_, samples_.data(), samples_.size() * sizeof(FaceSample));
  const std::array<const gl::Texture*, 1> targets = {&colors_};
  const Result<gl::Framebuffer> framebuffer = gl::Framebuffer::Create(targets, nullptr, "face colours");
  if (!framebuffer) return std::unexpected(framebuffer.error());
  gl::ResetState();
  framebuffer->Bind();
  glEnable(GL_SCISSOR_TEST);
  glBindVertexArray(vertex_array_.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kFaceSampleBinding, buffer_.id());
  const std::vector<const PreparedDraw*> by_item = ByItem(draws);
  for (const SampleRange& range : plan_.ranges) {
    if (range.item >= by_item.size() || by_item[range.item] == nullptr) continue;
    const PreparedDraw& draw = *by_item[range.item];
    const std::uint32_t features =
        RelevantFeatures({ColorOutput()}, draw.features | kIsSample | (draw.is_blend ? kIsBlendedColor : 0u));
    const Result<const gl::Program*> program = ProgramOf(features, draws.translucency);
    if (!program) return std::unexpected(program.error());
    glUseProgram((*program)->id());
    if (Result<void> bound = materials.Bind(draw.material, features); !bound) return std::unexpected(bound.error());
    if ((features & kIsTranslucent) != 0) draws.translucency->Bind(draw.block);
    FillBlocks(range);
  }
  glBindVertexArray(0);
  gl::ResetState();
  first = plan_.first;
  return &colors_;
}

std::string_view FaceColorFunctions() {
  return R"(
vec4 FaceColorAt(sampler2D table, int place) {
  int block = place >> 4;
  return texelFetch(table, ivec2((block & 255) * 4 + (place & 3), (block >> 8) * 4 + ((place >> 2) & 3)), 0);
}

vec4 FaceColor(sampler2D table, uint first, uint points, float t) {
  float along = clamp(t, 0.0, 1.0) * float(points - 1u);
  float before = min(floor(along), max(float(points) - 2.0, 0.0));
  int place = int(first) + int(before);
  vec4 a = FaceColorAt(table, place);
  vec4 b = FaceColorAt(table, min(place + 1, int(first + points) - 1));
  return mix(a, b, along - before);
}
)";
}

}  // namespace burin::gbuffer

// SPDX-License-Identifier: Apache-2.0
#include "core/overdraw/tile_pass.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/vec2.hpp>

#include "core/gbuffer/face_color_table.h"
#include "core/gl/buffer.h"
#include "core/gl/framebuffer.h"
#include "core/gl/readback.h"
#include "core/gl/state.h"
#include "core/overdraw/edge_area_glsl.h"
#include "core/overdraw/edge_share.h"

namespace burin::overdraw {
namespace {

constexpr std::string_view kVertexText = R"(#version 450 core
layout(location = 0) in vec2 corner;
void main() { gl_Position = vec4(corner, 0.0, 1.0); }
)";

constexpr std::string_view kInputs = R"(
const float LEAST_TOUCH = 0.0005;
layout(binding = 0) uniform sampler2D depth_texture;
layout(binding = 1) uniform sampler2D shades;
layout(binding = 2) uniform sampler2D picture;
layout(binding = 3) uniform usamplerBuffer records;   // three texels each
layout(binding = 4) uniform usamplerBuffer edges;
layout(binding = 5) uniform usamplerBuffer lists;
layout(location = 0) out vec4 result;
layout(location = 1) out vec4 touched;

ivec2 Inside(ivec2 p) { return clamp(p, ivec2(0), textureSize(depth_texture, 0) - 1); }
float SurfaceDepth(ivec2 p) { return texelFetch(depth_texture, Inside(p), 0).r; }
float depth_here;
vec4 depths_beside;   // right, left, below, above
float DepthBeside(ivec2 to) {
  return to.y == 0 ? (to.x > 0 ? depths_beside.x : depths_beside.y) : (to.y > 0 ? depths_beside.z : depths_beside.w);
}
vec4 Stored(ivec2 p) { return texelFetch(picture, Inside(p), 0); }
vec4 least = vec4(-1e30), most = vec4(1e30);   // of what is stored
vec4 Linear(vec4 stored) { return PICTURE_LOAD; }
vec4 SegmentOf(int record) { return uintBitsToFloat(texelFetch(records, 3 * record)); }
vec4 DepthOf(int record) { return uintBitsToFloat(texelFetch(records, 3 * record + 1)); }
uvec4 ShadeOf(int record) { return texelFetch(records, 3 * record + 2); }
// No brighter than the picture can hold: its own pixels aren't either, and a lamp's outline would grow.
vec4 ColorOf(uint first, uint points, float t) { return min(FaceColor(shades, first, points, t), vec4(BRIGHTEST)); }
)";

constexpr std::string_view kMain = R"(
void main() {
  ivec2 p = ivec2(gl_FragCoord.xy);
  depth_here = SurfaceDepth(p);
  depths_beside = vec4(SurfaceDepth(p + ivec2(1, 0)), SurfaceDepth(p - ivec2(1, 0)), SurfaceDepth(p + ivec2(0, 1)),
                       SurfaceDepth(p - ivec2(0, 1)));
  int columns = (textureSize(depth_texture, 0).x + TILE_WIDTH - 1) / TILE_WIDTH;
  uvec2 list = texelFetch(lists, p.y / TILE_HEIGHT * columns + p.x / TILE_WIDTH).xy;
  for (uint i = list.x; i < list.x + list.y; ++i) Edge(int(texelFetch(edges, int(i)).x));
  float touch = Touched();
  if (touch < LEAST_TOUCH) discard;
  touched = vec4(touch);
  vec4 color = End(p);
  result = clamp(PICTURE_STORE, least, most);
}
)";

std::string FragmentText(std::string_view body, const gbuffer::Storage& storage) {
  const bool is_bounded = storage.format.numeric == gl::Numeric::kUnorm;
  std::string text = "#version 450 core\n";
  text += fmt::format("#define TILE_WIDTH {}\n#define TILE_HEIGHT {}\n", kTileWidth, kTileHeight);
  text += fmt::format("#define BRIGHTEST {}\n", is_bounded ? "1.0" : "1e30");
  text += gbuffer::StorageFunctions();
  text += gbuffer::FaceColorFunctions();
  text += kInputs;
  text += EdgeAreaFunctions();
  text += body;
  text += kMain;
  const auto replace = [&](std::string_view name, const std::string& with) {
    text.replace(text.rfind(name), name.size(), with);
  };
  replace("PICTURE_LOAD", gbuffer::LoadColorExpression(storage, "stored"));
  replace("PICTURE_STORE", gbuffer::StoreExpression(storage, "color"));
  return text;
}

}  // namespace

TilePass::TilePass(std::string_view label, std::string_view body, float reach)
    : label_(label),
      body_(body),
      reach_(reach),
      records_(GL_RGBA32UI, "edges: records"),
      edges_(GL_R32UI, "edges: of tiles"),
      lists_(GL_RG32UI, "edges: tiles"),
      corners_(gl::CreateBuffer("edges: runs of tiles")) {
  GLuint array = 0;
  glCreateVertexArrays(1, &array);
  vertex_array_ = gl::VertexArrayHandle(array);
  glEnableVertexArrayAttrib(array, 0);
  glVertexArrayAttribFormat(array, 0, 2, GL_FLOAT, GL_FALSE, 0);
  glVertexArrayAttribBinding(array, 0, 0);
  glVertexArrayVertexBuffer(array, 0, corners_.id(), 0, sizeof(glm::vec2));
}

Result<const gl::Program*> TilePass::ProgramOf(const gbuffer::Storage& storage) {
  const auto found = std::ranges::find(variants_, storage, &Variant::storage);
  if (found != variants_.end()) return &found->program;
  Result<gl::Program> program = gl::Program::Create(kVertexText, FragmentText(body_, storage), label_);
  if (!program) return std::unexpected(program.error());
  return &variants_.emplace_back(storage, std::move(*program)).program;
}

Result<const gl::Texture*> TilePass::CopyOf(const gl::Texture& color) {
  const auto fits = [&](const gl::Texture& copy) {
    return copy.width() == color.width() && copy.height() == color.height() && copy.format() == color.format();
  };
  auto copy = std::ranges::find_if(copies_, fits);
  if (copy == copies_.end()) {
    Result<gl::Texture> made =
        gl::Texture::Create(color.format(), color.width(), color.height(), 1, "edges: the picture before");
    if (!made) return std::unexpected(made.error());
    copies_.push_back(std::move(*made));
    copy = copies_.end() - 1;
  }
  glCopyImageSubData(color.id(), GL_TEXTURE_2D, 0, 0, 0, 0, copy->id(), GL_TEXTURE_2D, 0, 0, 0, 0, color.width(),
                     color.height(), 1);
  return &*copy;
}

void TilePass::UploadRuns(int width, int height) {
  std::vector<glm::vec2> corners;
  corners.reserve(6 * tiles_.runs.size());
  const glm::vec2 scale(2.0f * kTileWidth / static_cast<float>(width),
                        -2.0f * kTileHeight / static_cast<float>(height));
  for (const TileRun& run : tiles_.runs) {
    const glm::vec2 a = glm::vec2(run.first, run.row) * scale + glm::vec2(-1.0f, 1.0f);
    const glm::vec2 b = a + glm::vec2(run.count, kRunRows) * scale;
    corners.insert(corners.end(), {a, {b.x, a.y}, {a.x, b.y}, {a.x, b.y}, {b.x, a.y}, b});
  }
  gl::StreamInto(corners_, corners.data(), corners.size() * sizeof(glm::vec2));
}

Result<void> TilePass::Draw(const gl::Texture& color, const gbuffer::Storage& storage, const gl::Texture& depth,
                            std::span<const EdgeRecord> records, const gl::Texture& shades) {
  if (records.empty()) return {};
  BinEdges(records, color.width(), color.height(), reach_, tiles_);
  if (tiles_.runs.empty()) return {};
  const Result<const gl::Program*> program = ProgramOf(storage);
  if (!program) return std::unexpected(program.error());
  gl::ResetState();
  const Result<const gl::Texture*> copy = CopyOf(color);
  if (!copy) return std::unexpected(copy.error());
  lists_.Upload(std::as_bytes(std::span(tiles_.lists)));
  edges_.Upload(std::as_bytes(std::span(tiles_.edges)));
  records_.Upload(std::as_bytes(records));
  UploadRuns(color.width(), color.height());

  gl::Texture mask;
  std::vector<const gl::Texture*> targets = {&color};
  if (!share_) {
    Result<gl::Texture> made = gl::Texture::Create(gl::PlainFormat(gl::Numeric::kFloat, 32, 4), color.width(),
                                                   color.height(), 1, "edges: where they are");
    if (!made) return std::unexpected(made.error());
    mask = std::move(*made);
    const std::array<float, 4> nothing{};
    glClearTexImage(mask.id(), 0, GL_RGBA, GL_FLOAT, nothing.data());
    targets.push_back(&mask);
  }
  const Result<gl::Framebuffer> framebuffer = gl::Framebuffer::Create(targets, nullptr, label_);
  if (!framebuffer) return std::unexpected(framebuffer.error());
  framebuffer->Bind();
  glUseProgram((*program)->id());
  const std::array<GLuint, 6> textures = {depth.id(),    shades.id(), (*copy)->id(),
                                          records_.id(), edges_.id(), lists_.id()};
  for (GLuint unit = 0; unit < textures.size(); ++unit) {
    glBindSampler(unit, 0);
    glBindTextureUnit(unit, textures[unit]);
  }
  glBindVertexArray(vertex_array_.id());
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(6 * tiles_.runs.size()));
  glBindVertexArray(0);
  if (!share_) share_ = ShareNearEdges(gl::Read(mask, image::SampleType::kF32, 4, image::Encoding::kData));
  return {};
}

}  // namespace burin::overdraw

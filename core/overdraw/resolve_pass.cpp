// SPDX-License-Identifier: Apache-2.0
// The area beyond an edge, seen from the pixel's centre, is the sector of the pixel's square between the edge's ends
// less the triangle of the centre and the edge. The sectors of a chain of edges add up, so however many short edges
// cross a pixel, the sum is the area beyond the chain: no samples, nothing that steps as the picture moves.
#include "core/overdraw/resolve_pass.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <span>
#include <string>

#include "core/gl/framebuffer.h"
#include "core/gl/state.h"

namespace burin::overdraw {
namespace {

// Towards the right, left, lower and upper neighbour, areas beyond the edges: that an outline's surface covers though
// the centre is off it; that an outline's surface leaves free though the centre is on its side; on the other side of an
// edge both of whose faces show.
constexpr std::string_view kAreaBody = R"(
layout(location = 0) out vec4 covered;
layout(location = 1) out vec4 exposed;
layout(location = 2) out vec4 across_edge;

// Where a direction from the centre meets the square's border: length along it in pixels, 0 to 4.
float Perimeter(vec2 v) {
  vec2 s = v / max(max(abs(v.x), abs(v.y)), 1e-12);
  if (abs(v.x) >= abs(v.y)) return v.x >= 0.0 ? 0.5 * s.y : 2.0 - 0.5 * s.y;
  return v.y >= 0.0 ? 1.0 - 0.5 * s.x : 3.0 + 0.5 * s.x;
}

void main() {
  vec2 p, q;
  float z;
  if (!CutToPixel(p, q, z)) discard;
  float along = Perimeter(q) - Perimeter(p);
  along -= 4.0 * round(0.25 * along);
  float area = 0.25 * abs(along) - 0.5 * abs(p.x * q.y - p.y * q.x);
  vec2 d = v_segment.zw - v_segment.xy;
  vec2 inwards = vec2(-d.y, d.x);
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  bool is_outline = v_depth.w < 0.0;
  bool is_beyond_inside = dot(inwards, p + q) > 0.0;   // beyond the edge lies the outline's surface
  // Through the very centre: on the surface if the picture has it there.
  bool crosses = max(abs(p.x), abs(p.y)) > 0.4999 && max(abs(q.x), abs(q.y)) > 0.4999;
  if (is_outline && crosses && abs(dot(inwards, p + q)) < 0.04 * length(d)) is_beyond_inside = Surface(pixel) < z - v_depth.z;
  vec2 across = is_beyond_inside ? inwards : -inwards;
  bool is_wide = abs(across.x) >= abs(across.y);
  ivec2 to = is_wide ? ivec2(across.x < 0.0 ? -1 : 1, 0) : ivec2(0, across.y < 0.0 ? -1 : 1);
  ivec2 other = pixel + to;
  if (area <= 0.0 || IsHidden(pixel, other, z)) discard;
  vec4 areas = area * max(vec4(to.x, -to.x, to.y, -to.y), vec4(0.0));
  covered = is_outline && is_beyond_inside ? areas : vec4(0.0);
  exposed = is_outline && !is_beyond_inside ? areas : vec4(0.0);
  across_edge = is_outline ? vec4(0.0) : areas;
}
)";

constexpr std::string_view kBlendBody = R"(
layout(binding = 1) uniform sampler2D covered_texture;
layout(binding = 2) uniform sampler2D exposed_texture;
layout(binding = 3) uniform sampler2D across_texture;
layout(binding = 4) uniform sampler2D picture;
layout(location = 0) out vec4 result;

vec4 Linear(ivec2 p) {
  vec4 stored = texelFetch(picture, clamp(p, ivec2(0), textureSize(picture, 0) - 1), 0);
  return LOAD;
}

void main() {
  ivec2 p = ivec2(gl_FragCoord.xy);
  vec4 covered = texelFetch(covered_texture, p, 0);
  vec4 exposed = texelFetch(exposed_texture, p, 0);
  vec4 areas = texelFetch(across_texture, p, 0);
  float front = dot(covered, vec4(1.0));
  float back = dot(exposed, vec4(1.0));
  // Surfaces that cover, less what they leave free again: thin ones cover only the difference.
  if (front > back) areas += covered * ((front - back) / front);
  else if (back > 0.0) areas += exposed * ((back - front) / back);
  float sum = dot(areas, vec4(1.0));
  if (sum < 0.0005) discard;
  areas /= max(sum, 1.0);
  vec4 color = Linear(p) * (1.0 - min(sum, 1.0));
  if (areas.x > 0.0) color += areas.x * Linear(p + ivec2(1, 0));
  if (areas.y > 0.0) color += areas.y * Linear(p - ivec2(1, 0));
  if (areas.z > 0.0) color += areas.z * Linear(p + ivec2(0, 1));
  if (areas.w > 0.0) color += areas.w * Linear(p - ivec2(0, 1));
  result = STORE;
}
)";

constexpr std::string_view kCleanText = R"(#version 450 core
layout(location = 0) out vec4 a;
layout(location = 1) out vec4 b;
layout(location = 2) out vec4 c;
void main() { a = b = c = vec4(0.0); }
)";

std::string AreaText() {
  std::string text = "#version 450 core\n";
  text += EdgeFragmentFunctions();
  text += kAreaBody;
  return text;
}

std::string BlendText(const gbuffer::Storage& storage) {
  std::string body(kBlendBody);
  const auto replace = [&](std::string_view name, const std::string& with) {
    body.replace(body.find(name), name.size(), with);
  };
  replace("LOAD", gbuffer::LoadColorExpression(storage, "stored"));
  replace("STORE", gbuffer::StoreExpression(storage, "color"));
  std::string text = "#version 450 core\n";
  text += gbuffer::StorageFunctions();
  return text + body;
}

Result<void> Ensure(gl::Program& program, std::string_view fragment, std::string_view label) {
  if (program) return {};
  Result<gl::Program> made = gl::Program::Create(EdgeQuadVertexText(), fragment, label);
  if (!made) return std::unexpected(made.error());
  program = std::move(*made);
  return {};
}

Result<void> DrawInto(std::span<const gl::Texture* const> targets, const gl::Program& program,
                      const EdgeQuadBuffer& quads) {
  const Result<gl::Framebuffer> framebuffer = gl::Framebuffer::Create(targets, nullptr, "edge resolve");
  if (!framebuffer) return std::unexpected(framebuffer.error());
  framebuffer->Bind();
  glUseProgram(program.id());
  quads.Draw();
  return {};
}

}  // namespace

Result<ResolvePass::Scratch*> ResolvePass::ScratchFor(const gl::Texture& color) {
  const auto fits = [&](const Scratch& scratch) {
    return scratch.copy.width() == color.width() && scratch.copy.height() == color.height() &&
           scratch.copy.format() == color.format();
  };
  if (const auto found = std::ranges::find_if(scratches_, fits); found != scratches_.end()) return &*found;
  Scratch scratch;
  Result<gl::Texture> copy =
      gl::Texture::Create(color.format(), color.width(), color.height(), 1, "edge resolve: copy");
  if (!copy) return std::unexpected(copy.error());
  scratch.copy = std::move(*copy);
  for (gl::Texture& areas : scratch.areas) {
    Result<gl::Texture> made = gl::Texture::Create(gl::PlainFormat(gl::Numeric::kFloat, 16, 4), color.width(),
                                                   color.height(), 1, "edge resolve: areas");
    if (!made) return std::unexpected(made.error());
    const float zero[4] = {0, 0, 0, 0};
    glClearTexImage(made->id(), 0, GL_RGBA, GL_FLOAT, zero);
    areas = std::move(*made);
  }
  scratches_.push_back(std::move(scratch));
  return &scratches_.back();
}

Result<const gl::Program*> ResolvePass::BlendProgram(const gbuffer::Storage& storage) {
  const auto found = std::ranges::find(blends_, storage, &Blend::storage);
  if (found != blends_.end()) return &found->program;
  Blend blend{storage, {}};
  if (auto made = Ensure(blend.program, BlendText(storage), "edge resolve: blend"); !made) {
    return std::unexpected(made.error());
  }
  blends_.push_back(std::move(blend));
  return &blends_.back().program;
}

Result<void> ResolvePass::Draw(const gl::Texture& color, const gbuffer::Storage& storage, const gl::Texture& depth,
                               const EdgeQuadBuffer& quads) {
  if (quads.empty()) return {};
  if (auto made = Ensure(area_program_, AreaText(), "edge resolve: areas"); !made) return made;
  if (auto made = Ensure(clean_program_, kCleanText, "edge resolve: clean"); !made) return made;
  const Result<const gl::Program*> blend = BlendProgram(storage);
  if (!blend) return std::unexpected(blend.error());
  const Result<Scratch*> scratch = ScratchFor(color);
  if (!scratch) return std::unexpected(scratch.error());
  const gl::Texture& copy = (*scratch)->copy;
  const std::array<gl::Texture, 3>& areas = (*scratch)->areas;
  const std::array<const gl::Texture*, 3> area_targets = {&areas[0], &areas[1], &areas[2]};
  const std::array<const gl::Texture*, 1> color_targets = {&color};

  gl::ResetState();
  glCopyImageSubData(color.id(), GL_TEXTURE_2D, 0, 0, 0, 0, copy.id(), GL_TEXTURE_2D, 0, 0, 0, 0, color.width(),
                     color.height(), 1);
  const std::array<GLuint, 5> textures = {depth.id(), areas[0].id(), areas[1].id(), areas[2].id(), copy.id()};
  for (GLuint unit = 0; unit < textures.size(); ++unit) {
    glBindSampler(unit, 0);
    glBindTextureUnit(unit, textures[unit]);
  }
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  if (auto drawn = DrawInto(area_targets, area_program_, quads); !drawn) return drawn;
  glDisable(GL_BLEND);
  if (auto drawn = DrawInto(color_targets, **blend, quads); !drawn) return drawn;
  return DrawInto(area_targets, clean_program_, quads);
}

}  // namespace burin::overdraw

// SPDX-License-Identifier: Apache-2.0
// Going out from a pixel's centre, each edge changes the colour from that on its near side to that on its far side, for
// the area beyond it (gbuffer/edge_glsl.h). So the pixel's colour is the centre's plus, for each edge, its area times
// the difference: right for strips thinner than a pixel, corners, and any chain of short edges, as all terms add up.
// The colours of edges both of whose sides show a surface are the shading of their two faces. An outline's surface has
// the colour of the pixel on it, and its own shading where no pixel is; what lies behind has the colour of the pixel
// there.
#include "core/overdraw/resolve_pass.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <string>

#include "core/gbuffer/edge_glsl.h"
#include "core/gl/framebuffer.h"
#include "core/gl/readback.h"
#include "core/gl/state.h"
#include "core/overdraw/edge_share.h"

namespace burin::overdraw {
namespace {

// Of outlines, towards the right, left, lower and upper neighbour: areas that the surface covers though the centre is
// off it, where the neighbour is on it; areas that it leaves free though the centre is on its side. Sums: x, covered
// areas whose neighbour is not on the surface; y, areas beyond edges that are no outlines; w, all areas.
constexpr std::string_view kAreaBody = R"(
layout(location = 0) out vec4 covered;
layout(location = 1) out vec4 exposed;
layout(location = 2) out vec4 sums;

void main() {
  Beyond beyond;
  if (!EdgeArea(beyond)) discard;
  vec4 areas = beyond.area * max(vec4(beyond.to.x, -beyond.to.x, beyond.to.y, -beyond.to.y), vec4(0.0));
  covered = exposed = vec4(0.0);
  sums = vec4(0.0, 0.0, 0.0, beyond.area);
  float nearest = beyond.z - max(v_depth.z, NEAR_ENOUGH * beyond.z);
  if (v_depth.w >= 0.0) sums.y = beyond.area;
  else if (!beyond.is_inside) exposed = areas;
  else if (SurfaceDepth(ivec2(gl_FragCoord.xy) + beyond.to) >= nearest) covered = areas;
  else sums.x = beyond.area;
}
)";

constexpr std::string_view kBlendBody = R"(
layout(binding = 1) uniform sampler2D covered_texture;
layout(binding = 2) uniform sampler2D exposed_texture;
layout(binding = 3) uniform sampler2D sums_texture;
layout(binding = 4) uniform sampler2D inner_texture;
layout(binding = 5) uniform sampler2D outline_texture;
layout(binding = 6) uniform sampler2D picture;
layout(location = 0) out vec4 result;

vec4 Linear(ivec2 p) {
  vec4 stored = texelFetch(picture, clamp(p, ivec2(0), textureSize(picture, 0) - 1), 0);
  return LOAD;
}

vec4 Neighbours(ivec2 p, vec4 areas) {
  vec4 sum = vec4(0.0);
  if (areas.x > 0.0) sum += areas.x * Linear(p + ivec2(1, 0));
  if (areas.y > 0.0) sum += areas.y * Linear(p - ivec2(1, 0));
  if (areas.z > 0.0) sum += areas.z * Linear(p + ivec2(0, 1));
  if (areas.w > 0.0) sum += areas.w * Linear(p - ivec2(0, 1));
  return sum;
}

void main() {
  ivec2 p = ivec2(gl_FragCoord.xy);
  vec4 covered = texelFetch(covered_texture, p, 0);
  vec4 exposed = texelFetch(exposed_texture, p, 0);
  vec4 sums = texelFetch(sums_texture, p, 0);
  float front = dot(covered, vec4(1.0)) + sums.x;
  float back = dot(exposed, vec4(1.0));
  if (sums.w < 0.0005) discard;
  // Surfaces that cover, less what they leave free again: thin ones cover only the difference.
  float sum = clamp(front - back, -1.0, 1.0);
  vec4 centre = Linear(p);
  // What an outline's surface looks like where the centre may not show it.
  vec4 shade = centre;
  if (sums.x > 0.0 || sums.y > 0.0) {
    vec4 outline = texelFetch(outline_texture, p, 0);
    if (abs(outline.a) > 0.01) shade = max(outline / outline.a, vec4(0.0));
  }
  vec4 color = centre;
  if (sums.y > 0.0) color += texelFetch(inner_texture, p, 0);
  if (sum > 0.0) {
    color += (sum / front) * (Neighbours(p, covered) + sums.x * shade) - sum * centre;
  } else if (sum < 0.0) {
    vec4 near = sums.y > 0.0 ? shade : centre;
    color += (-sum / back) * Neighbours(p, exposed) + sum * near;
  }
  color = max(color, vec4(0.0));
  // Shading at the edge itself may catch a highlight that no pixel has, and differences of highlights leave holes.
  if (sums.y > 0.0) {
    vec4 low = centre, high = centre;
    for (int i = 0; i < 9; ++i) {
      vec4 c = Linear(p + ivec2(i % 3 - 1, i / 3 - 1));
      low = min(low, c);
      high = max(high, c);
    }
    color = clamp(color, low, high);
  }
  result = STORE;
}
)";

constexpr std::string_view kCleanText = R"(#version 450 core
layout(location = 0) out vec4 a;
layout(location = 1) out vec4 b;
layout(location = 2) out vec4 c;
layout(location = 3) out vec4 d;
layout(location = 4) out vec4 e;
void main() { a = b = c = d = e = vec4(0.0); }
)";

// A neighbour this much behind the edge, as a share of the depth, may still be on the outline's surface.
constexpr float kNearEnough = 0.02f;

std::string AreaText() {
  std::string text = fmt::format("#version 450 core\nconst float NEAR_ENOUGH = {};\n", kNearEnough);
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

Result<gl::Framebuffer> Bind(std::span<const gl::Texture* const> targets) {
  Result<gl::Framebuffer> framebuffer = gl::Framebuffer::Create(targets, nullptr, "edge resolve");
  if (framebuffer) framebuffer->Bind();
  return framebuffer;
}

Result<void> DrawInto(std::span<const gl::Texture* const> targets, const gl::Program& program,
                      const EdgeQuadBuffer& quads) {
  const Result<gl::Framebuffer> framebuffer = Bind(targets);
  if (!framebuffer) return std::unexpected(framebuffer.error());
  glUseProgram(program.id());
  quads.Draw();
  return {};
}

Result<void> AddLines(const gl::Texture& sums, std::span<const gbuffer::ShadedLine> lines,
                      const gbuffer::LineDrawer& draw_lines) {
  if (lines.empty()) return {};
  const std::array<const gl::Texture*, 1> targets = {&sums};
  const Result<gl::Framebuffer> framebuffer = Bind(targets);
  if (!framebuffer) return std::unexpected(framebuffer.error());
  return draw_lines(lines);
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
  for (gl::Texture& sums : scratch.sums) {
    Result<gl::Texture> made = gl::Texture::Create(gl::PlainFormat(gl::Numeric::kFloat, 16, 4), color.width(),
                                                   color.height(), 1, "edge resolve: sums");
    if (!made) return std::unexpected(made.error());
    const float zero[4] = {0, 0, 0, 0};
    glClearTexImage(made->id(), 0, GL_RGBA, GL_FLOAT, zero);
    sums = std::move(*made);
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
                               const EdgeQuadBuffer& quads, const AreaLines& lines,
                               const gbuffer::LineDrawer& draw_lines) {
  if (quads.empty()) return {};
  if (auto made = Ensure(area_program_, AreaText(), "edge resolve: areas"); !made) return made;
  if (auto made = Ensure(clean_program_, kCleanText, "edge resolve: clean"); !made) return made;
  const Result<const gl::Program*> blend = BlendProgram(storage);
  if (!blend) return std::unexpected(blend.error());
  const Result<Scratch*> scratch = ScratchFor(color);
  if (!scratch) return std::unexpected(scratch.error());
  const gl::Texture& copy = (*scratch)->copy;
  const std::array<gl::Texture, kSums>& sums = (*scratch)->sums;
  const std::array<const gl::Texture*, kSums> all = {&sums[0], &sums[1], &sums[2], &sums[3], &sums[4]};
  const std::array<const gl::Texture*, 1> color_targets = {&color};

  gl::ResetState();
  glCopyImageSubData(color.id(), GL_TEXTURE_2D, 0, 0, 0, 0, copy.id(), GL_TEXTURE_2D, 0, 0, 0, 0, color.width(),
                     color.height(), 1);
  const auto bind = [&] {
    const std::array<GLuint, 7> textures = {depth.id(),   sums[0].id(), sums[1].id(), sums[2].id(),
                                            sums[3].id(), sums[4].id(), copy.id()};
    for (GLuint unit = 0; unit < textures.size(); ++unit) {
      glBindSampler(unit, 0);
      glBindTextureUnit(unit, textures[unit]);
    }
  };
  bind();
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  if (auto drawn = DrawInto(std::span(all).first(kInner), area_program_, quads); !drawn) return drawn;
  if (auto drawn = AddLines(sums[kInner], lines.inner, draw_lines); !drawn) return drawn;
  if (auto drawn = AddLines(sums[kOutline], lines.outlines, draw_lines); !drawn) return drawn;
  gl::ResetState();
  bind();
  if (auto drawn = DrawInto(color_targets, **blend, quads); !drawn) return drawn;
  if (!share_) share_ = ShareNearEdges(gl::Read(sums[kOthers], image::SampleType::kF32, 4, image::Encoding::kData));
  return DrawInto(all, clean_program_, quads);
}

}  // namespace burin::overdraw

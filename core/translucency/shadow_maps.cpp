// SPDX-License-Identifier: Apache-2.0
#include "core/translucency/shadow_maps.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "core/gbuffer/geometry_shader.h"
#include "core/gl/debug.h"

namespace burin::translucency {
namespace {

// A light nearer than so many radii of the body takes six maps.
constexpr float kBeside = 1.3f;
constexpr float kMargin = 1.02f;
constexpr float kNearest = 1e-3f;  // near plane, of the distance

constexpr std::string_view kVertexText = R"(
layout(location = 0) in vec3 in_position;
layout(location = 0) uniform mat4 shadow_from_world;
void main() { gl_Position = shadow_from_world * (world_from_object * vec4(in_position, 1.0)); }
)";

// What the alpha of a cut-out depends on; the outputs are SurfaceText's inputs.
constexpr std::string_view kCutOutVertexText = R"(
layout(location = 0) in vec3 in_position;
layout(location = 4) in vec4 in_color;
layout(location = 8) in vec2 in_texcoord0;
layout(location = 9) in vec2 in_texcoord1;
layout(location = 0) uniform mat4 shadow_from_world;
layout(location = 0) out vec3 v_position;
layout(location = 3) out vec4 v_color;
layout(location = 4) out vec2 v_texcoord0;
layout(location = 5) out vec2 v_texcoord1;
void main() {
  vec4 world = world_from_object * vec4(in_position, 1.0);
  v_position = world.xyz;
  v_color = in_color;
  v_texcoord0 = in_texcoord0;
  v_texcoord1 = in_texcoord1;
  gl_Position = shadow_from_world * world;
}
)";

constexpr std::uint32_t kCutOutFeatures = gbuffer::kIsMasked | gbuffer::kHasBaseColorTexture;

struct Map {
  glm::mat4 clip_from_world{1.0f};
  glm::vec4 texel{0.0f};
};

glm::mat4 LookAlong(const glm::vec3& from, const glm::vec3& direction) {
  const glm::vec3 up = std::abs(direction.y) < 0.9f ? glm::vec3(0.0f, 1.0f, 0.0f) : glm::vec3(1.0f, 0.0f, 0.0f);
  return glm::lookAt(from, from + direction, up);
}

// Reversed depth without a far plane: near / distance.
glm::mat4 Perspective(float tangent, float near_plane) {
  glm::mat4 clip(0.0f);
  clip[0][0] = clip[1][1] = 1.0f / tangent;
  clip[2][3] = -1.0f;
  clip[3][2] = near_plane;
  return clip;
}

Map Directional(const glm::vec3& direction, const Sphere& body, int texels) {
  const float r = body.radius * kMargin;
  glm::mat4 clip(1.0f);
  clip[0][0] = clip[1][1] = 1.0f / r;
  clip[2][2] = 0.5f / r;  // nearest to the light: 1
  clip[3][2] = 0.5f;
  return {clip * LookAlong(body.center, direction), glm::vec4(2.0f * r / static_cast<float>(texels), 0.0f, 0.0f, 0.0f)};
}

Map Narrow(const glm::vec3& position, const Sphere& body, int texels) {
  const float distance = glm::distance(position, body.center);
  const float tangent =
      kMargin * body.radius / std::sqrt(std::max(distance * distance - body.radius * body.radius, 1e-12f));
  return {Perspective(tangent, kNearest * distance) * LookAlong(position, (body.center - position) / distance),
          glm::vec4(0.0f, 2.0f * tangent / static_cast<float>(texels), 0.0f, 0.0f)};
}

// A little wider than a right angle, so that filtering finds what lies beside it.
Map CubeFace(const glm::vec3& position, int face, const Sphere& body, int texels) {
  glm::vec3 direction(0.0f);
  direction[face / 2] = face % 2 == 0 ? 1.0f : -1.0f;
  const float tangent = 1.0f + 4.0f / static_cast<float>(texels);
  return {Perspective(tangent, kNearest * body.radius) * LookAlong(position, direction),
          glm::vec4(0.0f, 2.0f * tangent / static_cast<float>(texels), 0.0f, 0.0f)};
}

std::vector<Map> MapsOf(const gbuffer::LightRecord& light, const Sphere& body, int texels) {
  if (light.direction.w < 0.5f) return {Directional(glm::vec3(light.direction), body, texels)};
  const glm::vec3 position(light.position);
  if (glm::distance(position, body.center) > kBeside * body.radius) return {Narrow(position, body, texels)};
  std::vector<Map> maps;
  for (int face = 0; face < 6; ++face) maps.push_back(CubeFace(position, face, body, texels));
  return maps;
}

Result<void> Ensure(ShadowMaps& maps, int count, int texels) {
  if (maps.texture && maps.count >= count && maps.texels == texels) return {};
  GLuint id = 0;
  glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &id);
  maps.texture = gl::TextureHandle(id);
  while (glGetError() != GL_NO_ERROR) {
  }
  glTextureStorage3D(id, 1, GL_DEPTH_COMPONENT32F, texels, texels, count);
  if (glGetError() != GL_NO_ERROR) {
    return Fail(ErrorKind::kFailed,
                fmt::format("no memory on the device for {} shadow maps of {}x{}", count, texels, texels));
  }
  gl::SetLabel(GL_TEXTURE, id, "shadow maps");
  maps.count = count;
  maps.texels = texels;
  return {};
}

bool CastsShadow(const gbuffer::PreparedDraw& draw) {
  return draw.primitive->mode == GL_TRIANGLES && (draw.features & gbuffer::kIsUnlit) == 0;
}

}  // namespace

int CountShadowMaps(std::span<const gbuffer::LightRecord> lights, const Sphere& body) {
  std::size_t count = 0;
  for (const gbuffer::LightRecord& light : lights.first(std::min<std::size_t>(lights.size(), kMaxShadowedLights))) {
    const std::size_t more = MapsOf(light, body, 1).size();
    if (count + more <= kMaxShadowMaps) count += more;
  }
  return static_cast<int>(std::max<std::size_t>(count, 1));
}

Result<const gl::Program*> ShadowPass::ProgramOf(std::uint32_t features) {
  gl::Program& program = programs_[features];
  if (program) return &program;
  const bool is_cut_out = (features & gbuffer::kIsMasked) != 0;
  const std::string vertex = "#version 450 core\n" + std::string(gbuffer::BlockDeclarations()) +
                             std::string(is_cut_out ? kCutOutVertexText : kVertexText);
  const std::string fragment =
      is_cut_out ? gbuffer::SurfaceText(features) + "void main() { GetSurface(); }\n" : std::string();
  Result<gl::Program> made = gl::Program::Create({vertex, {}, fragment}, fmt::format("shadow maps 0x{:x}", features));
  if (!made) return std::unexpected(made.error());
  program = *std::move(made);
  return &program;
}

void ShadowPass::EnsureTools() {
  if (framebuffer_) return;
  GLuint id = 0;
  glCreateFramebuffers(1, &id);
  framebuffer_ = gl::FramebufferHandle(id);
  glNamedFramebufferDrawBuffer(id, GL_NONE);
  glCreateSamplers(1, &id);
  sampler_ = gl::SamplerHandle(id);
  glSamplerParameteri(id, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glSamplerParameteri(id, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glSamplerParameteri(id, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glSamplerParameteri(id, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glSamplerParameteri(id, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glSamplerParameteri(id, GL_TEXTURE_COMPARE_FUNC, GL_GEQUAL);
}

Result<void> ShadowPass::DrawCasters(const glm::mat4& clip_from_world, const Casters& casters) {
  for (const gbuffer::PreparedDraw& draw : casters.draws.opaque) {
    if (!CastsShadow(draw)) continue;
    const bool is_cut_out = (draw.features & gbuffer::kIsMasked) != 0;
    const std::uint32_t features = is_cut_out ? draw.features & kCutOutFeatures : 0u;
    const Result<const gl::Program*> program = ProgramOf(features);
    if (!program) return std::unexpected(program.error());
    glUseProgram((*program)->id());
    glUniformMatrix4fv(0, 1, GL_FALSE, &clip_from_world[0][0]);
    if (is_cut_out) {
      if (auto bound = casters.materials.Bind(draw.material, features); !bound) return bound;
    }
    glFrontFace(draw.is_mirrored ? GL_CW : GL_CCW);
    // A translucent surface bounds a solid: light from inside, through a hole of the mesh, must not get out.
    const bool has_back = draw.is_double_sided || (draw.features & gbuffer::kIsTranslucent) != 0;
    has_back ? glDisable(GL_CULL_FACE) : glEnable(GL_CULL_FACE);
    glBindBufferRange(GL_UNIFORM_BUFFER, gbuffer::kDrawBinding, casters.draws.block_buffer,
                      static_cast<GLintptr>(draw.block * gbuffer::AlignBlock(sizeof(gbuffer::DrawBlock))),
                      sizeof(gbuffer::DrawBlock));
    glBindVertexArray(draw.primitive->vertex_array.id());
    glDrawElements(GL_TRIANGLES, draw.primitive->index_count, GL_UNSIGNED_INT, nullptr);
  }
  return {};
}

Result<void> ShadowPass::Draw(std::span<const gbuffer::LightRecord> lights, const Casters& casters, const Sphere& body,
                              int texels, ShadowMaps& maps, ShadowBlock& block) {
  std::vector<Map> found;
  for (std::size_t i = 0; i < std::min(lights.size(), block.of_light.size()); ++i) {
    const std::vector<Map> of_light = MapsOf(lights[i], body, texels);
    const bool fits = found.size() + of_light.size() <= kMaxShadowMaps;
    block.of_light[i] = glm::ivec4(static_cast<int>(found.size()), fits ? static_cast<int>(of_light.size()) : 0, 0, 0);
    if (fits) found.insert(found.end(), of_light.begin(), of_light.end());
  }
  if (auto ready = Ensure(maps, std::max(static_cast<int>(found.size()), 1), texels); !ready) return ready;
  EnsureTools();
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  glViewport(0, 0, texels, texels);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  glDepthMask(GL_TRUE);
  glCullFace(GL_BACK);
  glEnable(GL_DEPTH_CLAMP);  // what lies between the light and the near plane casts shadows too
  for (std::size_t i = 0; i < found.size(); ++i) {
    block.clip_from_world[i] = found[i].clip_from_world;
    block.texel[i] = found[i].texel;
    glNamedFramebufferTextureLayer(framebuffer_.id(), GL_DEPTH_ATTACHMENT, maps.texture.id(), 0, static_cast<int>(i));
    constexpr float kFarthest = 0.0f;
    glClearNamedFramebufferfv(framebuffer_.id(), GL_DEPTH, 0, &kFarthest);
    if (auto drawn = DrawCasters(found[i].clip_from_world, casters); !drawn) return drawn;
  }
  glFrontFace(GL_CCW);
  glDisable(GL_CULL_FACE);
  glDisable(GL_DEPTH_CLAMP);
  return {};
}

void ShadowPass::Bind(const ShadowMaps& maps) const {
  glBindTextureUnit(kShadowUnit, maps.texture.id());
  glBindSampler(kShadowUnit, sampler_.id());
}

}  // namespace burin::translucency

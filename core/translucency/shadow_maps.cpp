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

bool CastsShadow(const gbuffer::PreparedDraw& draw) {
  return draw.primitive->mode == GL_TRIANGLES && (draw.features & gbuffer::kIsUnlit) == 0;
}

}  // namespace

Result<void> ShadowMaps::EnsureMaps(int count, int texels) {
  if (!program_) {
    const std::string vertex =
        "#version 450 core\n" + std::string(gbuffer::BlockDeclarations()) + std::string(kVertexText);
    Result<gl::Program> program = gl::Program::Create({vertex, {}, {}}, "shadow maps");
    if (!program) return std::unexpected(program.error());
    program_ = *std::move(program);
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
  if (maps_ && count_ >= count && texels_ == texels) return {};
  GLuint id = 0;
  glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &id);
  maps_ = gl::TextureHandle(id);
  while (glGetError() != GL_NO_ERROR) {
  }
  glTextureStorage3D(id, 1, GL_DEPTH_COMPONENT32F, texels, texels, count);
  if (glGetError() != GL_NO_ERROR) {
    return Fail(ErrorKind::kFailed,
                fmt::format("no memory on the device for {} shadow maps of {}x{}", count, texels, texels));
  }
  gl::SetLabel(GL_TEXTURE, id, "shadow maps");
  count_ = count;
  texels_ = texels;
  return {};
}

void ShadowMaps::DrawMap(const glm::mat4& clip_from_world, int map, const gbuffer::FrameDraws& draws) {
  glNamedFramebufferTextureLayer(framebuffer_.id(), GL_DEPTH_ATTACHMENT, maps_.id(), 0, map);
  constexpr float kFarthest = 0.0f;
  glClearNamedFramebufferfv(framebuffer_.id(), GL_DEPTH, 0, &kFarthest);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  glViewport(0, 0, texels_, texels_);
  glUniformMatrix4fv(0, 1, GL_FALSE, &clip_from_world[0][0]);
  for (const gbuffer::PreparedDraw& draw : draws.opaque) {
    if (!CastsShadow(draw)) continue;
    glBindBufferRange(GL_UNIFORM_BUFFER, gbuffer::kDrawBinding, draws.block_buffer,
                      static_cast<GLintptr>(draw.block * gbuffer::AlignBlock(sizeof(gbuffer::DrawBlock))),
                      sizeof(gbuffer::DrawBlock));
    glBindVertexArray(draw.primitive->vertex_array.id());
    glDrawElements(GL_TRIANGLES, draw.primitive->index_count, GL_UNSIGNED_INT, nullptr);
  }
}

Result<void> ShadowMaps::Draw(std::span<const gbuffer::LightRecord> lights, const gbuffer::FrameDraws& draws,
                              const Sphere& body, int texels, ShadowBlock& block) {
  std::vector<Map> maps;
  for (std::size_t i = 0; i < std::min(lights.size(), block.of_light.size()); ++i) {
    const std::vector<Map> of_light = MapsOf(lights[i], body, texels);
    const bool fits = maps.size() + of_light.size() <= kMaxShadowMaps;
    block.of_light[i] = glm::ivec4(static_cast<int>(maps.size()), fits ? static_cast<int>(of_light.size()) : 0, 0, 0);
    if (fits) maps.insert(maps.end(), of_light.begin(), of_light.end());
  }
  if (auto ready = EnsureMaps(std::max(static_cast<int>(maps.size()), 1), texels); !ready) return ready;
  glUseProgram(program_.id());
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  glDepthMask(GL_TRUE);
  glDisable(GL_CULL_FACE);
  glEnable(GL_DEPTH_CLAMP);  // what lies between the light and the near plane casts shadows too
  for (std::size_t i = 0; i < maps.size(); ++i) {
    block.clip_from_world[i] = maps[i].clip_from_world;
    block.texel[i] = maps[i].texel;
    DrawMap(maps[i].clip_from_world, static_cast<int>(i), draws);
  }
  glDisable(GL_DEPTH_CLAMP);
  return {};
}

void ShadowMaps::Bind() const {
  glBindTextureUnit(kShadowUnit, maps_.id());
  glBindSampler(kShadowUnit, sampler_.id());
}

}  // namespace burin::translucency

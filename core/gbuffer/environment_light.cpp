// SPDX-License-Identifier: Apache-2.0
#include "core/gbuffer/environment_light.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <bit>

#include "core/gl/debug.h"

namespace burin::gbuffer {
namespace {

constexpr int kLargestFace = 256;
constexpr int kBuiltinFace = 64;  // the studio's lamps have soft rims

// A face covers a quarter of the map's width.
int FaceSize(const EnvironmentMap& map) {
  return std::clamp(static_cast<int>(std::bit_floor(static_cast<unsigned>(std::max(1, map.width / 4)))), 16,
                    kLargestFace);
}

gl::TextureHandle Upload(const ReflectionMap& reflections) {
  GLuint id = 0;
  glCreateTextures(GL_TEXTURE_CUBE_MAP, 1, &id);
  gl::TextureHandle texture(id);
  const auto levels = static_cast<GLsizei>(reflections.levels.size());
  glTextureStorage2D(id, levels, GL_RGBA16F, reflections.face_size, reflections.face_size);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  for (GLsizei level = 0; level < levels; ++level) {
    const int size = std::max(1, reflections.face_size >> level);
    glTextureSubImage3D(id, level, 0, 0, 0, size, size, 6, GL_RGB, GL_FLOAT,
                        reflections.levels[static_cast<std::size_t>(level)].data());
  }
  glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl::SetLabel(GL_TEXTURE, id, "environment reflections");
  return texture;
}

}  // namespace

void EnvironmentLight::Prepare() {
  if (reflections_) return;
  if (!map_) map_ = StudioEnvironment();
  const std::array<glm::vec3, 9> irradiance = ProjectIrradiance(*map_);
  for (std::size_t i = 0; i < irradiance.size(); ++i) irradiance_[i] = glm::vec4(irradiance[i], 0.0f);
  const ReflectionMap reflections = FilterReflections(*map_, is_builtin_ ? kBuiltinFace : FaceSize(*map_));
  last_level_ = static_cast<int>(reflections.levels.size()) - 1;
  reflections_ = Upload(reflections);
  map_.reset();
}

void EnvironmentLight::Bind(unsigned unit) const {
  glBindTextureUnit(unit, reflections_.id());
  glBindSampler(unit, 0);
}

}  // namespace burin::gbuffer

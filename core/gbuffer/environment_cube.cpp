// SPDX-License-Identifier: Apache-2.0
#include "core/gbuffer/environment_cube.h"

#include <epoxy/gl.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "core/gbuffer/cube_face.h"
#include "core/gbuffer/environment.h"
#include "core/gl/debug.h"
#include "core/image/srgb.h"

namespace burin::gbuffer {
namespace {

constexpr int kFaces = 6;
constexpr int kFaceSize = 128;

std::uint8_t Encode(float linear) {
  return static_cast<std::uint8_t>(std::lround(image::SrgbFromLinear(std::clamp(linear, 0.0f, 1.0f)) * 255.0f));
}

std::vector<std::uint8_t> Texels(const EnvironmentMap& map) {
  std::vector<std::uint8_t> texels(4u * kFaces * kFaceSize * kFaceSize);
  const auto place = [](int i) { return 2.0f * (static_cast<float>(i) + 0.5f) / static_cast<float>(kFaceSize) - 1.0f; };
  tbb::parallel_for(0, kFaces * kFaceSize, [&](int row) {
    for (int column = 0; column < kFaceSize; ++column) {
      const glm::vec3 light = SampleEnvironment(
          map, glm::normalize(CubeFaceDirection(row / kFaceSize, place(column), place(row % kFaceSize))));
      std::uint8_t* texel = &texels[4 * static_cast<std::size_t>(row * kFaceSize + column)];
      for (int c = 0; c < 3; ++c) texel[c] = Encode(light[c]);
      texel[3] = 255;
    }
  });
  return texels;
}

}  // namespace

std::uint32_t EnvironmentCube::id() {
  if (texture_) return texture_.id();
  EnvironmentMap map = StudioEnvironment();
  if (environment_ != nullptr) {
    auto read = EnvironmentFromImage(*environment_);
    if (!read) return 0;
    map = *std::move(read);
  }
  const std::vector<std::uint8_t> texels = Texels(map);
  GLuint id = 0;
  glCreateTextures(GL_TEXTURE_CUBE_MAP, 1, &id);
  texture_ = gl::TextureHandle(id);
  glTextureStorage2D(id, std::bit_width(static_cast<unsigned>(kFaceSize)), GL_RGBA8, kFaceSize, kFaceSize);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  glTextureSubImage3D(id, 0, 0, 0, 0, kFaceSize, kFaceSize, kFaces, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  glGenerateTextureMipmap(id);
  gl::SetLabel(GL_TEXTURE, id, "environment for effects");
  return id;
}

}  // namespace burin::gbuffer

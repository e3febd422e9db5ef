// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/packing.hpp>

#include "core/gbuffer/environment.h"
#include "core/gbuffer/equirectangular.h"
#include "core/image/srgb.h"

namespace burin::gbuffer {
namespace {

constexpr float kPi = glm::pi<float>();
constexpr float kMaxRadiance = 65504.0f;  // reflections are kept as halves

float Sample(const image::Image& image, std::size_t i) {
  switch (image.type) {
    case image::SampleType::kU8:
      return static_cast<float>(image.As<std::uint8_t>()[i]) / 255.0f;
    case image::SampleType::kU16:
      return static_cast<float>(image.As<std::uint16_t>()[i]) / 65535.0f;
    case image::SampleType::kU32:
      return static_cast<float>(image.As<std::uint32_t>()[i]);
    case image::SampleType::kF16:
      return glm::unpackHalf1x16(image.As<std::uint16_t>()[i]);
    case image::SampleType::kF32:
      return image.As<float>()[i];
  }
  return 0.0f;
}

float Clean(float value) { return value > 0.0f ? std::min(value, kMaxRadiance) : 0.0f; }  // NaN fails the test

float SmoothStep(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

}  // namespace

Result<EnvironmentMap> EnvironmentFromImage(const image::Image& image) {
  const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  if (count == 0 || image.channels < 1) return Fail(ErrorKind::kInput, "the environment map is empty");
  EnvironmentMap map{.width = image.width, .height = image.height, .pixels = std::vector<glm::vec3>(count)};
  const auto channels = static_cast<std::size_t>(image.channels);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      float value = Sample(image, i * channels + (channels >= 3 ? c : 0));
      if (image.encoding == image::Encoding::kDisplay) value = image::LinearFromSrgb(value);
      map.pixels[i][static_cast<glm::length_t>(c)] = Clean(value);
    }
  }
  if (const auto layout = image::CubeLayoutOf(map.width, map.height)) return EquirectangularOf(map, *layout);
  return map;
}

glm::vec3 StudioKeyDirection() { return glm::normalize(glm::vec3(-0.45f, 0.75f, 0.6f)); }

EnvironmentMap StudioEnvironment() {
  constexpr int kWidth = 128;
  constexpr int kHeight = 64;
  const glm::vec3 key = StudioKeyDirection();
  const glm::vec3 rim = glm::normalize(glm::vec3(0.7f, 0.35f, -0.65f));
  EnvironmentMap map{.width = kWidth, .height = kHeight, .pixels = {}};
  map.pixels.reserve(static_cast<std::size_t>(kWidth) * kHeight);
  for (int y = 0; y < kHeight; ++y) {
    const float latitude = kPi * (0.5f - (static_cast<float>(y) + 0.5f) / kHeight);
    for (int x = 0; x < kWidth; ++x) {
      const float longitude = 2.0f * kPi * ((static_cast<float>(x) + 0.5f) / kWidth - 0.5f);
      const glm::vec3 direction(std::cos(latitude) * std::sin(longitude), std::sin(latitude),
                                -std::cos(latitude) * std::cos(longitude));
      // Walls grow lighter from the floor to the ceiling; the lamps are round with soft rims.
      float radiance = 0.13f + 0.25f * SmoothStep(-0.6f, 1.0f, direction.y);
      radiance += 2.8f * SmoothStep(0.78f, 0.95f, glm::dot(direction, key));
      radiance += 1.4f * SmoothStep(0.86f, 0.98f, glm::dot(direction, rim));
      map.pixels.emplace_back(radiance);
    }
  }
  return map;
}

glm::vec3 SampleEnvironment(const EnvironmentMap& map, const glm::vec3& direction) {
  const glm::vec3 d = glm::normalize(direction);
  const float u = 0.5f + std::atan2(d.x, -d.z) / (2.0f * kPi);
  const float v = 0.5f - std::asin(std::clamp(d.y, -1.0f, 1.0f)) / kPi;
  const float x = u * static_cast<float>(map.width) - 0.5f;
  const float y = std::clamp(v * static_cast<float>(map.height) - 0.5f, 0.0f, static_cast<float>(map.height - 1));
  const int x0 = static_cast<int>(std::floor(x));
  const int y0 = static_cast<int>(y);
  const int y1 = std::min(y0 + 1, map.height - 1);
  const float fx = x - static_cast<float>(x0);
  const float fy = y - static_cast<float>(y0);
  const auto at = [&](int column, int row) {
    const int wrapped = column < 0 ? column + map.width : column >= map.width ? column - map.width : column;
    return map.pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(map.width) +
                      static_cast<std::size_t>(wrapped)];
  };
  const glm::vec3 top = at(x0, y0) * (1.0f - fx) + at(x0 + 1, y0) * fx;
  const glm::vec3 bottom = at(x0, y1) * (1.0f - fx) + at(x0 + 1, y1) * fx;
  return top * (1.0f - fy) + bottom * fy;
}

}  // namespace burin::gbuffer

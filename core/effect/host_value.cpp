// SPDX-License-Identifier: Apache-2.0
#include "core/effect/host_value.h"

#include <algorithm>
#include <glm/matrix.hpp>

#include "core/effect/light_view.h"

namespace burin::effect {
namespace {

using Kind = HostValue::Kind;

// Light from all around, of effects that ask for it: no scene says how much there is.
constexpr glm::vec3 kAmbientLight(0.35f);
// What of its diffuse colour a material shows of it.
constexpr float kAmbientShare = 0.5f;

glm::mat4 Matrix(const HostValue& host, const FrameContext& context) {
  glm::mat4 matrix(1.0f);
  if (host.world) matrix = context.world_from_object;
  if (host.is_seen_from_light) {
    const LightView view = LightViewOf(context, host.light);
    if (host.view) matrix = view.view_from_world * matrix;
    if (host.projection) matrix = view.clip_from_view * matrix;
  } else if (host.view) {
    matrix = (host.previous ? context.previous_view_from_world : context.view_from_world) * matrix;
  }
  if (host.projection && !host.is_seen_from_light)
    matrix = (host.previous ? context.previous_clip_from_view : context.clip_from_view) * matrix;
  if (host.inverse) matrix = glm::inverse(matrix);
  if (host.transpose) matrix = glm::transpose(matrix);
  return matrix;
}

glm::vec4 InSpace(const HostValue& host, const FrameContext& context, const glm::vec4& world) {
  switch (host.space) {
    case HostValue::Space::kWorld:
      return world;
    case HostValue::Space::kView:
      return context.view_from_world * world;
    case HostValue::Space::kObject:
      return glm::inverse(context.world_from_object) * world;
  }
  return world;
}

std::optional<glm::vec4> OfLight(const HostValue& host, const FrameContext& context, std::size_t element) {
  if (host.kind == Kind::kLightAmbient)
    return glm::vec4(host.light + element == 0 ? kAmbientLight : glm::vec3(0.0f), 1.0f);
  if (host.kind == Kind::kLightCount)
    return glm::vec4(static_cast<float>(std::max<std::size_t>(1, context.lights.size())));
  const auto light = LightAt(context, host.light + element);
  if (!light) return std::nullopt;
  switch (host.kind) {
    case Kind::kLightPosition:
      return InSpace(host, context, {PositionOf(*light, context), 1.0f});
    case Kind::kLightDirection: {
      const glm::vec4 direction = InSpace(host, context, {DirectionOf(*light, context), 0.0f});
      return host.points_to_light ? -direction : direction;
    }
    case Kind::kLightRange: {
      constexpr float kEndless = 1.0e6f;
      return glm::vec4(light->range > 0.0f ? light->range : kEndless);
    }
    default:
      return light->color;
  }
}

glm::vec4 OfMaterial(const HostValue& host, const MaterialContext& material) {
  switch (host.kind) {
    case Kind::kMaterialDiffuse:
      return material.diffuse;
    case Kind::kMaterialAmbient:
      return {glm::vec3(material.diffuse) * kAmbientShare, 1.0f};
    case Kind::kMaterialSpecular:
      return {material.specular, 1.0f};
    case Kind::kMaterialEmissive:
      return {material.emissive, 1.0f};
    case Kind::kMaterialHasTexture:
      return glm::vec4(material.has_texture ? 1.0f : 0.0f);
    case Kind::kMaterialOpacity:
      return glm::vec4(material.diffuse.a);
    default:
      return glm::vec4(material.specular_power);
  }
}

glm::vec4 OfFrame(const HostValue& host, const FrameContext& context, std::span<const glm::ivec2> texture_sizes) {
  switch (host.kind) {
    case Kind::kTime:
      return glm::vec4(static_cast<float>(context.time_s));
    case Kind::kLastTime:
      return glm::vec4(static_cast<float>(context.time_s - context.elapsed_s));
    case Kind::kElapsedTime:
      return glm::vec4(static_cast<float>(context.elapsed_s));
    case Kind::kFrameSize:
      return {context.width, context.height, 0.0f, 0.0f};
    case Kind::kHalfPixelSize:
      return {0.5f / static_cast<float>(context.width), 0.5f / static_cast<float>(context.height), 0.0f, 0.0f};
    case Kind::kTexelSize: {
      const glm::ivec2 size = host.texture ? texture_sizes[*host.texture] : glm::ivec2(context.width, context.height);
      return {1.0f / static_cast<float>(size.x), 1.0f / static_cast<float>(size.y), 0.0f, 0.0f};
    }
    case Kind::kEyePosition:
      return InSpace(host, context, {context.eye_world, 1.0f});
    case Kind::kViewDirection: {
      // View space looks along -z; the third row of the rotation is its z axis in world space.
      const glm::mat4& view = context.view_from_world;
      return InSpace(host, context, {-view[0][2], -view[1][2], -view[2][2], 0.0f});
    }
    default:
      return glm::vec4(0.0f);
  }
}

std::optional<glm::vec4> Vector(const HostValue& host, const FrameContext& context,
                                std::span<const glm::ivec2> texture_sizes, std::size_t element) {
  if (host.kind >= Kind::kLightPosition && host.kind <= Kind::kLightCount) return OfLight(host, context, element);
  if (host.is_of_material()) return OfMaterial(host, context.material);
  return OfFrame(host, context, texture_sizes);
}

void WriteMatrix(const glm::mat4& matrix, const fx::Type& type, bool column_vectors, std::span<double> numbers) {
  for (int row = 0; row < type.rows; ++row) {
    for (int column = 0; column < type.columns; ++column) {
      const std::size_t index = static_cast<std::size_t>(row * type.columns + column);
      numbers[index] = column_vectors ? matrix[column][row] : matrix[row][column];
    }
  }
}

}  // namespace

void Evaluate(const HostValue& host, const FrameContext& context, std::span<const glm::ivec2> texture_sizes,
              const fx::Type& type, bool column_vectors, std::span<double> numbers) {
  if (host.yields_to_default && !context.has_scene) return;
  const auto size = static_cast<std::size_t>(type.components());
  for (std::size_t element = 0; (element + 1) * size <= numbers.size(); ++element) {
    const std::span<double> part = numbers.subspan(element * size, size);
    if (host.kind == Kind::kMatrix) {
      WriteMatrix(Matrix(host, context), type, column_vectors, part);
    } else if (host.kind == Kind::kFrame) {
      part[0] = static_cast<double>(context.frame);
    } else if (host.kind == Kind::kConstant) {
      std::copy_n(host.constant.begin(), std::min(part.size(), host.constant.size()), part.begin());
    } else if (const auto vector = Vector(host, context, texture_sizes, element)) {
      for (std::size_t i = 0; i < part.size() && i < 4; ++i) part[i] = (*vector)[static_cast<int>(i)];
    }
  }
}

}  // namespace burin::effect

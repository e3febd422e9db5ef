// SPDX-License-Identifier: Apache-2.0
// Values by semantic, as the samples of the DirectX SDK, DXSAS 1.0 and NVIDIA's SAS 0.8 name them.
#include "core/effect/host_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/matrix.hpp>

#include "core/effect/text.h"

namespace burin::effect {
namespace {

using Kind = HostValue::Kind;

// How far away a light without a place is put, in scene units.
constexpr float kFarLight = 1.0e4f;

HostValue OfKind(Kind kind) {
  HostValue host;
  host.kind = kind;
  return host;
}

bool Eat(std::string_view& text, std::string_view word) {
  if (!text.starts_with(word)) return false;
  text.remove_prefix(word.size());
  return true;
}

// "worldviewprojectioninversetranspose" and the short forms that 3ds Max and Maya use ("worldit", "viewi").
std::optional<HostValue> ParseMatrix(std::string_view text) {
  HostValue host;
  host.previous = Eat(text, "previous") || Eat(text, "prev");
  if (Eat(text, "model")) {
    host.world = true;
    if (text.empty()) return host;
  } else {
    host.world = Eat(text, "world");
  }
  host.view = Eat(text, "view");
  host.projection = Eat(text, "projection") || Eat(text, "proj");
  if (!host.world && !host.view && !host.projection) return std::nullopt;
  if (Eat(text, "inverse") || Eat(text, "inv") || text == "i" || text == "it") {
    host.inverse = true;
    if (text.starts_with('i')) text.remove_prefix(1);
  }
  host.transpose = Eat(text, "transpose") || text == "t";
  if (text == "t") text = {};
  if (!text.empty()) return std::nullopt;
  return host;
}

struct NamedValue {
  std::string_view name;
  Kind kind;
};
constexpr NamedValue kSemantics[] = {
    {"time", Kind::kTime},
    {"elapsedtime", Kind::kElapsedTime},
    {"frame", Kind::kFrame},
    {"framesize", Kind::kFrameSize},
    {"viewportpixelsize", Kind::kFrameSize},
    {"viewportsize", Kind::kFrameSize},
    {"texelsize", Kind::kTexelSize},
    {"cameraposition", Kind::kEyePosition},
    {"worldcameraposition", Kind::kEyePosition},
    {"eyeposition", Kind::kEyePosition},
    {"viewposition", Kind::kEyePosition},
    {"cameradirection", Kind::kViewDirection},
    {"viewdirection", Kind::kViewDirection},
    {"lightposition", Kind::kLightPosition},
    {"lightdirection", Kind::kLightDirection},
    {"lightcolor", Kind::kLightColor},
    {"lightdiffuse", Kind::kLightColor},
};
constexpr NamedValue kNames[] = {
    {"TexelSize", Kind::kTexelSize},
    {"Time", Kind::kTime},
    {"Frame", Kind::kFrame},
    {"FrameSize", Kind::kFrameSize},
};

// Semantics in use whose values this host leaves to the parameter's default: materials, users' devices, scripts.
constexpr std::string_view kDefaultOnly[] = {"standardsglobal",
                                             "sasglobal",
                                             "diffuse",
                                             "ambient",
                                             "specular",
                                             "emissive",
                                             "specularpower",
                                             "power",
                                             "color",
                                             "normal",
                                             "opacity",
                                             "position",
                                             "direction",
                                             "mouseposition",
                                             "leftmousedown",
                                             "rightmousedown",
                                             "middlemousedown",
                                             "fxcomposer_resetpulse",
                                             "controlobject",
                                             "unitsscale",
                                             "rendercolortarget",
                                             "renderdepthstenciltarget",
                                             "offscreenrendertarget",
                                             "environment",
                                             "lightambient",
                                             "lightspecular",
                                             "edgecolor",
                                             "groundshadowcolor",
                                             "texturevalue",
                                             "toon",
                                             "viewportratio",
                                             "worldmatrixarray",
                                             "refraction",
                                             "specularcolor",
                                             "bumpiness",
                                             "surfacecolor"};

std::string ObjectName(const fx::Parameter& parameter) {
  const fx::EffectAnnotation* object = fx::FindAnnotation(parameter.annotations, "Object");
  return object == nullptr || object->value.strings.empty() ? std::string() : LowerCase(object->value.strings.front());
}

// True for the scene's key light: "Light", "PointLight", "SpotLight0" ... but no second one.
bool IsKeyLight(std::string_view object) {
  for (const std::string_view kind : {"point", "spot", "directional", "dir", "distant"}) {
    if (Eat(object, kind)) break;
  }
  if (!Eat(object, "light") && !Eat(object, "lamp")) return false;
  return object.empty() || object == "0" || object == "00" || object == "_0" || object == " 0";
}

std::optional<Kind> KindOfObject(std::string_view semantic, const std::string& object) {
  if (object.find("camera") != std::string::npos || object == "eye") {
    if (semantic == "position") return Kind::kEyePosition;
    if (semantic == "direction") return Kind::kViewDirection;
  }
  if (IsKeyLight(object)) {
    if (semantic == "position") return Kind::kLightPosition;
    if (semantic == "direction") return Kind::kLightDirection;
    if (semantic == "diffuse" || semantic == "specular" || semantic == "color") return Kind::kLightColor;
  }
  return std::nullopt;
}

HostValue::Space SpaceOf(const fx::Parameter& parameter) {
  const fx::EffectAnnotation* space = fx::FindAnnotation(parameter.annotations, "Space");
  if (space == nullptr || space->value.strings.empty()) return HostValue::Space::kWorld;
  const std::string name = LowerCase(space->value.strings.front());
  if (name == "view" || name == "camera" || name == "eye") return HostValue::Space::kView;
  if (name == "object" || name == "model" || name == "local") return HostValue::Space::kObject;
  return HostValue::Space::kWorld;
}

bool IsFloating(const fx::Type& type) {
  return type.scalar == fx::Scalar::kFloat || type.scalar == fx::Scalar::kHalf || type.scalar == fx::Scalar::kDouble;
}

// Whether a parameter of this type can hold the value at all.
bool Fits(Kind kind, const fx::Type& type) {
  if (!type.is_numeric()) return false;
  switch (kind) {
    case Kind::kMatrix:
      return type.is_matrix && type.rows >= 2 && type.columns >= 2;
    case Kind::kTime:
    case Kind::kElapsedTime:
      return type.components() == 1 && IsFloating(type);
    case Kind::kFrame:
      return type.components() == 1 && type.scalar != fx::Scalar::kBool;
    case Kind::kFrameSize:
      return !type.is_matrix && type.components() >= 2;
    case Kind::kTexelSize:
      return !type.is_matrix && type.components() >= 2 && IsFloating(type);
    case Kind::kEyePosition:
    case Kind::kViewDirection:
    case Kind::kLightPosition:
    case Kind::kLightDirection:
    case Kind::kLightColor:
      return !type.is_matrix && type.components() >= 3 && IsFloating(type);
  }
  return false;
}

std::optional<HostValue> FindBySemantic(const fx::Parameter& parameter, std::string_view semantic) {
  if (const auto kind = KindOfObject(semantic, ObjectName(parameter))) return OfKind(*kind);
  for (const NamedValue& named : kSemantics) {
    if (named.name == semantic) return OfKind(named.kind);
  }
  return ParseMatrix(semantic);
}

std::optional<HostValue> FindByName(const fx::Effect& effect, const fx::Parameter& parameter,
                                    std::vector<std::string>& warnings) {
  for (const NamedValue& named : kNames) {
    if (named.name == parameter.name) return OfKind(named.kind);
  }
  constexpr std::string_view kPrefix = "TexelSize_";
  if (!parameter.name.starts_with(kPrefix)) return std::nullopt;
  const std::string_view wanted = std::string_view(parameter.name).substr(kPrefix.size());
  for (std::size_t i = 0; i < effect.textures.size(); ++i) {
    if (effect.textures[i].name != wanted) continue;
    HostValue host = OfKind(Kind::kTexelSize);
    host.texture = i;
    return host;
  }
  warnings.push_back(fmt::format("{}: parameter '{}' stays at its default: there is no texture '{}'", effect.path,
                                 parameter.name, wanted));
  return std::nullopt;
}

glm::mat4 Matrix(const HostValue& host, const FrameContext& context) {
  glm::mat4 matrix(1.0f);
  if (host.world) matrix = context.world_from_object;
  if (host.view) matrix = (host.previous ? context.previous_view_from_world : context.view_from_world) * matrix;
  if (host.projection) matrix = (host.previous ? context.previous_clip_from_view : context.clip_from_view) * matrix;
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

glm::vec4 Vector(const HostValue& host, const FrameContext& context, std::span<const glm::ivec2> texture_sizes) {
  switch (host.kind) {
    case Kind::kTime:
      return glm::vec4(static_cast<float>(context.time_s));
    case Kind::kElapsedTime:
      return glm::vec4(static_cast<float>(context.elapsed_s));
    case Kind::kFrameSize:
      return {context.width, context.height, 0.0f, 0.0f};
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
    case Kind::kLightPosition:
      return InSpace(host, context,
                     {context.light_position_world.value_or(context.light_direction_world * -kFarLight), 1.0f});
    case Kind::kLightDirection:
      return InSpace(host, context, {context.light_direction_world, 0.0f});
    case Kind::kLightColor:
      return context.light_color;
    case Kind::kMatrix:
    case Kind::kFrame:
      break;
  }
  return glm::vec4(0.0f);
}

}  // namespace

std::optional<HostValue> FindHostValue(const fx::Effect& effect, const fx::Parameter& parameter,
                                       std::vector<std::string>& warnings) {
  std::string semantic = LowerCase(parameter.semantic);
  if (semantic.size() > 1 && semantic.ends_with('0')) semantic.pop_back();
  std::optional<HostValue> host;
  if (!semantic.empty()) {
    host = FindBySemantic(parameter, semantic);
    const bool is_known =
        host || semantic.starts_with("material") ||
        std::find(std::begin(kDefaultOnly), std::end(kDefaultOnly), semantic) != std::end(kDefaultOnly);
    if (!is_known) {
      warnings.push_back(fmt::format("{}: parameter '{}' stays at its default: unknown semantic '{}'", effect.path,
                                     parameter.name, parameter.semantic));
    }
    if (host && !Fits(host->kind, parameter.type)) {
      warnings.push_back(fmt::format("{}: parameter '{}' stays at its default: a {} cannot hold '{}'", effect.path,
                                     parameter.name, fx::ToString(parameter.type), parameter.semantic));
      return std::nullopt;
    }
  }
  if (!host) {
    host = FindByName(effect, parameter, warnings);
    if (host && !Fits(host->kind, parameter.type)) return std::nullopt;
  }
  if (host && host->kind != Kind::kMatrix) host->space = SpaceOf(parameter);
  return host;
}

void Evaluate(const HostValue& host, const FrameContext& context, std::span<const glm::ivec2> texture_sizes,
              const fx::Type& type, bool column_vectors, std::vector<double>& numbers) {
  if (host.kind == Kind::kMatrix) {
    const glm::mat4 matrix = Matrix(host, context);
    for (int row = 0; row < type.rows; ++row) {
      for (int column = 0; column < type.columns; ++column) {
        const std::size_t index = static_cast<std::size_t>(row * type.columns + column);
        numbers[index] = column_vectors ? matrix[column][row] : matrix[row][column];
      }
    }
    return;
  }
  if (host.kind == Kind::kFrame) {
    numbers[0] = static_cast<double>(context.frame);
    return;
  }
  const glm::vec4 vector = Vector(host, context, texture_sizes);
  for (std::size_t i = 0; i < numbers.size() && i < 4; ++i) numbers[i] = vector[static_cast<int>(i)];
}

}  // namespace burin::effect

// SPDX-License-Identifier: Apache-2.0
// Values by semantic, as the samples of the DirectX SDK, DXSAS 1.0, NVIDIA's SAS 0.8 and MikuMikuEffect name them.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/effect/control_object.h"
#include "core/effect/host_value.h"
#include "core/effect/light_view.h"
#include "core/effect/text.h"
#include "fx_parser/effect/parameter_meaning.h"
#include "fx_parser/effect/sas_address.h"
#include "fx_parser/semantics/conversion.h"

namespace burin::effect {
namespace {

using Kind = HostValue::Kind;

HostValue OfKind(Kind kind) {
  HostValue host;
  host.kind = kind;
  return host;
}

HostValue Constant(std::array<double, 4> value) {
  HostValue host = OfKind(Kind::kConstant);
  host.constant = value;
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
  if (text == "worldmatrixarray") text = "world";  // the vertices come skinned already
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
    {"lasttime", Kind::kLastTime},
    {"elapsedtime", Kind::kElapsedTime},
    {"frame", Kind::kFrame},
    {"framesize", Kind::kFrameSize},
    {"viewportpixelsize", Kind::kFrameSize},
    {"viewportsize", Kind::kFrameSize},
    {"texelsize", Kind::kTexelSize},
    {"halfpixelsize", Kind::kHalfPixelSize},
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
    {"lightspecular", Kind::kLightColor},
    {"lightambient", Kind::kLightAmbient},
    {"materialdiffuse", Kind::kMaterialDiffuse},
    {"materialambient", Kind::kMaterialAmbient},
    {"materialspecular", Kind::kMaterialSpecular},
    {"materialemissive", Kind::kMaterialEmissive},
    {"materialpower", Kind::kMaterialPower},
    {"materialspecularpower", Kind::kMaterialPower},
};
constexpr NamedValue kNames[] = {
    {"TexelSize", Kind::kTexelSize},
    {"Time", Kind::kTime},
    {"Frame", Kind::kFrame},
    {"FrameSize", Kind::kFrameSize},
};

struct NamedConstant {
  std::string_view name;
  std::array<double, 4> value;
};
// What hosts have and this one has one value of: for parameters without an initial value.
constexpr NamedConstant kConstants[] = {
    {"unitsscale", {1, 1, 1, 1}},
    {"opacity", {1, 1, 1, 1}},
    {"tooncolor", {1, 1, 1, 1}},
    {"edgecolor", {0, 0, 0, 1}},
    {"edgewidth", {1, 1, 1, 1}},
    {"groundshadowcolor", {0, 0, 0, 0.4}},
    {"texturevalue", {1, 1, 1, 1}},
    {"addingtexture", {0, 0, 0, 0}},
    {"multiplyingtexture", {1, 1, 1, 1}},
    {"addingspheretexture", {0, 0, 0, 0}},
    {"multiplyingspheretexture", {1, 1, 1, 1}},
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
                                             "position",
                                             "direction",
                                             "mouseposition",
                                             "leftmousedown",
                                             "rightmousedown",
                                             "middlemousedown",
                                             "fxcomposer_resetpulse",
                                             "controlobject",
                                             "rendercolortarget",
                                             "renderdepthstenciltarget",
                                             "offscreenrendertarget",
                                             "environment",
                                             "toon",
                                             "viewportratio",
                                             "refraction",
                                             "specularcolor",
                                             "bumpiness",
                                             "surfacecolor",
                                             "angle",
                                             "constantattenuation",
                                             "linearattenuation",
                                             "quadraticattenuation",
                                             "falloffangle",
                                             "falloffexponent"};

std::optional<Kind> KindOfLight(std::string_view semantic) {
  if (semantic == "position") return Kind::kLightPosition;
  if (semantic == "direction") return Kind::kLightDirection;
  if (semantic == "diffuse" || semantic == "specular" || semantic == "color") return Kind::kLightColor;
  if (semantic == "ambient") return Kind::kLightAmbient;
  if (semantic == "range") return Kind::kLightRange;
  if (semantic == "numlights") return Kind::kLightCount;
  return std::nullopt;
}

std::optional<Kind> KindOfMaterial(std::string_view semantic) {
  if (semantic == "diffuse") return Kind::kMaterialDiffuse;
  if (semantic == "ambient") return Kind::kMaterialAmbient;
  if (semantic == "specular") return Kind::kMaterialSpecular;
  if (semantic == "emissive") return Kind::kMaterialEmissive;
  if (semantic == "specularpower") return Kind::kMaterialPower;
  if (semantic == "opacity") return Kind::kMaterialOpacity;
  if (semantic == "usetexture") return Kind::kMaterialHasTexture;
  return std::nullopt;
}

std::optional<HostValue> OfObject(std::string_view semantic, const std::string& object) {
  if (object.find("camera") != std::string::npos || object == "eye") {
    if (semantic == "position") return OfKind(Kind::kEyePosition);
    if (semantic == "direction") return OfKind(Kind::kViewDirection);
  }
  if (object == "geometry" || object == "material") {
    if (const auto kind = KindOfMaterial(semantic)) return OfKind(*kind);
  }
  const auto light = LightOf(object);
  const auto kind = light ? KindOfLight(semantic) : std::nullopt;
  if (!kind) return std::nullopt;
  // All lights are counted as directional ones.
  if (*kind == Kind::kLightCount && (object.starts_with("point") || object.starts_with("spot"))) return Constant({});
  HostValue host = OfKind(*kind);
  host.light = *light;
  return host;
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
  if (type.kind != fx::TypeKind::kNumeric) return false;
  switch (kind) {
    case Kind::kMatrix:
      return type.is_matrix && type.rows >= 2 && type.columns >= 2;
    case Kind::kTime:
    case Kind::kLastTime:
    case Kind::kElapsedTime:
      return type.components() == 1 && IsFloating(type);
    case Kind::kFrame:
    case Kind::kLightCount:
    case Kind::kMaterialHasTexture:
      return type.components() == 1;
    case Kind::kFrameSize:
      return !type.is_matrix && type.components() >= 2;
    case Kind::kTexelSize:
    case Kind::kHalfPixelSize:
      return !type.is_matrix && type.components() >= 2 && IsFloating(type);
    case Kind::kMaterialPower:
    case Kind::kMaterialOpacity:
    case Kind::kLightRange:
      return type.components() == 1 && IsFloating(type);
    case Kind::kConstant:
      return !type.is_matrix;
    case Kind::kEyePosition:
    case Kind::kViewDirection:
    case Kind::kLightPosition:
    case Kind::kLightDirection:
    case Kind::kLightColor:
    case Kind::kLightAmbient:
    case Kind::kMaterialDiffuse:
    case Kind::kMaterialAmbient:
    case Kind::kMaterialSpecular:
    case Kind::kMaterialEmissive:
      return !type.is_matrix && type.components() >= 3 && IsFloating(type);
  }
  return false;
}

std::optional<HostValue> FindByMeaning(const fx::Parameter& parameter, const fx::ParameterMeaning& meaning,
                                       std::string_view semantic) {
  if (const auto host = OfObject(semantic, meaning.object)) return host;
  for (const NamedValue& named : kSemantics) {
    if (named.name == semantic) return OfKind(named.kind);
  }
  if (!parameter.has_default) {
    for (const NamedConstant& named : kConstants) {
      if (named.name == semantic) return Constant(named.value);
    }
  }
  auto matrix = ParseMatrix(semantic);
  // "WVP", "WorldMatrix": a semantic that is another's name.
  if (!matrix) matrix = ParseMatrix(fx::MatrixOfName(semantic));
  if (!matrix || (!matrix->view && !matrix->projection)) return matrix;
  const fx::EffectAnnotation* frustum = fx::FindAnnotation(parameter.annotations, "frustum");
  const std::string viewer = frustum != nullptr && !frustum->value.strings.empty()
                                 ? LowerCase(frustum->value.strings.front())
                                 : meaning.object;
  if (const auto light = LightOf(viewer)) {
    matrix->is_seen_from_light = true;
    matrix->light = *light;
  }
  return matrix;
}

bool IsKnown(std::string_view semantic) {
  return semantic.starts_with("material") ||
         std::find(std::begin(kDefaultOnly), std::end(kDefaultOnly), semantic) != std::end(kDefaultOnly) ||
         std::any_of(std::begin(kConstants), std::end(kConstants),
                     [&](const NamedConstant& named) { return named.name == semantic; });
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

// What only a scene gives; a picture's is made up.
bool IsOfScene(const HostValue& host) {
  return host.is_of_material() || (host.kind >= Kind::kEyePosition && host.kind <= Kind::kLightCount);
}

// Whether a picture, which faces +z, is lit by it: a light that stands or shines behind it leaves all dark.
bool LightsPictures(const HostValue& host, const fx::Value& value) {
  if (value.numbers.size() < 3) return true;
  if (host.kind == Kind::kLightDirection) return value.numbers[2] <= 0.0;
  return host.kind != Kind::kLightPosition || value.numbers[2] >= 0.0;
}

}  // namespace

std::optional<HostValue> FindHostValue(const fx::Effect& effect, const fx::Parameter& parameter,
                                       std::vector<std::string>& warnings) {
  const fx::ParameterMeaning meaning = fx::MeaningOf(parameter, !effect.uses_extension);
  const auto stays = [&](const std::string& why) {
    warnings.push_back(fmt::format("{}: parameter '{}' stays at its default: {}", effect.path, parameter.name, why));
  };
  std::string semantic = meaning.semantic;
  if (semantic.size() > 1 && semantic.ends_with('0')) semantic.pop_back();
  std::optional<HostValue> host;
  if (!meaning.is_known_address && FindHostParts(parameter).empty())
    stays("its SasBindAddress names nothing that is here");
  if (meaning.is_implied) host = FindByName(effect, parameter, warnings);
  if (semantic == "controlobject") {
    const auto value = ControlObjectValue(effect, parameter, warnings);
    return value && Fits(Kind::kConstant, parameter.type) ? std::optional(Constant(*value)) : std::nullopt;
  }
  if (!host && !semantic.empty()) {
    host = FindByMeaning(parameter, meaning, semantic);
    if (!host && !IsKnown(semantic) && !meaning.is_implied)
      stays(fmt::format("unknown semantic '{}'", parameter.semantic.empty() ? semantic : parameter.semantic));
    if (host && !Fits(host->kind, parameter.type)) {
      if (!meaning.is_implied)
        stays(fmt::format("a {} cannot hold '{}'", fx::ToString(parameter.type),
                          parameter.semantic.empty() ? semantic : parameter.semantic));
      return std::nullopt;
    }
  }
  if (!host) {
    host = FindByName(effect, parameter, warnings);
  }
  if (host && !Fits(host->kind, parameter.type)) return std::nullopt;
  if (host && host->kind != Kind::kMatrix) host->space = SpaceOf(parameter);
  if (host) {
    host->yields_to_default =
        parameter.has_default && IsOfScene(*host) && LightsPictures(*host, parameter.default_value);
    host->points_to_light = host->kind == Kind::kLightDirection && meaning.is_implied && !parameter.is_negated;
  }
  return host;
}

std::vector<HostPart> FindHostParts(const fx::Parameter& parameter) {
  const fx::EffectAnnotation* bound = fx::FindAnnotation(parameter.annotations, "SasBindAddress");
  const fx::Type& type = parameter.type;
  if (bound == nullptr || bound->value.strings.empty() || type.kind != fx::TypeKind::kStruct ||
      type.structure == nullptr || type.array.size() > 1) {
    return {};
  }
  std::vector<HostPart> parts;
  std::size_t offset = 0;
  const std::size_t count = type.is_array() ? type.array.front() : 1;
  for (std::size_t element = 0; element < count; ++element) {
    std::string address = bound->value.strings.front();
    if (const std::size_t star = address.find('*'); star != std::string::npos)
      address.replace(star, 1, std::to_string(element));
    for (const auto& member : type.structure->members) {
      const auto meaning = fx::MeaningOfSasAddress(address + "." + member->name);
      const auto host = meaning ? FindByMeaning(parameter, *meaning, meaning->semantic) : std::nullopt;
      if (host && Fits(host->kind, member->type)) parts.push_back({offset, member->type, *host});
      offset += static_cast<std::size_t>(std::max(fx::FlatComponents(member->type), 0L));  // below 0: no numbers
    }
  }
  return parts;
}

}  // namespace burin::effect

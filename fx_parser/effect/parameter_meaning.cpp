// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/effect/parameter_meaning.h"

#include <algorithm>
#include <array>
#include <optional>

#include "fx_parser/effect/case.h"
#include "fx_parser/effect/sas_address.h"

namespace burin::fx {
namespace {

bool Eat(std::string_view& text, std::string_view word) {
  if (!text.starts_with(word)) return false;
  text.remove_prefix(word.size());
  return true;
}

template <class Words>
bool EatOneOf(std::string_view& text, const Words& words) {
  return std::any_of(std::begin(words), std::end(words), [&](std::string_view word) { return Eat(text, word); });
}

/// Letters and digits alone, in lower case.
std::string Letters(std::string_view name) {
  std::string letters;
  for (const char c : name) {
    if (c != '_' && c != ':' && c != '.') letters += LowerCase(c);
  }
  return letters;
}

// What names have in front of what they mean: scopes and kinds in Hungarian notation. The longest first.
constexpr std::array<std::string_view, 22> kPrefixes = {
    "gmatrix", "gmat", "gmtx", "matrix", "gvec", "param", "mat", "mtx", "vec", "glob", "gm",
    "gv",      "gf",   "gc",   "gn",     "g",    "m",     "f",   "v",   "c",   "u",    ""};
constexpr std::array<std::string_view, 9> kSuffixes = {"transform", "matrix", "xform", "vector", "param",
                                                       "mtx",       "mat",    "xf",    ""};

struct Synonym {
  std::string_view name;
  std::string_view semantic;
};
// Products written short, and transforms named from space to space.
constexpr Synonym kMatrices[] = {{"wvp", "worldviewprojection"},
                                 {"mvp", "worldviewprojection"},
                                 {"wv", "worldview"},
                                 {"mv", "worldview"},
                                 {"vp", "viewprojection"},
                                 {"wit", "worldinversetranspose"},
                                 {"wvit", "worldviewinversetranspose"},
                                 {"objecttoworld", "world"},
                                 {"localtoworld", "world"},
                                 {"modeltoworld", "world"},
                                 {"worldtoobject", "worldinverse"},
                                 {"worldtolocal", "worldinverse"},
                                 {"worldtoview", "view"},
                                 {"worldtocamera", "view"},
                                 {"viewtoworld", "viewinverse"},
                                 {"cameratoworld", "viewinverse"},
                                 {"viewtoclip", "projection"},
                                 {"viewtoproj", "projection"},
                                 {"viewtoprojection", "projection"},
                                 {"worldtoclip", "viewprojection"},
                                 {"worldtoproj", "viewprojection"},
                                 {"objecttoclip", "worldviewprojection"},
                                 {"objecttoproj", "worldviewprojection"},
                                 {"objecttoview", "worldview"},
                                 {"modelviewproj", "worldviewprojection"},
                                 {"modelviewprojection", "worldviewprojection"},
                                 {"modelview", "worldview"},
                                 {"normalmatrix", "worldinversetranspose"}};

/// "worldviewproj", "worldinvtrans" and their like.
std::string ProductOf(std::string_view text) {
  std::string semantic;
  if (Eat(text, "world")) semantic += "world";
  if (Eat(text, "view")) semantic += "view";
  constexpr std::array<std::string_view, 3> kProjections = {"projection", "project", "proj"};
  if (EatOneOf(text, kProjections)) semantic += "projection";
  if (semantic.empty()) return {};
  if (text == "it") return semantic + "inversetranspose";
  constexpr std::array<std::string_view, 3> kInverses = {"inverse", "invert", "inv"};
  if (EatOneOf(text, kInverses) || text == "i") {
    semantic += "inverse";
    if (text == "i") text = {};
  }
  constexpr std::array<std::string_view, 4> kTransposes = {"transposed", "transpose", "trans", "t"};
  if (EatOneOf(text, kTransposes)) semantic += "transpose";
  return text.empty() ? semantic : std::string();
}

std::string MatrixOfCore(std::string_view core) {
  for (const Synonym& synonym : kMatrices) {
    if (synonym.name == core) return std::string(synonym.semantic);
  }
  if (std::string product = ProductOf(core); !product.empty()) return product;
  // "InverseWorld", "invViewProj".
  std::string_view rest = core;
  constexpr std::array<std::string_view, 2> kInverses = {"inverse", "inv"};
  if (!EatOneOf(rest, kInverses)) return {};
  const bool is_transposed = Eat(rest, "transpose") || Eat(rest, "trans");
  const std::string product = ProductOf(rest);
  if (product.empty() || product.find("inverse") != std::string::npos) return {};
  return product + "inverse" + (is_transposed ? "transpose" : "");
}

/// Calls `find` with every reading of the name without what stands around it, until one means something.
template <class Find>
auto FindCore(std::string_view name, const Find& find) -> decltype(find(name)) {
  const std::string letters = Letters(name);
  for (const std::string_view prefix : kPrefixes) {
    if (!letters.starts_with(prefix)) continue;
    for (const std::string_view suffix : kSuffixes) {
      std::string_view core = std::string_view(letters).substr(prefix.size());
      if (!core.ends_with(suffix)) continue;
      core.remove_suffix(suffix.size());
      if (core.empty()) continue;
      if (auto found = find(core); found != decltype(find(core)){}) return found;
    }
  }
  return {};
}

struct Named {
  std::string_view name;
  std::string_view semantic;
  std::string_view object;
};
constexpr Named kValues[] = {{"eye", "position", "camera"},
                             {"eyepos", "position", "camera"},
                             {"eyeposition", "position", "camera"},
                             {"eyept", "position", "camera"},
                             {"eyepoint", "position", "camera"},
                             {"eyeposworld", "position", "camera"},
                             {"worldeye", "position", "camera"},
                             {"worldeyepos", "position", "camera"},
                             {"viewpos", "position", "camera"},
                             {"viewposition", "position", "camera"},
                             {"viewerpos", "position", "camera"},
                             {"campos", "position", "camera"},
                             {"cameraeye", "position", "camera"},
                             {"camerapos", "position", "camera"},
                             {"cameraposition", "position", "camera"},
                             {"worldcamerapos", "position", "camera"},
                             {"cameradir", "direction", "camera"},
                             {"cameradirection", "direction", "camera"},
                             {"eyedir", "direction", "camera"},
                             {"viewdir", "direction", "camera"},
                             {"lightpos", "position", "light"},
                             {"lightposition", "position", "light"},
                             {"lightposworld", "position", "light"},
                             {"worldlightpos", "position", "light"},
                             {"pointlightpos", "position", "light"},
                             {"pointlightposition", "position", "light"},
                             {"lightdir", "direction", "light"},
                             {"lightdirection", "direction", "light"},
                             {"lhtdir", "direction", "light"},
                             {"lightdirworld", "direction", "light"},
                             {"worldlightdir", "direction", "light"},
                             {"worldlightdirection", "direction", "light"},
                             {"dirlightdir", "direction", "light"},
                             {"dirlightdirection", "direction", "light"},
                             {"dirlight0direction", "direction", "light"},
                             {"directionallightdirection", "direction", "light"},
                             {"sundir", "direction", "light"},
                             {"sundirection", "direction", "light"},
                             {"lightcolor", "diffuse", "light"},
                             {"lightcolour", "diffuse", "light"},
                             {"lightdiffuse", "diffuse", "light"},
                             {"lightdiffusecolor", "diffuse", "light"},
                             {"diffuselight", "diffuse", "light"},
                             {"diffuselightcolor", "diffuse", "light"},
                             {"dirlightcolor", "diffuse", "light"},
                             {"dirlightdiffusecolor", "diffuse", "light"},
                             {"dirlight0diffusecolor", "diffuse", "light"},
                             {"directionallightcolor", "diffuse", "light"},
                             {"suncolor", "diffuse", "light"},
                             {"sundiffuse", "diffuse", "light"},
                             {"lightspecular", "specular", "light"},
                             {"lightspecularcolor", "specular", "light"},
                             {"lightambient", "ambient", "light"},
                             {"ambientlight", "ambient", "light"},
                             {"ambientlightcolor", "ambient", "light"},
                             {"lightambientcolor", "ambient", "light"},
                             {"globalambient", "ambient", "light"},
                             {"ambient", "ambient", "light"},
                             {"ambientcolor", "ambient", "light"},
                             {"numlights", "numlights", "light"},
                             {"lightcount", "numlights", "light"},
                             {"materialdiffuse", "diffuse", "geometry"},
                             {"materialdiffusecolor", "diffuse", "geometry"},
                             {"matdiffuse", "diffuse", "geometry"},
                             {"materialcolor", "diffuse", "geometry"},
                             {"diffuse", "diffuse", "geometry"},
                             {"diffusecolor", "diffuse", "geometry"},
                             {"diffusematerial", "diffuse", "geometry"},
                             {"basecolor", "diffuse", "geometry"},
                             {"surfacecolor", "diffuse", "geometry"},
                             {"objectcolor", "diffuse", "geometry"},
                             {"materialambient", "ambient", "geometry"},
                             {"materialambientcolor", "ambient", "geometry"},
                             {"matambient", "ambient", "geometry"},
                             {"ambientmaterial", "ambient", "geometry"},
                             {"materialspecular", "specular", "geometry"},
                             {"materialspecularcolor", "specular", "geometry"},
                             {"matspecular", "specular", "geometry"},
                             {"specular", "specular", "geometry"},
                             {"specularcolor", "specular", "geometry"},
                             {"specularmaterial", "specular", "geometry"},
                             {"materialemissive", "emissive", "geometry"},
                             {"materialemissivecolor", "emissive", "geometry"},
                             {"emissive", "emissive", "geometry"},
                             {"emissivecolor", "emissive", "geometry"},
                             {"materialpower", "specularpower", "geometry"},
                             {"materialspecularpower", "specularpower", "geometry"},
                             {"materialshininess", "specularpower", "geometry"},
                             {"specularpower", "specularpower", "geometry"},
                             {"specpower", "specularpower", "geometry"},
                             {"specularexponent", "specularpower", "geometry"},
                             {"shininess", "specularpower", "geometry"},
                             {"opacity", "opacity", "geometry"},
                             {"usetexture", "usetexture", "geometry"},
                             {"alpha", "opacity", "geometry"},
                             {"time", "time", ""},
                             {"apptime", "time", ""},
                             {"currenttime", "time", ""},
                             {"totaltime", "time", ""},
                             {"elapsedtime", "elapsedtime", ""},
                             {"timedelta", "elapsedtime", ""},
                             {"deltatime", "elapsedtime", ""},
                             {"viewportsize", "viewportpixelsize", ""},
                             {"viewport", "viewportpixelsize", ""},
                             {"screensize", "viewportpixelsize", ""},
                             {"resolution", "viewportpixelsize", ""},
                             {"rendertargetsize", "viewportpixelsize", ""},
                             {"backbuffersize", "viewportpixelsize", ""},
                             {"windowsize", "viewportpixelsize", ""},
                             {"texelsize", "texelsize", ""},
                             {"texturesize", "viewportpixelsize", ""},
                             {"pixelsize", "texelsize", ""},
                             {"invscreensize", "texelsize", ""},
                             {"inverseviewportdimensions", "texelsize", ""},
                             {"halfpixel", "halfpixelsize", ""},
                             {"halfpixelsize", "halfpixelsize", ""}};

/// The name, or the name with a light's number behind or among it: "Light0Direction", "LightPos1".
std::optional<ParameterMeaning> ValueOfCore(std::string_view core) {
  std::string text(core);
  std::string number;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] >= '0' && text[i] <= '9') {
      number += text[i];
      text.erase(i, 1);
    } else {
      ++i;
    }
  }
  for (const Named& named : kValues) {
    const bool is_exact = named.name == core;
    if (!is_exact && (named.name != text || (named.object != "light" && !number.empty() && number != "0"))) continue;
    ParameterMeaning meaning{.semantic = std::string(named.semantic),
                             .object = std::string(named.object),
                             .is_implied = true,
                             .is_known_address = true};
    if (!is_exact && named.object == "light") meaning.object += number;
    return meaning;
  }
  return std::nullopt;
}

const std::string* TextOf(const Parameter& parameter, std::string_view annotation) {
  const EffectAnnotation* found = FindAnnotation(parameter.annotations, annotation);
  return found == nullptr || found->value.strings.empty() ? nullptr : &found->value.strings[0];
}

/// `int gLighting < string renderState = "LIGHTING"; >`, `float4 gMaterialDiffuse < string materialState = "Diffuse";
/// >`, `float3 gLight1Direction < string lightState = "1,Direction"; >`.
std::optional<ParameterMeaning> MeaningOfState(const Parameter& parameter) {
  ParameterMeaning meaning;
  if (const std::string* state = TextOf(parameter, "materialState")) {
    meaning.semantic = LowerCase(*state) == "power" ? "specularpower" : LowerCase(*state);
    meaning.object = "geometry";
    return meaning;
  }
  if (const std::string* state = TextOf(parameter, "lightState")) {
    const std::size_t comma = state->find(',');
    if (comma == std::string::npos) return std::nullopt;
    meaning.semantic = LowerCase(std::string_view(*state).substr(comma + 1));
    meaning.object = "light" + state->substr(0, comma);
    return meaning;
  }
  return std::nullopt;
}

/// "g_mLightViewProj": what a light sees; empty for anything else.
std::string LightMatrixOfName(std::string_view name) {
  std::string letters = Letters(name);
  const std::size_t at = letters.find("light");
  if (at == std::string::npos) return {};
  letters.erase(at, 5);
  std::string semantic = MatrixOfName(letters);
  const bool is_view = semantic.find("view") != std::string::npos || semantic.find("proj") != std::string::npos;
  return is_view ? semantic : std::string();
}

bool HasOwnMeaning(const Parameter& parameter) {
  // What a user is to set by a widget is no host's.
  return parameter.has_default || FindAnnotation(parameter.annotations, "UIWidget") != nullptr;
}

}  // namespace

std::string MatrixOfName(std::string_view name) {
  return FindCore(name, [](std::string_view core) { return MatrixOfCore(core); });
}

bool IsProjection(std::string_view semantic) {
  const std::string lower = LowerCase(semantic);
  return lower.find("proj") != std::string::npos && lower.find("inv") == std::string::npos;
}

ParameterMeaning MeaningOf(const Parameter& parameter, bool uses_names) {
  if (const std::string* address = TextOf(parameter, "SasBindAddress")) {
    if (auto meaning = MeaningOfSasAddress(*address)) return *std::move(meaning);
    if (parameter.semantic.empty())
      return {.semantic = {}, .object = {}, .is_implied = false, .is_known_address = false};
  }
  if (!parameter.semantic.empty()) {
    ParameterMeaning meaning;
    meaning.semantic = LowerCase(parameter.semantic);
    if (const std::string* object = TextOf(parameter, "Object")) meaning.object = LowerCase(*object);
    return meaning;
  }
  if (auto meaning = MeaningOfState(parameter)) return *std::move(meaning);
  if (!uses_names || parameter.type.kind != TypeKind::kNumeric) return {};
  if (parameter.type.is_matrix) {
    ParameterMeaning meaning;
    if (parameter.has_default) return meaning;
    meaning.semantic = MatrixOfName(parameter.name);
    if (meaning.semantic.empty()) {
      meaning.semantic = LightMatrixOfName(parameter.name);
      if (!meaning.semantic.empty()) meaning.object = "light";
    }
    meaning.is_implied = !meaning.semantic.empty();
    return meaning;
  }
  if (HasOwnMeaning(parameter)) return {};
  return FindCore(parameter.name, [](std::string_view core) { return ValueOfCore(core); }).value_or(ParameterMeaning{});
}

}  // namespace burin::fx

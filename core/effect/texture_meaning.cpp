// SPDX-License-Identifier: Apache-2.0
#include "core/effect/texture_meaning.h"

#include <algorithm>
#include <string>

#include "core/effect/text.h"

namespace burin::effect {
namespace {

using enum TextureMeaning;

struct Word {
  std::string_view word;
  TextureMeaning meaning;
};

constexpr Word kSemantics[] = {{"diffuse", kBaseColor},
                               {"diffusemap", kBaseColor},
                               {"texture", kBaseColor},
                               {"materialtexture", kBaseColor},
                               {"color", kBaseColor},
                               {"normal", kNormal},
                               {"normalmap", kNormal},
                               {"bump", kNormal},
                               {"bumpmap", kNormal},
                               {"specular", kSpecular},
                               {"specularmap", kSpecular},
                               {"gloss", kSpecular},
                               {"emissive", kEmissive},
                               {"emissivemap", kEmissive},
                               {"ambientocclusion", kOcclusion},
                               {"materialspheremap", kWhite},
                               {"materialtoontexture", kWhite},
                               {"environment", kEnvironment}};

// Parts of names, in the order in which they are looked for.
constexpr Word kParts[] = {
    {"noise", kNoise},        {"random", kNoise},       {"jitter", kNoise},        {"perlin", kNoise},
    {"cloud", kNoise},        {"dither", kNoise},       {"normal", kNormal},       {"bump", kNormal},
    {"nrm", kNormal},         {"ramp", kRamp},          {"gradient", kRamp},       {"falloff", kRamp},
    {"fresnel", kRamp},       {"attenuation", kRamp},   {"curve", kRamp},          {"lookup", kRamp},
    {"spectrum", kRamp},      {"toon", kRamp},          {"celshade", kRamp},       {"lightmap", kWhite},
    {"shadow", kWhite},       {"mask", kWhite},         {"vignette", kWhite},      {"paper", kWhite},
    {"grain", kWhite},        {"hatch", kWhite},        {"gloss", kSpecular},      {"spec", kSpecular},
    {"emissive", kEmissive},  {"selfillum", kEmissive}, {"occlusion", kOcclusion}, {"environment", kEnvironment},
    {"envmap", kEnvironment}, {"envtex", kEnvironment}, {"cubemap", kEnvironment}, {"reflect", kEnvironment},
    {"skybox", kEnvironment}};

constexpr std::string_view kDefaultFiles[] = {"default_color.dds", "default_reflection.dds", "default_bump_normal.dds",
                                              "default_gloss.dds"};

std::string FileName(std::string_view file) {
  const std::size_t folder = file.find_last_of("/\\");
  return LowerCase(folder == std::string_view::npos ? file : file.substr(folder + 1));
}

std::optional<TextureMeaning> ByParts(const std::string& name) {
  for (const Word& part : kParts) {
    if (name.find(part.word) != std::string::npos) return part.meaning;
  }
  return std::nullopt;
}

// Cubes show what is around, volumes and rows of texels are tables.
TextureMeaning InDimension(TextureMeaning meaning, fx::Dimension dimension) {
  switch (dimension) {
    case fx::Dimension::kCube:
      return kEnvironment;
    case fx::Dimension::k3D:
      return kNoise;
    case fx::Dimension::k1D:
      return meaning == kNoise ? kNoise : kRamp;
    case fx::Dimension::k2D:
    case fx::Dimension::kUnknown:
      break;
  }
  return meaning == kEnvironment ? kWhite : meaning;
}

TextureMeaning InTwoDimensions(const fx::Texture& texture) {
  for (const Word& semantic : kSemantics) {
    if (EqualsIgnoringCase(semantic.word, texture.semantic)) return semantic.meaning;
  }
  const auto* role = std::get_if<fx::FileRole>(&texture.role);
  if (role != nullptr && !role->file.empty()) {
    if (const auto meaning = ByParts(FileName(role->file))) return *meaning;
  }
  return ByParts(LowerCase(texture.name)).value_or(kBaseColor);
}

}  // namespace

TextureMeaning MeaningOf(const fx::Texture& texture) {
  return InDimension(InTwoDimensions(texture), texture.dimension);
}

TextureMeaning MeaningOf(const fx::Sampler& sampler) {
  return InDimension(ByParts(LowerCase(sampler.name)).value_or(kBaseColor), sampler.dimension);
}

bool IsDefaultFile(std::string_view file) {
  const std::string name = FileName(file);
  return std::find(std::begin(kDefaultFiles), std::end(kDefaultFiles), name) != std::end(kDefaultFiles);
}

}  // namespace burin::effect

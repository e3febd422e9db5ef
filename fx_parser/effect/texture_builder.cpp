// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "fx_parser/effect/builder.h"
#include "fx_parser/effect/case.h"
#include "fx_parser/effect/naming.h"

namespace burin::fx {
namespace {

/// Width and height that Dimensions may ask for, as of Direct3D's largest devices.
constexpr int kMaxScriptTarget = 16384;

const std::string* StringAnnotation(const std::vector<EffectAnnotation>& annotations, std::string_view name) {
  const EffectAnnotation* annotation = FindAnnotation(annotations, name);
  if (annotation == nullptr || annotation->value.strings.empty() || annotation->value.strings[0].empty())
    return nullptr;
  return &annotation->value.strings[0];
}

std::string FileOf(const std::vector<EffectAnnotation>& annotations) {
  for (const std::string_view name : {"ResourceName", "name", "source", "texture", "file"}) {
    if (const std::string* file = StringAnnotation(annotations, name)) return *file;
  }
  return {};
}

Dimension AnnotatedDimension(const std::vector<EffectAnnotation>& annotations) {
  for (const std::string_view name : {"ResourceType", "TextureType", "type"}) {
    const std::string* text = StringAnnotation(annotations, name);
    if (text == nullptr) continue;
    if (EqualsIgnoringCase(*text, "cube")) return Dimension::kCube;
    if (EqualsIgnoringCase(*text, "3D") || EqualsIgnoringCase(*text, "volume")) return Dimension::k3D;
    if (EqualsIgnoringCase(*text, "1D")) return Dimension::k1D;
    if (EqualsIgnoringCase(*text, "2D")) return Dimension::k2D;
  }
  return Dimension::kUnknown;
}

bool IsScriptTarget(std::string_view semantic) {
  return EqualsIgnoringCase(semantic, "RenderColorTarget") ||
         EqualsIgnoringCase(semantic, "RenderDepthStencilTarget") ||
         EqualsIgnoringCase(semantic, "OffscreenRenderTarget");
}

/// The formats of targets, and the names of others that hold the same.
std::optional<Format> FindScriptFormat(std::string_view name) {
  constexpr std::string_view kPrefix = "D3DFMT_";
  if (name.size() > kPrefix.size() && EqualsIgnoringCase(name.substr(0, kPrefix.size()), kPrefix))
    name.remove_prefix(kPrefix.size());
  if (EqualsIgnoringCase(name, "A4R4G4B4") || EqualsIgnoringCase(name, "A1R5G5B5")) return Format::kA8R8G8B8;
  if (EqualsIgnoringCase(name, "X1R5G5B5")) return Format::kX8R8G8B8;
  if (EqualsIgnoringCase(name, "A8B8G8R8")) return Format::kA8R8G8B8;
  if (EqualsIgnoringCase(name, "X8B8G8R8") || EqualsIgnoringCase(name, "R8G8B8")) return Format::kX8R8G8B8;
  if (EqualsIgnoringCase(name, "A2R10G10B10")) return Format::kA2B10G10R10;
  return FindFormat(name);
}

/// Component `i` of a numeric annotation.
std::optional<double> NumberAnnotation(const std::vector<EffectAnnotation>& annotations, std::string_view name,
                                       std::size_t i = 0) {
  const EffectAnnotation* annotation = FindAnnotation(annotations, name);
  if (annotation == nullptr || i >= annotation->value.numbers.size()) return std::nullopt;
  return annotation->value.numbers[i];
}

/// ViewportRatio, or Dimensions, or Width and Height; without any of them the frame's size.
ScriptTargetRole ScriptTarget(const Texture& texture) {
  ScriptTargetRole role;
  role.is_depth_stencil = EqualsIgnoringCase(texture.semantic, "RenderDepthStencilTarget");
  role.is_offscreen = EqualsIgnoringCase(texture.semantic, "OffscreenRenderTarget");
  const auto pixels = [&](std::string_view own, std::size_t component) {
    const auto length = NumberAnnotation(texture.annotations, own).or_else([&] {
      return NumberAnnotation(texture.annotations, "Dimensions", component);
    });
    return length && *length >= 1 ? static_cast<int>(std::min(*length, double{kMaxScriptTarget})) : 0;
  };
  const auto ratio = [&](std::size_t component) {
    const auto value = NumberAnnotation(texture.annotations, "ViewportRatio", component);
    return value && *value > 0 ? std::min(*value, kMaxScale) : 1.0;
  };
  role.width = pixels("Width", 0);
  role.height = pixels("Height", 1);
  if (role.width == 0 || role.height == 0) role.width = role.height = 0;
  role.width_ratio = ratio(0);
  role.height_ratio = ratio(1);
  return role;
}

bool IsCustomTechnique(const ast::Technique& technique) {
  return technique.name.starts_with("GBA") && technique.name.size() > 3;
}

}  // namespace

void EffectBuilder::BuildTexture(ast::Variable& variable) {
  Texture texture;
  texture.name = PublicName(variable.name);
  texture.dimension = variable.type.dimension;
  texture.semantic = variable.semantic;
  texture.annotations = BuildAnnotations(variable.annotations);
  texture.range = variable.range;
  if (texture.dimension == Dimension::kUnknown) texture.dimension = AnnotatedDimension(texture.annotations);
  if (IsExtensionName(variable.name)) {
    std::vector<std::string> known = attributes_;
    known.insert(known.end(), custom_attributes_.begin(), custom_attributes_.end());
    auto parsed = ParseExtensionName(variable.name, known);
    if (const auto* error = std::get_if<NamingError>(&parsed)) {
      diagnostics_.Error(variable.range, error->code, error->text);
      texture.role = FileRole{};
    } else {
      const auto& name = std::get<ExtensionName>(parsed);
      texture.format = name.format;
      texture.scale = name.scale;
      if (const auto* attribute = std::get_if<AttributeRole>(&name.role)) {
        texture.role = AttributeRole{attribute->attribute, custom_attributes_.contains(attribute->attribute)};
      } else {
        texture.role = std::get<PassResultRole>(name.role);
      }
      effect_.uses_extension = true;
      if (texture.dimension != Dimension::kUnknown && texture.dimension != Dimension::k2D) {
        diagnostics_.Error(variable.range, "B1018",
                           "texture '" + variable.name + "': attributes and pass results are 2D textures, not " +
                               ToString(variable.type));
      }
      texture.dimension = Dimension::k2D;
    }
  } else if (IsScriptTarget(texture.semantic)) {
    const ScriptTargetRole role = ScriptTarget(texture);
    texture.role = role;
    texture.scale = role.width_ratio;
    if (texture.dimension == Dimension::kUnknown) texture.dimension = Dimension::k2D;
    if (const std::string* format = StringAnnotation(texture.annotations, "Format")) {
      const auto found = FindScriptFormat(*format);
      if (found) texture.format = *found;
      const bool is_depth = std::get<ScriptTargetRole>(texture.role).is_depth_stencil;
      if (!found && !is_depth) {
        diagnostics_.Warning(variable.range, "B1019",
                             "texture '" + variable.name + "': no render target has the format '" + *format +
                                 "' here; A8R8G8B8 stands in for it");
      }
    }
  } else {
    texture.role = FileRole{FileOf(texture.annotations)};
  }
  textures_[&variable] = effect_.textures.size();
  effect_.textures.push_back(std::move(texture));
}

void EffectBuilder::BuildTextures() {
  for (const ast::Technique* technique : checker_.techniques()) {
    if (IsCustomTechnique(*technique))
      custom_attributes_.insert(LowerCase(std::string_view(technique->name).substr(3)));
  }
  for (ast::Variable* variable : checker_.globals()) {
    if (variable->type.kind == TypeKind::kTexture) BuildTexture(*variable);
  }
  CheckPassTargets();
}

void EffectBuilder::CheckPassTargets() {
  std::size_t most_passes = 0;
  for (const ast::Technique* technique : checker_.techniques()) {
    if (!IsCustomTechnique(*technique)) most_passes = std::max(most_passes, technique->passes.size());
  }
  std::map<std::pair<int, int>, const Texture*> targets;
  for (const Texture& texture : effect_.textures) {
    const auto* role = std::get_if<PassResultRole>(&texture.role);
    if (role == nullptr) continue;
    if (static_cast<std::size_t>(role->pass) >= most_passes) {
      diagnostics_.Error(texture.range, "B1004",
                         "texture '" + texture.name + "': no technique has a pass " + std::to_string(role->pass) +
                             (most_passes == 0 ? "" : "; the last is " + std::to_string(most_passes - 1)));
      continue;
    }
    const auto [at, inserted] = targets.emplace(std::pair(role->pass, role->target), &texture);
    if (!inserted) {
      diagnostics_
          .Error(texture.range, "B1007",
                 "texture '" + texture.name + "' takes the same result as '" + at->second->name + "': target " +
                     std::to_string(role->target) + " of pass " + std::to_string(role->pass))
          .notes.push_back({at->second->range, "'" + at->second->name + "' was declared here"});
    }
  }
  for (const auto& [key, texture] : targets) {
    if (key.second == 0) continue;
    const auto before = targets.find({key.first, key.second - 1});
    if (before == targets.end()) {
      diagnostics_.Error(texture->range, "B1008",
                         "texture '" + texture->name + "' is target " + std::to_string(key.second) + " of pass " +
                             std::to_string(key.first) + ", which has no target " + std::to_string(key.second - 1));
    } else if (before->second->scale != texture->scale) {
      diagnostics_
          .Error(texture->range, "B1006",
                 "texture '" + texture->name + "' and '" + before->second->name +
                     "' are targets of one pass, so they must have one scale")
          .notes.push_back({before->second->range, "'" + before->second->name + "' was declared here"});
    }
  }
}

}  // namespace burin::fx

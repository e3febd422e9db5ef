// SPDX-License-Identifier: Apache-2.0
#include "core/effect/technique_choice.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "core/effect/effect_runner.h"
#include "core/effect/object_technique.h"
#include "core/effect/parameter_part.h"
#include "core/effect/text.h"
#include "fx_parser/source/diagnostic.h"

namespace burin::effect {
namespace {

std::string Reason(const fx::Technique& technique) {
  if (!technique.unsupported.empty()) return fmt::format("{}", fmt::join(technique.unsupported, "; "));
  if (technique.passes.empty()) return "it has no passes";
  return {};
}

std::string Quoted(const std::string& name) { return name.empty() ? "(unnamed)" : "'" + name + "'"; }

Result<TechniqueChoice> ChooseNamed(const fx::Effect& effect, const std::string& wanted) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < effect.techniques.size(); ++i) {
    const fx::Technique& technique = effect.techniques[i];
    if (!technique.custom_attribute.empty()) continue;
    if (technique.name != wanted) {
      if (!technique.name.empty()) names.push_back(technique.name);
      continue;
    }
    if (const std::string reason = Reason(technique); !reason.empty()) {
      return Fail(ErrorKind::kInput,
                  fmt::format("{}: technique '{}' cannot run here: {}", effect.path, wanted, reason));
    }
    return TechniqueChoice{.technique = i, .rejected = {}, .by_object = {}};
  }
  if (names.empty()) {
    return Fail(ErrorKind::kUsage,
                fmt::format("{} has no technique '{}'; none of its techniques has a name", effect.path, wanted));
  }
  const std::string near = fx::NearestName(wanted, names);
  return Fail(ErrorKind::kUsage,
              near.empty()
                  ? fmt::format("{} has no technique '{}'; it has {}", effect.path, wanted, fmt::join(names, ", "))
                  : fmt::format("{} has no technique '{}'; did you mean '{}'?", effect.path, wanted, near));
}

bool FindUsable(const fx::Effect& effect, std::size_t first, TechniqueChoice& choice) {
  for (std::size_t i = first; i < effect.techniques.size(); ++i) {
    const fx::Technique& technique = effect.techniques[i];
    if (!technique.custom_attribute.empty()) continue;
    std::string reason = Reason(technique);
    if (reason.empty()) {
      choice.technique = i;
      return true;
    }
    choice.rejected.emplace_back(technique.name, std::move(reason));
  }
  return false;
}

// The attributes that the technique's passes look up.
std::vector<const fx::Texture*> AttributesRead(const fx::Effect& effect, std::size_t technique) {
  std::set<std::size_t> indices;
  for (const fx::Pass& pass : effect.techniques[technique].passes) {
    for (const std::size_t sampler : fx::SamplersOf(pass)) {
      if (effect.samplers[sampler].texture) indices.insert(*effect.samplers[sampler].texture);
    }
  }
  std::vector<const fx::Texture*> attributes;
  for (const std::size_t index : indices) {
    if (std::holds_alternative<fx::AttributeRole>(effect.textures[index].role)) {
      attributes.push_back(&effect.textures[index]);
    }
  }
  return attributes;
}

// -1: no such attribute is read; else whether every one of them is floating.
int AllFloating(const std::vector<const fx::Texture*>& attributes, std::initializer_list<std::string_view> names) {
  int result = -1;
  for (const fx::Texture* texture : attributes) {
    const auto& role = std::get<fx::AttributeRole>(texture->role);
    if (std::find(names.begin(), names.end(), role.attribute) == names.end()) continue;
    const bool is_float = fx::Info(texture->format).is_float;
    result = result == -1 ? is_float : (result == 1 && is_float);
  }
  return result;
}

}  // namespace

Result<TechniqueChoice> ChooseTechnique(const fx::Effect& effect, const std::string& wanted) {
  if (!wanted.empty()) return ChooseNamed(effect, wanted);
  TechniqueChoice choice;
  choice.by_object = ObjectTechniques(effect);
  for (const std::size_t technique : choice.by_object) {
    if (effect.techniques[technique].passes.empty()) continue;
    choice.technique = technique;
    return choice;
  }
  // What the file's own script asks for, then any other.
  for (const std::size_t preferred : effect.preferred_techniques) {
    if (!Reason(effect.techniques[preferred]).empty()) continue;
    choice.technique = preferred;
    return choice;
  }
  if (FindUsable(effect, 0, choice)) return choice;
  if (choice.rejected.empty()) {
    return Fail(ErrorKind::kInput, fmt::format("{}: no technique that draws a frame", effect.path));
  }
  std::string message = fmt::format("{}: no technique can run here", effect.path);
  for (const auto& [name, reason] : choice.rejected) message += fmt::format("\n  {}: {}", Quoted(name), reason);
  return Fail(ErrorKind::kInput, std::move(message));
}

bool NextTechnique(const fx::Effect& effect, TechniqueChoice& choice) {
  choice.by_object.clear();
  return FindUsable(effect, choice.technique + 1, choice);
}

std::optional<image::Encoding> AnnotatedEncoding(const fx::Technique& technique) {
  for (const fx::EffectAnnotation& annotation : technique.annotations) {
    if (!EqualsIgnoringCase(annotation.name, "ColorSpace") || annotation.value.strings.empty()) continue;
    const std::string& space = annotation.value.strings.front();
    if (EqualsIgnoringCase(space, "linear")) return image::Encoding::kSceneLinear;
    if (EqualsIgnoringCase(space, "display")) return image::Encoding::kDisplay;
  }
  return std::nullopt;
}

image::Encoding FrameEncoding(const fx::Effect& effect, std::size_t technique) {
  if (const auto annotated = AnnotatedEncoding(effect.techniques[technique])) return *annotated;
  const auto attributes = AttributesRead(effect, technique);
  // The pictures decide; what was derived from them only where there are none.
  int is_float = AllFloating(attributes, {"color", "video"});
  if (is_float == -1) is_float = AllFloating(attributes, {"albedo", "emissive", "vertexcolor", "intensity"});
  return is_float == 1 ? image::Encoding::kSceneLinear : image::Encoding::kDisplay;
}

bool AcceptsParameter(const fx::Effect& effect, const std::string& name) {
  const auto has_name = [&](const fx::Parameter& parameter) { return parameter.name == ParameterName(name); };
  return std::any_of(effect.parameters.begin(), effect.parameters.end(), has_name) ||
         std::any_of(effect.textures.begin(), effect.textures.end(), [&](const fx::Texture& texture) {
           return texture.name == name && std::holds_alternative<fx::FileRole>(texture.role);
         });
}

}  // namespace burin::effect

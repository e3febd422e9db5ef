// SPDX-License-Identifier: Apache-2.0
#include "core/render/effect_description.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/effect/effect_runner.h"
#include "core/effect/parameter_range.h"
#include "core/effect/texture_meaning.h"

namespace burin::render {
namespace {

void AddOnce(std::vector<std::size_t>& list, std::size_t index) {
  if (std::ranges::find(list, index) == list.end()) list.push_back(index);
}

std::string EncodingText(image::Encoding encoding) {
  return encoding == image::Encoding::kSceneLinear ? "scene-linear" : "display-encoded";
}

/// "   (0 to 2 in steps of 0.1: Glow)", as far as the annotations for users say it.
std::string UserText(const fx::Parameter& parameter) {
  const auto [lowest, highest] = effect::LimitsOf(parameter, 0);
  std::string text;
  if (lowest && highest)
    text = fmt::format("{:g} to {:g}", *lowest, *highest);
  else if (lowest)
    text = fmt::format("{:g} or more", *lowest);
  else if (highest)
    text = fmt::format("{:g} or less", *highest);
  const fx::EffectAnnotation* step = fx::FindAnnotation(parameter.annotations, "UIStep");
  if (!text.empty() && step != nullptr && !step->value.numbers.empty())
    text += fmt::format(" in steps of {:g}", step->value.numbers[0]);
  const fx::EffectAnnotation* name = fx::FindAnnotation(parameter.annotations, "UIName");
  if (name != nullptr && !name->value.strings.empty() && !name->value.strings[0].empty())
    text += fmt::format("{}{}", text.empty() ? "" : ": ", name->value.strings[0]);
  return text.empty() ? text : "   (" + text + ")";
}

std::string ParameterLine(const fx::Parameter& parameter) {
  std::string line = fmt::format("  {} {}", fx::ToString(parameter.type), parameter.name);
  if (!parameter.semantic.empty()) line += fmt::format(" : {}", parameter.semantic);
  if (parameter.has_default) line += fmt::format(" = {}", ValueText(parameter.default_value));
  return line + UserText(parameter) + "\n";
}

std::string PassLine(const fx::Effect& effect, const fx::Pass& pass, std::size_t index) {
  const PassFlow flow = FlowOf(effect, pass);
  const auto names = [&effect](const std::vector<std::size_t>& textures) {
    std::vector<std::string> list;
    for (const std::size_t texture : textures) list.push_back(effect.textures[texture].name);
    return fmt::format("{}", fmt::join(list, ", "));
  };
  return fmt::format("    {}{}: {} -> {}   ({}, {})\n", index, pass.name.empty() ? "" : " " + pass.name,
                     flow.reads.empty() ? "nothing" : names(flow.reads),
                     flow.writes.empty() ? "the frame" : names(flow.writes),
                     pass.program.vertex_entry.empty() ? "pass-through" : pass.program.vertex_entry,
                     pass.program.fragment_entry.empty() ? "no pixel shader" : pass.program.fragment_entry);
}

std::string TechniqueText(const fx::Effect& effect, std::size_t index, const effect::TechniqueChoice& choice) {
  const fx::Technique& technique = effect.techniques[index];
  std::string text = fmt::format("  {}", technique.name);
  if (!technique.custom_attribute.empty()) {
    text += fmt::format("   draws the custom attribute {}", technique.custom_attribute);
  } else if (index == choice.technique) {
    text += fmt::format("   used; its frame is {}", EncodingText(effect::FrameEncoding(effect, index)));
  } else {
    const auto rejected =
        std::ranges::find(choice.rejected, technique.name, &std::pair<std::string, std::string>::first);
    text += rejected != choice.rejected.end() ? fmt::format("   not used: {}", rejected->second) : "   not used";
  }
  text += "\n";
  for (std::size_t i = 0; i < technique.passes.size(); ++i) text += PassLine(effect, technique.passes[i], i);
  return text;
}

std::string_view MeaningText(effect::TextureMeaning meaning) {
  switch (meaning) {
    case effect::TextureMeaning::kBaseColor:
      return "the base colour of what is drawn";
    case effect::TextureMeaning::kNormal:
      return "the normal map of what is drawn";
    case effect::TextureMeaning::kSpecular:
      return "white, for a gloss map";
    case effect::TextureMeaning::kEmissive:
      return "the emissive map of what is drawn";
    case effect::TextureMeaning::kOcclusion:
      return "the occlusion map of what is drawn";
    case effect::TextureMeaning::kEnvironment:
      return "the surroundings";
    case effect::TextureMeaning::kNoise:
      return "noise";
    case effect::TextureMeaning::kRamp:
      return "a ramp";
    case effect::TextureMeaning::kWhite:
      break;
  }
  return "white";
}

}  // namespace

PassFlow FlowOf(const fx::Effect& effect, const fx::Pass& pass) {
  PassFlow flow;
  for (const std::size_t sampler : fx::SamplersOf(pass)) {
    if (effect.samplers[sampler].texture) AddOnce(flow.reads, *effect.samplers[sampler].texture);
  }
  for (const std::size_t target : pass.targets) AddOnce(flow.writes, target);
  return flow;
}

std::string RoleText(const fx::Texture& texture) {
  if (const auto* attribute = std::get_if<fx::AttributeRole>(&texture.role)) {
    return fmt::format("{}attribute {}", attribute->is_custom ? "custom " : "", attribute->attribute);
  }
  if (const auto* result = std::get_if<fx::PassResultRole>(&texture.role)) {
    return result->target == 0 ? fmt::format("result of pass {}", result->pass)
                               : fmt::format("result {} of pass {}", result->target, result->pass);
  }
  if (const auto* made = std::get_if<fx::ProceduralRole>(&texture.role))
    return fmt::format("filled by function {}", made->function);
  if (const auto* target = std::get_if<fx::ScriptTargetRole>(&texture.role))
    return target->is_depth_stencil ? "depth-stencil target of scripts" : "target of scripts";
  const std::string& file = std::get<fx::FileRole>(texture.role).file;
  return file.empty() ? fmt::format("no file: {}", MeaningText(effect::MeaningOf(texture)))
                      : fmt::format("file {}", file);
}

std::string SizeText(const fx::Texture& texture) {
  if (const auto* made = std::get_if<fx::ProceduralRole>(&texture.role))
    return fmt::format("{}x{}x{}", made->width, made->height, made->depth);
  if (const auto* target = std::get_if<fx::ScriptTargetRole>(&texture.role)) {
    if (target->width > 0) return fmt::format("{}x{}", target->width, target->height);
    if (target->width_ratio != target->height_ratio)
      return fmt::format("{:g} x {:g} of the frame", target->width_ratio, target->height_ratio);
  }
  return texture.scale == 1.0 ? "frame size" : fmt::format("{:g} x frame size", texture.scale);
}

std::string ValueText(const fx::Value& value) {
  if (!value.strings.empty()) return fmt::format("\"{}\"", fmt::join(value.strings, "\", \""));
  if (value.numbers.size() == 1) return fmt::format("{:g}", value.numbers.front());
  return value.numbers.empty() ? std::string() : fmt::format("{{{:g}}}", fmt::join(value.numbers, ", "));
}

Result<std::string> EffectText(const EffectFile& file, const std::string& technique) {
  const fx::Effect& effect = *file.effect;
  const auto choice = effect::ChooseTechnique(effect, technique);
  if (!choice) return std::unexpected(choice.error());
  std::string text = fmt::format("{}: effect\n", file.path);
  if (!effect.parameters.empty()) text += "\nParameters:\n";
  for (const fx::Parameter& parameter : effect.parameters) text += ParameterLine(parameter);
  if (!effect.textures.empty()) text += "\nTextures:\n";
  for (const fx::Texture& texture : effect.textures) {
    text += fmt::format("  {}   {}", texture.name, RoleText(texture));
    if (!std::holds_alternative<fx::FileRole>(texture.role)) {
      text += fmt::format(", {}, {}", fx::Info(texture.format).name, SizeText(texture));
    }
    text += "\n";
  }
  text += "\nTechniques:\n";
  for (std::size_t i = 0; i < effect.techniques.size(); ++i) text += TechniqueText(effect, i, *choice);
  return text;
}

}  // namespace burin::render

// SPDX-License-Identifier: Apache-2.0
// An effect as JSON and as a Graphviz graph.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/effect/effect_runner.h"
#include "core/render/effect_description.h"

namespace burin::render {
namespace {

using Json = nlohmann::ordered_json;

Json ValueJson(const fx::Value& value) {
  if (value.strings.size() == 1) return value.strings.front();
  if (!value.strings.empty()) return value.strings;
  if (value.numbers.size() == 1) return value.numbers.front();
  return value.numbers;
}

Json AnnotationsJson(const std::vector<fx::EffectAnnotation>& annotations) {
  Json json = Json::object();
  for (const fx::EffectAnnotation& annotation : annotations) json[annotation.name] = ValueJson(annotation.value);
  return json;
}

Json ParameterJson(const fx::Parameter& parameter) {
  Json json = {{"name", parameter.name}, {"type", fx::ToString(parameter.type)}};
  if (!parameter.semantic.empty()) json["semantic"] = parameter.semantic;
  if (parameter.has_default) json["default"] = ValueJson(parameter.default_value);
  if (!parameter.annotations.empty()) json["annotations"] = AnnotationsJson(parameter.annotations);
  return json;
}

Json TextureJson(const fx::Texture& texture) {
  Json json = {{"name", texture.name}};
  if (const auto* attribute = std::get_if<fx::AttributeRole>(&texture.role)) {
    json["role"] = attribute->is_custom ? "custom_attribute" : "attribute";
    json["attribute"] = attribute->attribute;
  } else if (const auto* result = std::get_if<fx::PassResultRole>(&texture.role)) {
    json["role"] = "pass_result";
    json["pass"] = result->pass;
    json["target"] = result->target;
  } else if (const auto* made = std::get_if<fx::ProceduralRole>(&texture.role)) {
    json["role"] = "procedural";
    json["function"] = made->function;
  } else if (const auto* target = std::get_if<fx::ScriptTargetRole>(&texture.role)) {
    json["role"] = target->is_depth_stencil ? "script_depth_stencil_target" : "script_target";
  } else {
    json["role"] = "file";
    json["file"] = std::get<fx::FileRole>(texture.role).file;
    return json;
  }
  const fx::FormatInfo& format = fx::Info(texture.format);
  json["format"] = format.name;
  json["components"] = format.components;
  json["scale"] = texture.scale;
  return json;
}

Json NamesJson(const fx::Effect& effect, const std::vector<std::size_t>& textures) {
  Json names = Json::array();
  for (const std::size_t texture : textures) names.push_back(effect.textures[texture].name);
  return names;
}

Json TechniqueJson(const fx::Effect& effect, std::size_t index, const effect::TechniqueChoice& choice) {
  const fx::Technique& technique = effect.techniques[index];
  Json json = {{"name", technique.name}, {"used", index == choice.technique}};
  if (!technique.custom_attribute.empty()) json["custom_attribute"] = technique.custom_attribute;
  const auto rejected = std::ranges::find(choice.rejected, technique.name, &std::pair<std::string, std::string>::first);
  if (rejected != choice.rejected.end()) json["rejected"] = rejected->second;
  json["frame"] = effect::FrameEncoding(effect, index) == image::Encoding::kSceneLinear ? "scene-linear" : "display";
  json["passes"] = Json::array();
  for (const fx::Pass& pass : technique.passes) {
    const PassFlow flow = FlowOf(effect, pass);
    json["passes"].push_back({{"name", pass.name},
                              {"vertex_shader", pass.program.vertex_entry},
                              {"pixel_shader", pass.program.fragment_entry},
                              {"reads", NamesJson(effect, flow.reads)},
                              {"writes", NamesJson(effect, flow.writes)}});
  }
  return json;
}

/// A Graphviz string: quotes and backslashes escaped.
std::string Quoted(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '\n') {
      quoted += "\\n";
      continue;
    }
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "\"";
}

}  // namespace

Result<std::string> EffectJson(const EffectFile& file, const std::string& technique) {
  const fx::Effect& effect = *file.effect;
  const auto choice = effect::ChooseTechnique(effect, technique);
  if (!choice) return std::unexpected(choice.error());
  Json json = {{"file", file.path},           {"kind", "effect"},
               {"parameters", Json::array()}, {"textures", Json::array()},
               {"techniques", Json::array()}, {"warnings", file.warnings}};
  for (const fx::Parameter& parameter : effect.parameters) json["parameters"].push_back(ParameterJson(parameter));
  for (const fx::Texture& texture : effect.textures) json["textures"].push_back(TextureJson(texture));
  for (std::size_t i = 0; i < effect.techniques.size(); ++i) {
    json["techniques"].push_back(TechniqueJson(effect, i, *choice));
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

Result<std::string> EffectDot(const EffectFile& file, const std::string& technique) {
  const fx::Effect& effect = *file.effect;
  const auto choice = effect::ChooseTechnique(effect, technique);
  if (!choice) return std::unexpected(choice.error());
  std::string dot = fmt::format("digraph {} {{\n  rankdir=LR;\n  frame [shape=doublecircle];\n", Quoted(file.path));
  std::vector<bool> is_drawn(effect.textures.size(), false);
  const auto node = [&](std::size_t index) {
    const fx::Texture& texture = effect.textures[index];
    if (!is_drawn[index]) {
      is_drawn[index] = true;
      dot += fmt::format("  t{} [shape=box, label={}];\n", index, Quoted(texture.name + "\n" + RoleText(texture)));
    }
    return fmt::format("t{}", index);
  };
  const fx::Technique& used = effect.techniques[choice->technique];
  for (std::size_t i = 0; i < used.passes.size(); ++i) {
    const PassFlow flow = FlowOf(effect, used.passes[i]);
    const std::string title =
        used.passes[i].name.empty() ? fmt::format("pass {}", i) : fmt::format("pass {}: {}", i, used.passes[i].name);
    dot += fmt::format("  p{} [shape=ellipse, label={}];\n", i, Quoted(title));
    for (const std::size_t texture : flow.reads) dot += fmt::format("  {} -> p{};\n", node(texture), i);
    for (const std::size_t texture : flow.writes) dot += fmt::format("  p{} -> {};\n", i, node(texture));
    if (flow.writes.empty()) dot += fmt::format("  p{} -> frame;\n", i);
  }
  return dot + "}\n";
}

}  // namespace burin::render

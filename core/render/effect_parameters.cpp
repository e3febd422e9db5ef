// SPDX-License-Identifier: Apache-2.0
#include "core/render/effect_parameters.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <strings.h>

#include <algorithm>
#include <filesystem>

#include "core/effect/effect_runner.h"
#include "fx_parser/source/diagnostic.h"

namespace burin::render {
namespace {

bool IsFileTexture(const fx::Effect& effect, const std::string& name) {
  return std::ranges::any_of(effect.textures, [&](const fx::Texture& texture) {
    return texture.name == name && std::holds_alternative<fx::FileRole>(texture.role);
  });
}

std::string AbsoluteIfThere(const std::string& file) {
  std::error_code status;
  if (!std::filesystem::exists(file, status)) return file;
  const auto path = std::filesystem::absolute(file, status);
  return status ? file : path.string();
}

}  // namespace

Result<std::vector<Assignments>> ShareParameters(std::span<const std::shared_ptr<const fx::Effect>> effects,
                                                 const Assignments& assignments) {
  std::vector<Assignments> shares(effects.size());
  for (const auto& [name, value] : assignments) {
    bool used = false;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < effects.size(); ++i) {
      const fx::Effect& effect = *effects[i];
      if (IsFileTexture(effect, name)) {
        shares[i].emplace_back(name, AbsoluteIfThere(value));
        used = true;
      } else if (effect::AcceptsParameter(effect, name)) {
        shares[i].emplace_back(name, value);
        used = true;
      }
      for (const fx::Parameter& parameter : effect.parameters) names.push_back(parameter.name);
    }
    if (used) continue;
    const std::string nearest = fx::NearestName(name, names);
    return Fail(ErrorKind::kUsage,
                effects.empty() ? fmt::format("--param {}: there is no effect", name)
                                : fmt::format("--param {}: no effect declares such a parameter{}", name,
                                              nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest)));
  }
  return shares;
}

Result<std::vector<std::string>> ShareTechnique(std::span<const std::shared_ptr<const fx::Effect>> effects,
                                                const std::string& wanted) {
  std::vector<std::string> techniques(effects.size());
  if (wanted.empty()) return techniques;
  bool used = false;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < effects.size(); ++i) {
    for (const fx::Technique& technique : effects[i]->techniques) {
      names.push_back(technique.name);
      if (strcasecmp(technique.name.c_str(), wanted.c_str()) != 0) continue;
      techniques[i] = technique.name;
      used = true;
    }
  }
  if (used) return techniques;
  return Fail(ErrorKind::kUsage, effects.empty() ? fmt::format("--technique {}: there is no effect", wanted)
                                                 : fmt::format("--technique {}: no such technique; there are: {}",
                                                               wanted, fmt::join(names, ", ")));
}

}  // namespace burin::render

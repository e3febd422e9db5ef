// SPDX-License-Identifier: Apache-2.0
// The annotations of techniques in MikuMikuEffect's reference.
#include "core/effect/object_technique.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

#include "core/effect/text.h"

namespace burin::effect {
namespace {

std::string_view Text(const fx::Technique& technique, std::string_view name) {
  const fx::EffectAnnotation* found = fx::FindAnnotation(technique.annotations, name);
  if (found == nullptr || found->value.strings.empty()) return {};
  return found->value.strings.front();
}

std::optional<bool> Flag(const fx::Technique& technique, std::string_view name) {
  const fx::EffectAnnotation* found = fx::FindAnnotation(technique.annotations, name);
  if (found == nullptr || found->value.numbers.empty()) return std::nullopt;
  return found->value.numbers.front() != 0;
}

bool IsOfPass(const fx::Technique& technique, std::string_view pass) {
  const std::string_view own = Text(technique, "MMDPass");
  return EqualsIgnoringCase(own.empty() ? "object" : own, pass);
}

bool CanRun(const fx::Technique& technique) {
  // One without passes is there to draw nothing.
  return technique.custom_attribute.empty() && (technique.unsupported.empty() || technique.passes.empty());
}

// Eats a number; empty when there is none.
std::optional<int> Number(std::string_view& text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  return number;
}

// "0,3-5,8-": numbers of materials, and ranges that may be open at their end.
bool InSubset(std::string_view subset, int index) {
  if (subset.empty()) return true;
  while (!subset.empty()) {
    const std::size_t comma = std::min(subset.find(','), subset.size());
    std::string_view part = subset.substr(0, comma);
    subset.remove_prefix(std::min(comma + 1, subset.size()));
    const auto first = Number(part);
    if (!first) continue;
    if (part.empty() && *first == index) return true;
    if (!part.starts_with('-') || index < *first) continue;
    part.remove_prefix(1);
    const auto last = Number(part);
    if (!last || index <= *last) return true;
  }
  return false;
}

}  // namespace

std::vector<std::size_t> ObjectTechniques(const fx::Effect& effect) {
  const bool says_so = std::ranges::any_of(
      effect.techniques, [](const fx::Technique& technique) { return !Text(technique, "MMDPass").empty(); });
  if (!says_so) return {};
  for (const std::string_view pass : {"object", "object_ss"}) {
    std::vector<std::size_t> techniques;
    bool draws = false;
    for (std::size_t i = 0; i < effect.techniques.size(); ++i) {
      if (!IsOfPass(effect.techniques[i], pass) || !CanRun(effect.techniques[i])) continue;
      techniques.push_back(i);
      draws |= !effect.techniques[i].passes.empty();
    }
    if (draws) return techniques;
  }
  return {};
}

bool Draws(const fx::Technique& technique, const MaterialContext& material) {
  if (Flag(technique, "UseTexture").value_or(material.has_texture) != material.has_texture) return false;
  if (Flag(technique, "UseSphereMap").value_or(false) || Flag(technique, "UseToon").value_or(false)) return false;
  if (Flag(technique, "UseSelfShadow").value_or(false)) return false;
  return InSubset(Text(technique, "Subset"), std::max(material.index, 0));
}

}  // namespace burin::effect

// SPDX-License-Identifier: Apache-2.0
// OFFSCREENRENDERTARGET, as the reference of MikuMikuEffect describes it.
#include "core/effect/offscreen.h"

#include <algorithm>
#include <array>
#include <vector>

#include "core/effect/text.h"

namespace burin::effect {
namespace {

struct Rule {
  std::string pattern;
  std::string effect;
};

std::string Trimmed(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kSpace);
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(kSpace) - first + 1));
}

std::vector<Rule> Rules(std::string_view text) {
  std::vector<Rule> rules;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(';'), text.size());
    const std::string_view entry = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::size_t equals = entry.find('=');
    if (equals == std::string_view::npos) continue;
    rules.push_back({LowerCase(Trimmed(entry.substr(0, equals))), Trimmed(entry.substr(equals + 1))});
  }
  return rules;
}

// '*' stands for anything. On a mismatch the last star takes one character more.
bool Matches(std::string_view pattern, std::string_view name) {
  std::size_t p = 0, n = 0, star = std::string_view::npos, taken = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      taken = n;
    } else if (p < pattern.size() && pattern[p] == name[n]) {
      ++p;
      ++n;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      n = ++taken;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

}  // namespace

OffscreenContent ContentOf(const fx::Texture& texture) {
  const fx::EffectAnnotation* annotation = fx::FindAnnotation(texture.annotations, "DefaultEffect");
  if (annotation == nullptr || annotation->value.strings.empty()) return {};
  const std::vector<Rule> rules = Rules(annotation->value.strings.front());
  // The kinds of models there are, in the order in which effects care for them.
  constexpr std::array<std::string_view, 3> kModels = {"scene.pmx", "scene.pmd", "scene.x"};
  for (const std::string_view model : kModels) {
    for (const Rule& rule : rules) {
      if (!Matches(rule.pattern, model)) continue;
      if (EqualsIgnoringCase(rule.effect, "hide")) return {.kind = OffscreenContent::Kind::kNothing, .file = {}};
      if (EqualsIgnoringCase(rule.effect, "none")) return {};
      return {.kind = OffscreenContent::Kind::kEffect, .file = rule.effect};
    }
  }
  return {};
}

}  // namespace burin::effect

// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <strings.h>

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>

#include "cli/command_table.h"
#include "cli/console.h"
#include "core/render/effect_library.h"

namespace burin::cli {
namespace {

bool Holds(const render::ShippedEffect& effect, const std::string& word) {
  return strcasestr(effect.name.c_str(), word.c_str()) != nullptr ||
         strcasestr(effect.purpose.c_str(), word.c_str()) != nullptr;
}

std::string Lines(const std::vector<render::ShippedEffect>& effects) {
  std::size_t column = 0;
  for (const render::ShippedEffect& effect : effects) column = std::max(column, effect.name.size());
  std::string text;
  for (const render::ShippedEffect& effect : effects) {
    text +=
        effect.purpose.empty() ? effect.name + "\n" : fmt::format("{:<{}}  {}\n", effect.name, column, effect.purpose);
  }
  return text;
}

std::string Json(const std::vector<render::ShippedEffect>& effects) {
  auto list = nlohmann::ordered_json::array();
  for (const render::ShippedEffect& effect : effects) {
    list.push_back({{"name", effect.name}, {"file", effect.path}, {"purpose", effect.purpose}});
  }
  return list.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace

int RunEffects(const Settings& settings) {
  std::vector<render::ShippedEffect> effects = render::ShippedEffects();
  for (const std::string& word : settings.arguments) {
    std::erase_if(effects, [&word](const render::ShippedEffect& effect) { return !Holds(effect, word); });
  }
  if (effects.empty() && !settings.json) {
    PrintWarning(settings.arguments.empty() ? "no shipped effects were found; $BURIN_EFFECTS_PATH can name their folder"
                                            : "no shipped effect holds these words");
  }
  return PrintData(settings.json ? Json(effects) : Lines(effects));
}

}  // namespace burin::cli

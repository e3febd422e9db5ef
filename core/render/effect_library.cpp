// SPDX-License-Identifier: Apache-2.0
#include "core/render/effect_library.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "core/base/path.h"
#include "core/base/program_paths.h"
#include "core/render/name_pattern.h"
#include "fx_parser/source/diagnostic.h"

namespace burin::render {
namespace {

namespace fs = std::filesystem;

bool IsFile(const std::string& path) {
  std::error_code ignored;
  return fs::exists(path, ignored) && !fs::is_directory(path, ignored);
}

/// The words of a comment line without its marks; empty when the line is none or is a licence tag.
std::string CommentWords(std::string line) {
  const auto strip_front = [&line](std::string_view what) {
    while (!line.empty() && what.find(line.front()) != std::string_view::npos) line.erase(line.begin());
  };
  strip_front(" \t");
  if (!line.starts_with("//") && !line.starts_with("/*") && !line.starts_with("*")) return {};
  strip_front("/* \t");
  while (!line.empty() && std::string_view("/* \t\r").find(line.back()) != std::string_view::npos) line.pop_back();
  return line.find("SPDX-License-Identifier") == std::string::npos ? line : std::string();
}

std::string Purpose(const fs::path& path) {
  static constexpr int kMaxLines = 20;
  std::ifstream file(path);
  std::string line;
  for (int i = 0; i < kMaxLines && std::getline(file, line); ++i) {
    if (std::string words = CommentWords(line); !words.empty()) return words;
  }
  return {};
}

std::string WithoutExtension(const std::string& name) {
  return IsEffectPath(name) ? name.substr(0, name.rfind('.')) : name;
}

/// Shipped effects whose name is `name` or ends with "/name".
std::vector<ShippedEffect> Matches(const std::vector<ShippedEffect>& shipped, const std::string& name) {
  std::vector<ShippedEffect> matches;
  for (const ShippedEffect& effect : shipped) {
    if (effect.name == name) return {effect};
    if (effect.name.ends_with("/" + name)) matches.push_back(effect);
  }
  return matches;
}

std::unexpected<Error> Ambiguous(const std::string& argument, const std::vector<ShippedEffect>& matches) {
  std::vector<std::string> names;
  for (const ShippedEffect& match : matches) names.push_back(match.name);
  return Fail(ErrorKind::kUsage,
              fmt::format("'{}' means several shipped effects: {}", argument, fmt::join(names, ", ")));
}

std::string NotFound(const std::string& argument, const std::vector<ShippedEffect>& shipped) {
  std::vector<std::string> names;
  for (const ShippedEffect& effect : shipped) {
    names.push_back(effect.name);
    names.push_back(effect.name.substr(effect.name.rfind('/') + 1));
  }
  const std::string nearest = fx::NearestName(WithoutExtension(argument), names);
  return fmt::format("{}: no such file, and no shipped effect of this name{}; burin effects lists them", argument,
                     nearest.empty() ? "" : fmt::format(" (did you mean {}?)", nearest));
}

}  // namespace

std::vector<ShippedEffect> ShippedEffects() {
  std::vector<ShippedEffect> effects;
  std::set<std::string> seen;  // an earlier folder's effect hides a later one's
  for (const std::string& folder : base::EffectFolders()) {
    std::error_code status;
    fs::recursive_directory_iterator entries(folder, status);
    for (; !status && entries != fs::recursive_directory_iterator(); entries.increment(status)) {
      const fs::path& path = entries->path();
      if (path.extension() != ".fx" || !entries->is_regular_file(status)) continue;
      const std::string name = WithoutExtension(fs::relative(path, folder, status).generic_string());
      if (seen.insert(name).second) effects.push_back({name, path.string(), Purpose(path)});
    }
  }
  std::ranges::sort(effects, {}, &ShippedEffect::name);
  return effects;
}

bool IsEffectPath(const std::string& path) {
  const std::string extension = base::LowerExtension(path);
  return extension == "fx" || extension == "fxh" || extension == "fxsub" || extension == "cgfx";
}

Result<std::string> FindEffect(const std::string& argument) {
  if (IsFile(argument)) return argument;
  const std::vector<ShippedEffect> shipped = ShippedEffects();
  const std::vector<ShippedEffect> matches = Matches(shipped, WithoutExtension(argument));
  if (matches.size() > 1) return Ambiguous(argument, matches);
  if (matches.empty()) return Fail(ErrorKind::kInput, NotFound(argument, shipped));
  return matches.front().path;
}

Result<Inputs> SortInputs(const std::vector<std::string>& arguments) {
  Inputs inputs;
  for (const std::string& argument : arguments) {
    bool is_effect = IsEffectPath(argument);
    if (!is_effect && argument != "-" && base::LowerExtension(argument).empty() && !IsFile(argument)) {
      const auto pattern = NamePattern::Parse(argument);
      is_effect = !pattern || !pattern->has_token();
    }
    if (is_effect) {
      auto path = FindEffect(argument);
      if (!path) return std::unexpected(path.error());
      inputs.effects.push_back(*std::move(path));
    } else if (inputs.source.empty()) {
      inputs.source = argument;
    } else {
      return Fail(ErrorKind::kUsage,
                  fmt::format("two sources, {} and {}; expected one (effects end in .fx)", inputs.source, argument));
    }
  }
  return inputs;
}

}  // namespace burin::render

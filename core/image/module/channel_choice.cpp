// SPDX-License-Identifier: Apache-2.0
#include "core/image/module/channel_choice.h"

#include <cstddef>
#include <initializer_list>
#include <string_view>

namespace burin::image {
namespace {

constexpr std::size_t kMostChannels = 4;

struct LayerName {
  std::string_view layer;  ///< with its dot, "" for the main layer
  std::string_view channel;
};

LayerName Split(std::string_view name) {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos) return {"", name};
  return {name.substr(0, dot + 1), name.substr(dot + 1)};
}

std::optional<int> Find(std::span<const std::string> names, std::string_view layer, std::string_view channel) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    const LayerName split = Split(names[i]);
    if (split.layer == layer && split.channel == channel) return static_cast<int>(i);
  }
  return std::nullopt;
}

std::vector<int> PictureOf(std::span<const std::string> names, std::string_view layer) {
  for (const std::initializer_list<std::string_view> set : {std::initializer_list<std::string_view>{"R", "G", "B"},
                                                            {"r", "g", "b"},
                                                            {"red", "green", "blue"},
                                                            {"Y"},
                                                            {"y"}}) {
    std::vector<int> picture;
    for (const std::string_view channel : set) {
      if (const auto index = Find(names, layer, channel)) picture.push_back(*index);
    }
    if (picture.size() != set.size()) continue;
    for (const std::string_view alpha : {"A", "a", "alpha"}) {
      if (const auto index = Find(names, layer, alpha)) {
        picture.push_back(*index);
        break;
      }
    }
    return picture;
  }
  return {};
}

}  // namespace

std::optional<std::vector<int>> ChoosePictureChannels(std::span<const std::string> names) {
  if (std::vector<int> main = PictureOf(names, ""); !main.empty()) return main;
  if (names.size() <= kMostChannels && !names.empty()) {
    std::vector<int> all;
    for (std::size_t i = 0; i < names.size(); ++i) all.push_back(static_cast<int>(i));
    return all;
  }
  for (const std::string& name : names) {
    if (std::vector<int> picture = PictureOf(names, Split(name).layer); picture.size() >= 3) return picture;
  }
  return std::nullopt;
}

}  // namespace burin::image

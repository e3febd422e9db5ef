// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/glsl/semantic.h"

#include <map>

#include "fx_parser/glsl/interface.h"

namespace burin::fx {
namespace {

char Upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
bool IsDigit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

Semantic ParseSemantic(std::string_view text) {
  static const std::map<std::string_view, std::string_view> aliases = {{"SV_POSITION", "POSITION"},
                                                                       {"SV_TARGET", "COLOR"},
                                                                       {"SV_DEPTH", "DEPTH"},
                                                                       {"TEX", "TEXCOORD"},
                                                                       {"COL", "COLOR"},
                                                                       {"HPOS", "POSITION"},
                                                                       {"WPOS", "VPOS"},
                                                                       {"POSITIONT", "POSITION"},
                                                                       {"FACE", "VFACE"}};
  Semantic semantic;
  std::size_t end = text.size();
  while (end > 0 && IsDigit(text[end - 1])) --end;
  for (const char c : text.substr(0, end)) semantic.name += Upper(c);
  // Indices past three digits name nothing; keep the number small enough for an int.
  for (const char c : text.substr(end, 4)) semantic.index = semantic.index * 10 + (c - '0');
  if (const auto alias = aliases.find(semantic.name); alias != aliases.end()) semantic.name = alias->second;
  return semantic;
}

std::optional<int> VertexInputLocation(std::string_view text) {
  static const std::map<std::string_view, int> locations = {{"POSITION0", 0},    {"NORMAL0", 1},      {"TANGENT0", 2},
                                                            {"BINORMAL0", 3},    {"COLOR0", 4},       {"COLOR1", 5},
                                                            {"BLENDWEIGHT0", 6}, {"BLENDINDICES0", 7}};
  // Cg's attribute numbers (Cg Toolkit 3.1, profile arbvp1, "Varying Input Semantics").
  static const std::map<int, std::string_view> attributes = {
      {0, "POSITION0"}, {1, "BLENDWEIGHT0"}, {2, "NORMAL0"}, {3, "COLOR0"}, {4, "COLOR1"}};
  const Semantic semantic = ParseSemantic(text);
  if (semantic.name == "ATTR") {
    if (semantic.index >= 8) return VertexInputLocation("TEXCOORD" + std::to_string(semantic.index - 8));
    const auto at = attributes.find(semantic.index);
    return at == attributes.end() ? std::nullopt : VertexInputLocation(at->second);
  }
  if (semantic.name == "TEXCOORD") {
    return semantic.index < 8 ? std::optional(8 + semantic.index) : std::nullopt;
  }
  const auto at = locations.find(semantic.Key());
  return at != locations.end() ? std::optional(at->second) : std::nullopt;
}

}  // namespace burin::fx

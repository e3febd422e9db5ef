// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/effect/profile.h"

#include <map>
#include <string>

#include "fx_parser/effect/case.h"

namespace burin::fx {

Profile FindProfile(std::string_view name) {
  using enum ProfileStage;
  static const std::map<std::string_view, Profile> cg = {
      {"vp20", {kVertex, 1}},   {"vp30", {kVertex, 2}},  {"vp40", {kVertex, 3}},  {"arbvp1", {kVertex, 2}},
      {"gp4vp", {kVertex, 4}},  {"gp5vp", {kVertex, 5}}, {"glslv", {kVertex, 3}}, {"fp20", {kPixel, 1}},
      {"fp30", {kPixel, 2}},    {"fp40", {kPixel, 3}},   {"arbfp1", {kPixel, 2}}, {"gp4fp", {kPixel, 4}},
      {"gp5fp", {kPixel, 5}},   {"glslf", {kPixel, 3}},  {"hlslv", {kVertex, 3}}, {"hlslf", {kPixel, 3}},
      {"latest", {kEither, 3}}, {"gp4gp", {kOther, 4}},  {"gp5gp", {kOther, 5}},  {"gp5tcp", {kOther, 5}},
      {"gp5tep", {kOther, 5}},  {"glslg", {kOther, 4}},  {"tx_1_0", {kOther, 1}}};
  const std::string lower = LowerCase(name);
  if (const auto at = cg.find(lower); at != cg.end()) return at->second;
  if (lower.size() < 5 || lower[2] != '_' || lower[3] < '1' || lower[3] > '6' || lower[4] != '_') return {};
  const int model = lower[3] - '0';
  if (lower.starts_with("vs")) return {kVertex, model};
  if (lower.starts_with("ps")) return {kPixel, model};
  for (const std::string_view stage : {"gs", "hs", "ds", "cs", "ms", "as"}) {
    if (lower.starts_with(stage)) return {kOther, model};
  }
  return {};
}

}  // namespace burin::fx

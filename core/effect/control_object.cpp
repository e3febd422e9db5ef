// SPDX-License-Identifier: Apache-2.0
// CONTROLOBJECT, as the reference of MikuMikuEffect 0.37 describes it.
#include "core/effect/control_object.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/effect/text.h"

namespace burin::effect {
namespace {

constexpr double kUsualScale = 10.0;

std::string Annotation(const fx::Parameter& parameter, std::string_view name) {
  const fx::EffectAnnotation* found = fx::FindAnnotation(parameter.annotations, name);
  return found == nullptr || found->value.strings.empty() ? std::string() : found->value.strings.front();
}

std::array<double, 4> OfSelf(const fx::Parameter& parameter, const std::string& item) {
  if (EqualsIgnoringCase(item, "Si")) return {kUsualScale, kUsualScale, kUsualScale, kUsualScale};
  if (EqualsIgnoringCase(item, "Tr")) return {1, 1, 1, 1};
  if (!item.empty()) return {0, 0, 0, 1};
  if (parameter.type.scalar == fx::Scalar::kBool) return {1, 1, 1, 1};
  if (parameter.type.components() == 1) return {kUsualScale, 0, 0, 0};
  return {0, 0, 0, 1};
}

}  // namespace

std::optional<std::array<double, 4>> ControlObjectValue(const fx::Effect& effect, const fx::Parameter& parameter,
                                                        std::vector<std::string>& warnings) {
  const std::string name = Annotation(parameter, "name");
  if (name.empty()) return std::nullopt;
  if (EqualsIgnoringCase(name, "(self)") || EqualsIgnoringCase(name, "(OffscreenOwner)"))
    return OfSelf(parameter, Annotation(parameter, "item"));
  std::string warning =
      fmt::format("{}: the model '{}' that controls the effect is not here: what it gives is 0", effect.path, name);
  if (std::ranges::find(warnings, warning) == warnings.end()) warnings.push_back(std::move(warning));
  return std::array<double, 4>{0, 0, 0, 0};
}

}  // namespace burin::effect

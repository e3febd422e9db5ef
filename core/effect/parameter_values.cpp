// SPDX-License-Identifier: Apache-2.0
#include "core/effect/parameter_values.h"

#include <algorithm>

#include "core/effect/text.h"
#include "fx_parser/semantics/conversion.h"

namespace burin::effect {

ParameterValues::ParameterValues(const fx::Effect& effect, const Overrides& overrides,
                                 std::vector<glm::ivec2> texture_sizes, std::vector<std::string>& warnings)
    : versions_(effect.parameters.size(), 1),
      texture_sizes_(std::move(texture_sizes)),
      column_vectors_(LowerCase(effect.path).ends_with(".cgfx")) {
  values_.reserve(effect.parameters.size());
  for (std::size_t i = 0; i < effect.parameters.size(); ++i) {
    const fx::Parameter& parameter = effect.parameters[i];
    if (const auto found = overrides.parameters.find(i); found != overrides.parameters.end()) {
      values_.push_back(found->second);
      continue;
    }
    values_.push_back(parameter.default_value);
    if (auto host = FindHostValue(effect, parameter, warnings)) {
      values_.back().type = parameter.type;
      std::size_t size = static_cast<std::size_t>(parameter.type.components());
      for (const std::uint32_t length : parameter.type.array) size *= length;
      values_.back().numbers.resize(size, 0.0);
      bindings_.push_back({i, {.offset = 0, .type = parameter.type, .host = std::move(*host)}});
    }
    for (HostPart& part : FindHostParts(parameter)) bindings_.push_back({i, std::move(part)});
  }
}

bool ParameterValues::has_material_color() const {
  return std::any_of(bindings_.begin(), bindings_.end(), [](const HostBinding& binding) {
    return binding.part.host.kind == HostValue::Kind::kMaterialDiffuse;
  });
}

void ParameterValues::SetFrame(const FrameContext& context) {
  for (const HostBinding& binding : bindings_) Update(binding, context);
}

void ParameterValues::SetObject(const FrameContext& context) {
  for (const HostBinding& binding : bindings_) {
    if (binding.part.host.depends_on_object()) Update(binding, context);
  }
}

void ParameterValues::Set(std::size_t parameter, double number) {
  std::vector<double>& numbers = values_[parameter].numbers;
  if (numbers.empty() || numbers[0] == number) return;
  numbers[0] = number;
  ++versions_[parameter];
}

void ParameterValues::Update(const HostBinding& binding, const FrameContext& context) {
  std::vector<double>& numbers = values_[binding.parameter].numbers;
  scratch_.assign(numbers.begin(), numbers.end());
  const std::span<double> all(numbers);
  const HostPart& part = binding.part;
  const auto whole = static_cast<std::size_t>(fx::FlatComponents(part.type));
  if (part.offset + whole > all.size()) return;
  Evaluate(part.host, context, texture_sizes_, part.type, column_vectors_, all.subspan(part.offset, whole));
  if (numbers != scratch_) ++versions_[binding.parameter];
}

}  // namespace burin::effect

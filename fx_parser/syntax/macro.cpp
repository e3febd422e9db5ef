// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/syntax/macro.h"

#include <algorithm>

namespace burin::fx {

std::optional<std::size_t> Macro::ParameterIndex(const Token& token) const {
  if (token.kind != TokenKind::kIdentifier) return std::nullopt;
  const auto found = std::ranges::find(parameters, token.text);
  if (found == parameters.end()) return std::nullopt;
  return static_cast<std::size_t>(found - parameters.begin());
}

bool Macro::SameAs(const Macro& other) const {
  const auto same_token = [](const Token& a, const Token& b) { return a.kind == b.kind && a.text == b.text; };
  return is_function == other.is_function && is_variadic == other.is_variadic && builtin == other.builtin &&
         parameters == other.parameters && std::ranges::equal(body, other.body, same_token);
}

void MacroTable::Define(std::shared_ptr<Macro> macro) {
  std::shared_ptr<Macro>& slot = macros_[macro->name];
  if (!slot || !slot->SameAs(*macro)) ++version_;
  slot = std::move(macro);
}

void MacroTable::Undefine(std::string_view name) {
  const auto found = macros_.find(name);
  if (found == macros_.end()) return;
  macros_.erase(found);
  ++version_;
}

std::shared_ptr<Macro> MacroTable::Find(std::string_view name) const {
  const auto found = macros_.find(name);
  return found == macros_.end() ? nullptr : found->second;
}

}  // namespace burin::fx

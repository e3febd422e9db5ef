// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/semantics/scope.h"

namespace burin::fx {

void ScopeStack::PopLeaking() {
  auto inner = std::move(scopes_.back());
  scopes_.pop_back();
  for (auto& [name, symbol] : inner) {
    symbol.leaked = true;
    const auto [at, inserted] = scopes_.back().try_emplace(name, symbol);
    if (!inserted && at->second.leaked) at->second = std::move(symbol);
  }
}

bool ScopeStack::Declare(const std::string& name, const Symbol& symbol, Symbol* existing) {
  const auto [at, inserted] = scopes_.back().try_emplace(name, symbol);
  if (inserted) return true;
  const Symbol before = at->second;
  at->second = symbol;
  if (before.leaked) return true;
  if (existing != nullptr) *existing = before;
  return false;
}

const Symbol* ScopeStack::Find(const std::string& name) const {
  for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope) {
    if (const auto at = scope->find(name); at != scope->end()) return &at->second;
  }
  return nullptr;
}

std::vector<std::string> ScopeStack::VariableNames() const {
  std::vector<std::string> names;
  for (const auto& scope : scopes_) {
    for (const auto& [name, symbol] : scope) {
      if (symbol.variable != nullptr) names.push_back(name);
    }
  }
  return names;
}

}  // namespace burin::fx

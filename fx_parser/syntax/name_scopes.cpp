// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/syntax/name_scopes.h"

#include <algorithm>

namespace burin::fx {

void NameScopes::Pop() {
  for (const std::string& name : scopes_.back()) {
    const auto found = names_.find(name);
    found->second.pop_back();
    if (found->second.empty()) names_.erase(found);
  }
  scopes_.pop_back();
}

void NameScopes::Declare(const std::string& name, bool is_type) {
  if (name.empty()) return;
  names_[name].push_back(is_type);
  scopes_.back().push_back(name);
}

bool NameScopes::IsType(std::string_view name) const {
  const auto found = names_.find(name);
  return found != names_.end() && found->second.back();
}

bool NameScopes::IsLocal(std::string_view name) const {
  for (std::size_t i = 1; i < scopes_.size(); ++i) {
    if (std::ranges::find(scopes_[i], name) != scopes_[i].end()) return true;
  }
  return false;
}

std::string NameScopes::Resolve(std::string_view name, std::string_view space) const {
  if (name.starts_with("::")) return std::string(name.substr(2));
  if (space.empty() || IsLocal(name)) return std::string(name);
  while (!space.empty()) {
    std::string whole = std::string(space) + std::string(name);
    if (names_.contains(whole)) return whole;
    space.remove_suffix(2);
    const std::size_t outer = space.rfind("::");
    space = space.substr(0, outer == std::string_view::npos ? 0 : outer + 2);
  }
  return std::string(name);
}

std::vector<std::string> NameScopes::TypeNames() const {
  std::vector<std::string> types;
  for (const auto& [name, declarations] : names_) {
    if (declarations.back()) types.push_back(name);
  }
  return types;
}

}  // namespace burin::fx

// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/syntax/name_scopes.h"

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

std::vector<std::string> NameScopes::TypeNames() const {
  std::vector<std::string> types;
  for (const auto& [name, declarations] : names_) {
    if (declarations.back()) types.push_back(name);
  }
  return types;
}

}  // namespace burin::fx

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace burin::fx {

/// Which names are types where: all that the parser has to know about them. An inner declaration hides an outer one.
class NameScopes {
 public:
  void Push() { scopes_.emplace_back(); }
  void Pop();
  void Declare(const std::string& name, bool is_type);
  [[nodiscard]] bool IsType(std::string_view name) const;
  /// Sorted.
  [[nodiscard]] std::vector<std::string> TypeNames() const;

 private:
  std::map<std::string, std::vector<bool>, std::less<>> names_;   // the innermost declaration last; never empty
  std::vector<std::vector<std::string>> scopes_;                   // what to take back when each ends
};

}  // namespace burin::fx

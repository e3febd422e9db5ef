// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace burin::fx {

/// Which names are declared where, and which of them are types: all that the parser has to know about them. An inner
/// declaration hides an outer one. Names in namespaces are declared whole, "outer::inner::name".
class NameScopes {
 public:
  void Push() { scopes_.emplace_back(); }
  void Pop();
  void Declare(const std::string& name, bool is_type);
  [[nodiscard]] bool IsType(std::string_view name) const;
  /// The whole name that `name` means inside `space` ("outer::inner::", or empty): a local one, that of the innermost
  /// namespace that has it, or `name` itself where none has.
  [[nodiscard]] std::string Resolve(std::string_view name, std::string_view space) const;
  /// Sorted.
  [[nodiscard]] std::vector<std::string> TypeNames() const;

 private:
  [[nodiscard]] bool IsLocal(std::string_view name) const;

  std::map<std::string, std::vector<bool>, std::less<>> names_;  // the innermost declaration last; never empty
  std::vector<std::vector<std::string>> scopes_;                 // what to take back when each ends
};

}  // namespace burin::fx

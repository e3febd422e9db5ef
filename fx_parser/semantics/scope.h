// SPDX-License-Identifier: Apache-2.0
#pragma once
// What names stand for while one effect is checked.

#include <string>
#include <unordered_map>
#include <vector>

#include "fx_parser/syntax/ast.h"

namespace burin::fx {

/// What a name in a scope stands for; exactly one is set (typedefs by their type).
struct Symbol {
  ast::Variable* variable = nullptr;
  ast::Struct* structure = nullptr;
  ast::Typedef* alias = nullptr;
  Type type;
  /// A loop variable seen after its loop, as Direct3D 9 compilers let one; the next declaration replaces it silently.
  bool leaked = false;
};

class ScopeStack {
 public:
  ScopeStack() { Push(); }
  void Push() { scopes_.emplace_back(); }
  void Pop() { scopes_.pop_back(); }
  /// Pops a for statement's scope and leaves its variables behind as leaked ones.
  void PopLeaking();
  /// False when this scope has the name already; `*existing` is then what it stood for. The name means the new one
  /// either way, which gives fewer errors that follow from the first.
  bool Declare(const std::string& name, const Symbol& symbol, Symbol* existing);
  [[nodiscard]] const Symbol* Find(const std::string& name) const;
  [[nodiscard]] std::vector<std::string> VariableNames() const;
  [[nodiscard]] bool is_global() const { return scopes_.size() == 1; }

 private:
  std::vector<std::unordered_map<std::string, Symbol>> scopes_;
};

}  // namespace burin::fx

// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/semantics/portability.h"

#include "fx_parser/semantics/walk.h"

namespace burin::fx {
namespace {

/// What one expression of `function` cannot do here; functions that it calls go to `called`.
std::string Reason(const ast::Expression& e, const ast::Function& function, std::vector<const ast::Function*>& called) {
  if (std::holds_alternative<ast::AsmBlock>(e.node)) return "asm in function '" + function.name + "'";
  const auto* call = std::get_if<ast::Call>(&e.node);
  if (call == nullptr) return {};
  if (call->function != nullptr) called.push_back(call->function);
  if (call->object == nullptr || call->method >= 0) return {};
  const bool is_interface = call->object->type.kind == TypeKind::kStruct;
  const std::string what =
      is_interface ? "calls a struct's function '" + call->name + "'" : "uses '" + call->name + "' of shader model 4";
  return "function '" + function.name + "' " + what;
}

}  // namespace

std::string Unportable(const ast::Function& function, const Checker& checker) {
  std::set<const ast::Function*> seen;
  std::vector<const ast::Function*> pending = {&function};
  std::string reason;
  while (!pending.empty() && reason.empty()) {
    const ast::Function* definition = checker.Definition(*pending.back());
    pending.pop_back();
    if (definition == nullptr || !seen.insert(definition).second) continue;
    ForEachExpression(*definition->body, [&](const ast::Expression& e) {
      if (reason.empty()) reason = Reason(e, *definition, pending);
    });
  }
  return reason;
}

}  // namespace burin::fx

// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/semantics/overload.h"

#include "fx_parser/semantics/conversion.h"

namespace burin::fx {
namespace {

/// -1 when `function` cannot be called so.
int Cost(const ast::Function& function, std::span<const Type> arguments) {
  if (arguments.size() > function.parameters.size()) return -1;
  int cost = 0;
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    const ast::Variable& parameter = *function.parameters[i];
    if (i >= arguments.size()) {
      if (parameter.initializer == nullptr) return -1;
      continue;
    }
    const bool is_out = (parameter.qualifiers & ast::kOut) != 0;
    const bool is_in = !is_out || (parameter.qualifiers & ast::kIn) != 0;
    if (is_in) {
      const auto in = ImplicitConversion(arguments[i], parameter.type);
      if (!in) return -1;
      cost += in->cost;
    }
    if (is_out) {
      const auto out = ImplicitConversion(parameter.type, arguments[i]);
      if (!out) return -1;
      cost += out->cost;
    }
  }
  return cost;
}

}  // namespace

OverloadChoice ChooseOverload(const std::vector<ast::Function*>& candidates, std::span<const Type> arguments) {
  OverloadChoice choice;
  int best = -1;
  for (ast::Function* candidate : candidates) {
    const int cost = Cost(*candidate, arguments);
    if (cost < 0) continue;
    if (best < 0 || cost < best) {
      choice = {candidate, false};
      best = cost;
    } else if (cost == best && !SameParameters(*candidate, *choice.function)) {
      choice.ambiguous = true;
    }
  }
  return choice;
}

bool SameParameters(const ast::Function& a, const ast::Function& b) {
  if (a.parameters.size() != b.parameters.size()) return false;
  for (std::size_t i = 0; i < a.parameters.size(); ++i) {
    if (!SameType(a.parameters[i]->type, b.parameters[i]->type)) return false;
  }
  return true;
}

}  // namespace burin::fx

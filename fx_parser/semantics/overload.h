// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "fx_parser/syntax/ast.h"

namespace burin::fx {

struct OverloadChoice {
  ast::Function* function = nullptr;  ///< null when none takes the arguments
  bool ambiguous = false;             ///< another one fits as well
};

/// The candidate whose parameters need the cheapest conversions. Parameters with initialisers may be left out.
[[nodiscard]] OverloadChoice ChooseOverload(const std::vector<ast::Function*>& candidates,
                                            std::span<const Type> arguments);

/// Whether two functions have the same parameter types, so that one redeclares the other.
[[nodiscard]] bool SameParameters(const ast::Function& a, const ast::Function& b);

}  // namespace burin::fx

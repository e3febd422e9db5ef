// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fx_parser/source/diagnostic.h"
#include "fx_parser/syntax/macro_expander.h"
#include "fx_parser/syntax/token.h"

namespace burin::fx {

/// Evaluates the expression of an #if or #elif over 64-bit integers; a name that is no macro counts as 0 (and `true`
/// as 1). A fault is reported and counts as false. `directive` is where a fault of the whole line is shown.
[[nodiscard]] bool EvaluateCondition(MacroContext& context, const std::vector<Token>& line, const Token& directive);

}  // namespace burin::fx

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fx_parser/syntax/ast.h"

namespace burin::fx {

/// One more than the height of the highest operand.
[[nodiscard]] int HeightOf(const ast::Expression& expression);

}  // namespace burin::fx

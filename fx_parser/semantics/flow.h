// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fx_parser/syntax/ast.h"

namespace burin::fx {

/// Whether every way through the statement ends in a return. Loops may run zero times; discard goes on, as it does in
/// Direct3D 9.
[[nodiscard]] bool AlwaysReturns(const ast::Statement& statement);

/// Whether any return stands in it.
[[nodiscard]] bool HasReturn(const ast::Statement& statement);

}  // namespace burin::fx

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "fx_parser/semantics/checker.h"

namespace burin::fx {

/// Why no shader of ours can do what this function and those it calls do, in words that go behind a pass's name: asm
/// inside a function, methods that shader models 1 to 3 have not, functions of Cg's interfaces. Empty when nothing of
/// that kind is there. The module must have been checked without errors.
[[nodiscard]] std::string Unportable(const ast::Function& function, const Checker& checker);

}  // namespace burin::fx

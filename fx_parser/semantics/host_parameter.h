// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fx_parser/syntax/ast.h"

namespace burin::fx {

/// Whether a global's value comes from the host as the shaders run. `const` without `static` is only the shaders'
/// promise not to write it; tables of constants among them stay constants, which shaders read faster.
[[nodiscard]] inline bool IsHostParameter(const ast::Variable& global) {
  if ((global.qualifiers & ast::kStatic) != 0) return false;
  return (global.qualifiers & ast::kConst) == 0 || (!global.type.is_array() && global.type.kind == TypeKind::kNumeric);
}

}  // namespace burin::fx

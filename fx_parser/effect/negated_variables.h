// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>

#include "fx_parser/syntax/ast.h"

namespace burin::fx {

/// The variables that stand behind a minus sign somewhere in a function: `-lightDir`, `-normalize(lightDir)`,
/// `dot(n, -mul(lightDir, m))`. Shaders light by the direction towards the light, so one that negates a light's
/// direction was given the other.
[[nodiscard]] std::set<const ast::Variable*> NegatedVariables(const ast::Module& module);

}  // namespace burin::fx

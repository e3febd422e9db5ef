// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/fx_parser.h"

#include "fx_parser/effect/builder.h"
#include "fx_parser/glsl/names.h"
#include "fx_parser/semantics/constant.h"
#include "fx_parser/syntax/parse.h"

namespace burin::fx {

CompileResult CompileEffect(const std::string& path, const FileSystem& files, const Options& options) {
  CompileResult result;
  Diagnostics diagnostics;
  auto module = std::make_shared<ast::Module>(
      Parse(path, files, PreprocessOptions{options.include_folders, options.definitions}, result.sources, diagnostics));
  const bool parsed = !diagnostics.has_errors();
  if (!diagnostics.exhausted()) {
    Checker checker(*module, !parsed, diagnostics);
    checker.CheckModule();
    // Texture names and states are checked beside type errors; only GLSL needs sound functions. Not after syntax
    // errors: what is missing then may only be what did not parse.
    if (parsed && !diagnostics.exhausted()) {
      Effect effect;
      effect.path = path;
      EffectBuilder(checker, *module, options.attributes, effect).Build(!diagnostics.has_errors());
      effect.module = module;
      if (!diagnostics.has_errors()) result.effect = std::move(effect);
    }
  }
  result.diagnostics = diagnostics.Take();
  return result;
}

std::optional<Value> EvaluateExpression(const Effect& effect, const ast::Expression& expression,
                                        const ParameterLookup& lookup) {
  const VariableLookup by_variable = [&](const ast::Variable& variable) -> const Value* {
    if (!variable.is_global) return nullptr;
    for (std::size_t i = 0; i < effect.parameters.size(); ++i) {
      if (effect.parameters[i].name == PublicName(variable.name)) return &lookup(i);
    }
    return nullptr;
  };
  return Evaluate(expression, by_variable);
}

}  // namespace burin::fx

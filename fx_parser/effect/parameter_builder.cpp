// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/effect/builder.h"
#include "fx_parser/effect/case.h"
#include "fx_parser/effect/negated_variables.h"
#include "fx_parser/semantics/constant.h"
#include "fx_parser/semantics/conversion.h"
#include "fx_parser/semantics/host_parameter.h"
#include "fx_parser/semantics/walk.h"

namespace burin::fx {

EffectBuilder::EffectBuilder(Checker& checker, const ast::Module& module, std::vector<std::string> attributes,
                             Effect& effect)
    : checker_(checker),
      diagnostics_(checker.diagnostics()),
      attributes_(std::move(attributes)),
      effect_(effect),
      written_(WrittenVariables(module)),
      negated_(NegatedVariables(module)) {
  for (std::string& attribute : attributes_) attribute = LowerCase(attribute);
}

void EffectBuilder::Build(bool write_programs) {
  write_programs_ = write_programs;
  BuildParameters();
  BuildTextures();
  BuildSamplers();
  BuildTechniques();
  BuildScripts();
  ResolveDimensions();
  BuildProceduralTextures();
}

std::vector<EffectAnnotation> EffectBuilder::BuildAnnotations(std::vector<ast::Annotation>& annotations) {
  std::vector<EffectAnnotation> result;
  for (ast::Annotation& annotation : annotations) {
    const bool is_untyped = annotation.type.name.empty() && annotation.value != nullptr;
    const Type type = is_untyped
                          ? checker_.CheckExpression(*annotation.value)
                          : checker_.ResolveArrayType(annotation.type, annotation.array_sizes, annotation.value.get());
    if (type.kind == TypeKind::kError) continue;
    Value value = ZeroValue(type);
    if (annotation.value != nullptr) {
      const int errors = diagnostics_.error_count();
      checker_.CheckInitializer(*annotation.value, type, annotation.name);
      if (diagnostics_.error_count() != errors) continue;
      if (auto constant = EvaluateAs(*annotation.value, type)) {
        value = std::move(*constant);
      } else {
        diagnostics_.Error(annotation.value->range, "X3011",
                           "'" + annotation.name + "': initial value must be a literal expression");
        continue;
      }
    }
    result.push_back({annotation.name, std::move(value)});
  }
  return result;
}

Value EffectBuilder::DefaultOf(const ast::Variable& variable) const {
  if (variable.initializer != nullptr) {
    if (auto value = EvaluateAs(*variable.initializer, variable.type)) return *value;
  }
  return ZeroValue(variable.type);
}

void EffectBuilder::BuildParameters() {
  for (ast::Variable* variable : checker_.globals()) {
    const TypeKind kind = variable->type.kind;
    if (kind != TypeKind::kNumeric && kind != TypeKind::kString && kind != TypeKind::kStruct) continue;
    const bool holds_values = kind == TypeKind::kString || FlatComponents(variable->type) > 0;
    if (!IsHostParameter(*variable) || !holds_values) continue;
    Parameter parameter;
    parameter.name = PublicName(variable->name);
    parameter.type = variable->type;
    parameter.semantic = variable->semantic;
    parameter.annotations = BuildAnnotations(variable->annotations);
    parameter.has_default = variable->initializer != nullptr;
    parameter.default_value = DefaultOf(*variable);
    parameter.is_negated = negated_.contains(variable);
    parameter.range = variable->range;
    parameters_[variable] = effect_.parameters.size();
    effect_.parameters.push_back(std::move(parameter));
  }
}

}  // namespace burin::fx

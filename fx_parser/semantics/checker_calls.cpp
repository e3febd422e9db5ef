// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/semantics/checker.h"
#include "fx_parser/semantics/conversion.h"
#include "fx_parser/semantics/intrinsics.h"
#include "fx_parser/semantics/methods.h"
#include "fx_parser/semantics/overload.h"

namespace burin::fx {
namespace {

std::string Describe(const ast::Function& function) {
  std::string text = ToString(function.return_type) + " " + function.name + "(";
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    if (i > 0) text += ", ";
    text += ToString(function.parameters[i]->type);
  }
  return text + ")";
}

std::string Types(const std::vector<ast::ExpressionPtr>& arguments) {
  std::string text;
  for (const auto& argument : arguments) text += (text.empty() ? "" : ", ") + ToString(argument->type);
  return text;
}

}  // namespace

void Checker::ReportNoOverload(const ast::Call& call) {
  const bool is_intrinsic = IsIntrinsic(call.name);
  const auto user = functions_.find(call.name);
  if (!is_intrinsic && user == functions_.end()) {
    if (after_syntax_errors_) return;
    std::vector<std::string> names = FunctionNames();
    for (const Intrinsic& intrinsic : Intrinsics()) names.emplace_back(intrinsic.name);
    const std::string near = NearestName(call.name, names);
    diagnostics_.Error(
        call.name_range, "X3004",
        "undeclared identifier '" + call.name + "'" + (near.empty() ? "" : "; did you mean '" + near + "'?"));
    return;
  }
  const std::string kind = user == functions_.end() ? "intrinsic function" : "function";
  Diagnostic& error = diagnostics_.Error(call.name_range, "X3013",
                                         "'" + call.name + "': no matching " + std::to_string(call.arguments.size()) +
                                             " parameter " + kind + " for (" + Types(call.arguments) + ")");
  if (user != functions_.end()) {
    for (const ast::Function* candidate : user->second)
      error.notes.push_back({candidate->range, "candidate: " + Describe(*candidate)});
    return;
  }
  for (const Intrinsic& intrinsic : Intrinsics()) {
    if (intrinsic.name == call.name)
      error.notes.push_back({call.name_range, "candidate: " + DescribeIntrinsic(intrinsic)});
  }
}

Type Checker::CheckUserCall(ast::Expression& e, ast::Call& call, const std::vector<Type>& types) {
  const OverloadChoice choice = ChooseOverload(functions_[call.name], types);
  if (choice.ambiguous) {
    Diagnostic& error = diagnostics_.Error(e.range, "X3067", "'" + call.name + "': ambiguous function call");
    for (const ast::Function* candidate : functions_[call.name])
      error.notes.push_back({candidate->range, "candidate: " + Describe(*candidate)});
    return Type{};
  }
  call.function = choice.function;
  if (current_ != nullptr) calls_[current_].insert(choice.function);
  for (std::size_t i = 0; i < call.arguments.size(); ++i) {
    const ast::Variable& parameter = *choice.function->parameters[i];
    const bool is_out = (parameter.qualifiers & ast::kOut) != 0;
    if (is_out && !RequireLvalue(*call.arguments[i])) return Type{};
    if (!is_out) WarnTruncation(*call.arguments[i], parameter.type);
  }
  return choice.function->return_type;
}

Type Checker::CheckIntrinsicCall(ast::Expression&, ast::Call& call, const std::vector<Type>& types) {
  const Intrinsic& intrinsic = Intrinsics()[static_cast<std::size_t>(call.intrinsic)];
  const auto resolved = ResolveIntrinsic(intrinsic, types);
  for (std::size_t i = 0; i < call.arguments.size(); ++i) {
    if (resolved->is_out[i]) {
      if (!RequireLvalue(*call.arguments[i])) return Type{};
    } else if (call.arguments[i]->type.is_numeric() && resolved->parameters[i].is_numeric()) {
      WarnTruncation(*call.arguments[i], WithScalar(resolved->parameters[i], call.arguments[i]->type.scalar));
    }
  }
  return resolved->result;
}

Type Checker::CheckMethodCall(ast::Call& call, const std::vector<Type>& types) {
  const Type& object = call.object->type;
  if (object.kind == TypeKind::kStruct && !object.is_array() && object.structure != nullptr) {
    for (const auto& method : object.structure->methods) {
      if (method->name == call.name && method->parameters.size() == types.size()) return method->return_type;
    }
  } else if (object.kind == TypeKind::kTexture || object.kind == TypeKind::kObject) {
    call.method = FindMethod(object, call.name, types);
    if (call.method >= 0) {
      const auto resolved = ResolveIntrinsic(Methods()[static_cast<std::size_t>(call.method)], types);
      for (std::size_t i = 1; i < types.size(); ++i) WarnTruncation(*call.arguments[i], resolved->parameters[i]);
      return TextureElement(object);
    }
    if (const auto result = ForeignMethod(object, call.name)) return *result;
  }
  diagnostics_.Error(call.name_range, "X3018",
                     "'" + ToString(object) + "' has no function '" + call.name + "' that takes (" +
                         Types(call.arguments) + ")");
  return Type{};
}

Type Checker::Check(ast::Expression& e, ast::Call& call) {
  std::vector<Type> types;
  bool failed = call.object != nullptr && CheckExpression(call.object).kind == TypeKind::kError;
  for (auto& argument : call.arguments) {
    types.push_back(CheckExpression(argument));
    failed = failed || types.back().kind == TypeKind::kError;
  }
  if (failed) return Type{};
  if (call.object != nullptr) return CheckMethodCall(call, types);
  const auto user = functions_.find(call.name);
  if (user != functions_.end() && ChooseOverload(user->second, types).function != nullptr)
    return CheckUserCall(e, call, types);
  call.intrinsic = FindIntrinsic(call.name, types);
  if (call.intrinsic >= 0) return CheckIntrinsicCall(e, call, types);
  ReportNoOverload(call);
  return Type{};
}

}  // namespace burin::fx

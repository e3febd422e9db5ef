// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/semantics/checker.h"
#include "fx_parser/semantics/conversion.h"
#include "fx_parser/semantics/intrinsics.h"
#include "fx_parser/semantics/methods.h"
#include "fx_parser/semantics/overload.h"
#include "fx_parser/syntax/builtin_types.h"
#include "fx_parser/syntax/glsl_words.h"

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

/// Among functions, intrinsics and the types that construct.
std::string Checker::NearestFunction(const std::string& name) const {
  if (const std::string_view word = HlslWordFor(name); !word.empty()) return std::string(word);
  std::vector<std::string> names = FunctionNames();
  for (const Intrinsic& intrinsic : Intrinsics()) names.emplace_back(intrinsic.name);
  for (std::string& type : BuiltinTypeNames()) names.push_back(std::move(type));
  return NearestName(name, names);
}

/// The declaration of `name` at file scope behind `use`; null when there is none.
const Range* Checker::FindLater(const std::string& name, const Location& use) const {
  const auto is_it = [&](const auto& declaration) {
    const Location& at = declaration.range.begin;
    const bool before = at.file == use.file && std::pair(at.line, at.column) < std::pair(use.line, use.column);
    return declaration.name == name && !before;
  };
  for (const auto& declaration : module_.declarations) {
    if (const auto* variable = std::get_if<std::unique_ptr<ast::Variable>>(&declaration)) {
      if (is_it(**variable)) return &(*variable)->range;
    } else if (const auto* function = std::get_if<std::unique_ptr<ast::Function>>(&declaration)) {
      if (is_it(**function)) return &(*function)->range;
    }
  }
  return nullptr;
}

void Checker::ReportUndeclared(const std::string& name, const Range& range, const std::string& near) {
  const Range* later = FindLater(name, range.begin);
  const std::string hint = later != nullptr || near.empty() ? "" : "; did you mean '" + near + "'?";
  Diagnostic& error = diagnostics_.Error(range, "X3004", "undeclared identifier '" + name + "'" + hint);
  if (later != nullptr) error.notes.push_back({*later, "'" + name + "' is declared here, after its use"});
}

void Checker::ReportNoOverload(const ast::Call& call) {
  const bool is_intrinsic = IsIntrinsic(call.name);
  const auto user = functions_.find(call.name);
  if (!is_intrinsic && user == functions_.end()) {
    if (!after_syntax_errors_) ReportUndeclared(call.name, call.name_range, NearestFunction(call.name));
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
    if (intrinsic.name == call.name) error.notes.push_back({{}, "candidate: " + DescribeIntrinsic(intrinsic)});
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
  diagnostics_.Error(
      call.name_range, "X3018",
      "'" + ToString(object) + "' has no function '" + call.name + "' that takes (" + Types(call.arguments) + ")");
  return Type{};
}

Type Checker::Check(ast::Expression& e, ast::Call& call) {
  std::vector<Type> types;
  bool failed = call.object != nullptr && CheckExpression(call.object).kind == TypeKind::kError;
  for (auto& argument : call.arguments) {
    types.push_back(CheckExpression(argument));
    failed = failed || types.back().kind == TypeKind::kError;
  }
  const bool is_known = call.object != nullptr || IsIntrinsic(call.name) || functions_.contains(call.name);
  if (failed && !is_known) ReportNoOverload(call);
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

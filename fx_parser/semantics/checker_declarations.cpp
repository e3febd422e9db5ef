// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "fx_parser/semantics/checker.h"
#include "fx_parser/semantics/constant.h"
#include "fx_parser/semantics/conversion.h"
#include "fx_parser/semantics/flow.h"
#include "fx_parser/semantics/overload.h"

namespace burin::fx {

Checker::Checker(ast::Module& module, bool after_syntax_errors, Diagnostics& diagnostics)
    : module_(module), diagnostics_(diagnostics), after_syntax_errors_(after_syntax_errors) {}

void Checker::CheckModule() {
  for (auto& declaration : module_.declarations) {
    if (diagnostics_.exhausted()) return;
    if (auto* structure = std::get_if<std::unique_ptr<ast::Struct>>(&declaration))
      CheckStruct(**structure);
    else if (auto* alias = std::get_if<std::unique_ptr<ast::Typedef>>(&declaration))
      CheckTypedef(**alias);
    else if (auto* variable = std::get_if<std::unique_ptr<ast::Variable>>(&declaration))
      CheckGlobal(**variable);
    else if (auto* function = std::get_if<std::unique_ptr<ast::Function>>(&declaration))
      CheckFunction(**function);
    else if (auto* technique = std::get_if<std::unique_ptr<ast::Technique>>(&declaration))
      techniques_.push_back(technique->get());
  }
  CheckRecursion();
}

ast::Variable* Checker::FindGlobal(const std::string& name) const {
  const Symbol* symbol = scopes_.Find(name);
  return symbol != nullptr ? symbol->variable : nullptr;
}

std::vector<const ast::Function*> Checker::FindFunctions(const std::string& name) const {
  std::vector<const ast::Function*> found;
  if (const auto at = functions_.find(name); at != functions_.end()) {
    for (const ast::Function* function : at->second) {
      if (function->body != nullptr) found.push_back(function);
    }
  }
  return found;
}

std::vector<std::string> Checker::FunctionNames() const {
  std::vector<std::string> names;
  for (const auto& [name, overloads] : functions_) names.push_back(name);
  return names;
}

const ast::Function* Checker::Definition(const ast::Function& function) const {
  if (function.body != nullptr) return &function;
  for (const ast::Function* candidate : FindFunctions(function.name)) {
    if (SameParameters(*candidate, function)) return candidate;
  }
  return nullptr;
}

void Checker::ReportRedefinition(const std::string& name, const Range& range, const Range* previous) {
  Diagnostic& error = diagnostics_.Error(range, "X3003", "redefinition of '" + name + "'");
  if (previous != nullptr) error.notes.push_back({*previous, "'" + name + "' was defined here"});
}

Type Checker::ResolveType(ast::TypeName& name) {
  if (name.type.kind == TypeKind::kStruct && name.type.structure == nullptr) {
    const Symbol* symbol = scopes_.Find(name.name);
    if (symbol != nullptr && symbol->structure != nullptr) {
      name.type.structure = symbol->structure;
    } else if (symbol != nullptr && symbol->alias != nullptr) {
      const bool row_major = name.type.row_major;
      name.type = symbol->type;
      name.type.row_major = name.type.row_major || row_major;
    } else {
      if (!after_syntax_errors_)
        diagnostics_.Error(name.range, "X3000", "unrecognized identifier '" + name.name + "': a type was expected");
      name.type = Type{};
    }
  }
  return name.type;
}

Type Checker::ResolveArrayType(ast::TypeName& name, std::vector<ast::ExpressionPtr>& sizes,
                               const ast::Expression* initializer) {
  Type type = ResolveType(name);
  if (sizes.empty() || type.kind == TypeKind::kError) return type;
  const Type element = type;
  std::vector<std::uint32_t> array;
  for (auto& size : sizes) {
    if (size == nullptr) {
      // [] takes its size from the initialiser.
      const auto* list = initializer != nullptr ? std::get_if<ast::InitializerList>(&initializer->node) : nullptr;
      if (list == nullptr && array.empty() && scopes_.is_global() && initializer == nullptr && current_ == nullptr &&
          element.kind == TypeKind::kStruct) {
        diagnostics_.Warning(name.range, "B1025",
                             "an array without a size gets it from a host, which this one has no means to choose: it "
                             "has one element");
        array.push_back(1);
        continue;
      }
      if (list == nullptr || !array.empty()) {
        diagnostics_.Error(name.range, "X3058", "array dimensions must be explicit");
        return Type{};
      }
      array.push_back(static_cast<std::uint32_t>(list->elements.size()));
      continue;
    }
    const Type size_type = CheckExpression(size);
    if (size_type.kind == TypeKind::kError) return Type{};
    const auto value = size_type.is_numeric() ? Evaluate(*size) : std::nullopt;
    if (!value || value->numbers.size() != 1) {
      diagnostics_.Error(size->range, "X3058", "array dimensions must be literal scalar expressions");
      return Type{};
    }
    const double count = value->numbers[0];
    if (!(count >= 1) || count > 65536) {
      diagnostics_.Error(size->range, "X3059", "array dimension must be between 1 and 65536");
      return Type{};
    }
    array.push_back(static_cast<std::uint32_t>(count));
  }
  // `typedef float4 F[2]; F x[3];` is three of two.
  type.array.insert(type.array.begin(), array.begin(), array.end());
  const bool is_struct = element.kind == TypeKind::kStruct && element.structure != nullptr;
  long components = std::max(FlatComponents(element), is_struct ? element.structure->leaves : 1L);
  for (const std::uint32_t size : type.array) {
    components *= size;
    if (components > kMaxVariableComponents) {
      diagnostics_.Error(name.range, "X3059",
                         "array has more than " + std::to_string(kMaxVariableComponents) + " components");
      return Type{};
    }
  }
  return type;
}

/// Fills in what it counts; what is too large or too deep loses its members after the error.
void Checker::MeasureStruct(ast::Struct& structure) {
  long leaves = 0;  // an empty struct is one too, or a few lines could ask for no end of them
  bool is_numeric = true;
  structure.components = 0;
  for (const auto& member : structure.members) {
    const Type& type = member->type;
    const bool is_struct = type.kind == TypeKind::kStruct && type.structure != nullptr;
    const long own = FlatComponents(type);
    long elements = 1;
    for (const std::uint32_t size : type.array) elements *= size;
    leaves += std::max(own, elements * (is_struct ? std::max(type.structure->leaves, 1L) : 1L));
    is_numeric = is_numeric && own >= 0;
    structure.components += std::max(own, 0L);
    if (is_struct) structure.depth = std::max(structure.depth, type.structure->depth + 1);
    if (leaves > kMaxVariableComponents) break;
  }
  structure.leaves = std::max(leaves, 1L);
  if (!is_numeric) structure.components = -1;
  const bool too_deep = structure.depth > kMaxStructDepth;
  if (leaves <= kMaxVariableComponents && !too_deep) return;
  diagnostics_.Error(structure.range, too_deep ? "B1201" : "X3059",
                     too_deep ? "structs are nested more than " + std::to_string(kMaxStructDepth) + " levels deep"
                              : "struct has more than " + std::to_string(kMaxVariableComponents) + " components");
  structure.members.clear();
  structure.components = 0;
  structure.leaves = 1;
  structure.depth = 1;
}

void Checker::CheckStruct(ast::Struct& structure) {
  std::map<std::string, const ast::Variable*> names;
  for (auto& member : structure.members) {
    member->type = ResolveArrayType(member->type_name, member->array_sizes, nullptr);
    if (member->type.kind == TypeKind::kStruct && member->type.structure == &structure) {
      diagnostics_.Error(member->range, "X3000", "struct '" + structure.name + "' contains itself");
      member->type = Type{};
    }
    if (member->type.kind == TypeKind::kVoid) {
      diagnostics_.Error(member->range, "X3038", "'" + member->name + "': variable type cannot be 'void'");
      member->type = Type{};
    }
    const auto [at, inserted] = names.emplace(member->name, member.get());
    if (!inserted) ReportRedefinition(member->name, member->range, &at->second->range);
  }
  for (auto& method : structure.methods) {
    method->return_type = ResolveType(method->return_type_name);
    DeclareParameters(*method);
  }
  MeasureStruct(structure);
  if (structure.name.empty()) return;
  Symbol symbol;
  symbol.structure = &structure;
  Symbol existing;
  if (!scopes_.Declare(structure.name, symbol, &existing)) {
    ReportRedefinition(structure.name, structure.range,
                       existing.structure != nullptr ? &existing.structure->range : nullptr);
  }
}

void Checker::CheckTypedef(ast::Typedef& alias) {
  Symbol symbol;
  symbol.alias = &alias;
  symbol.type = ResolveArrayType(alias.type_name, alias.array_sizes, nullptr);
  Symbol existing;
  if (!scopes_.Declare(alias.name, symbol, &existing) &&
      !(existing.alias != nullptr && SameType(existing.type, symbol.type))) {
    ReportRedefinition(alias.name, alias.range, existing.alias != nullptr ? &existing.alias->range : nullptr);
  }
}

void Checker::DeclareVariable(ast::Variable& variable) {
  if (variable.name.empty()) return;
  Symbol symbol;
  symbol.variable = &variable;
  Symbol existing;
  if (!scopes_.Declare(variable.name, symbol, &existing)) {
    ReportRedefinition(variable.name, variable.range,
                       existing.variable != nullptr ? &existing.variable->range : nullptr);
  }
}

void Checker::CheckGlobal(ast::Variable& variable) {
  variable.type = ResolveArrayType(variable.type_name, variable.array_sizes, variable.initializer.get());
  if (variable.type.kind == TypeKind::kVoid) {
    diagnostics_.Error(variable.range, "X3038",
                       "'" + variable.name + "': global variables cannot be declared as 'void'");
    variable.type = Type{};
  }
  const bool is_const = (variable.qualifiers & ast::kConst) != 0;
  const bool is_static = (variable.qualifiers & ast::kStatic) != 0;
  if (is_const && is_static && variable.initializer == nullptr) {
    diagnostics_.Error(variable.range, "X3012", "'" + variable.name + "': missing initial value");
  }
  // The initialiser is checked first: `float x = x;` does not see itself.
  if (variable.initializer != nullptr && variable.type.kind != TypeKind::kError) {
    const bool is_interface = variable.type.structure != nullptr && variable.type.structure->is_interface;
    const bool has_value = variable.type.kind == TypeKind::kNumeric || variable.type.kind == TypeKind::kStruct ||
                           variable.type.kind == TypeKind::kString;
    if (has_value && !is_interface) {
      const int errors = diagnostics_.error_count();
      CheckInitializer(*variable.initializer, variable.type, variable.name);
      if (!is_static && diagnostics_.error_count() == errors && !EvaluateAs(*variable.initializer, variable.type)) {
        // As if it were static: then it follows what it is computed from.
        diagnostics_.Warning(variable.initializer->range, "X3011",
                             "'" + variable.name +
                                 "': the initial value is no literal expression, so shaders compute it and it is no "
                                 "parameter");
        variable.qualifiers |= ast::kStatic;
      }
    }
  }
  DeclareVariable(variable);
  globals_.push_back(&variable);
}

void Checker::DeclareFunction(ast::Function& function) {
  auto& overloads = functions_[function.name];
  for (const ast::Function* other : overloads) {
    if (!SameParameters(*other, function)) continue;
    if (other->body != nullptr && function.body != nullptr)
      ReportRedefinition(function.name, function.range, &other->range);
    else if (!SameType(other->return_type, function.return_type)) {
      diagnostics_
          .Error(function.range, "X3096", "'" + function.name + "': function return value differs from prototype")
          .notes.push_back({other->range, "the prototype is here"});
    }
  }
  overloads.push_back(&function);
}

void Checker::DeclareParameters(ast::Function& function) {
  for (auto& parameter : function.parameters) {
    parameter->type = ResolveArrayType(parameter->type_name, parameter->array_sizes, nullptr);
    if (parameter->type.kind == TypeKind::kVoid) {
      diagnostics_.Error(parameter->range, "X3038", "'" + parameter->name + "': parameter type cannot be 'void'");
      parameter->type = Type{};
    }
    if (parameter->initializer != nullptr) CheckInitializer(*parameter->initializer, parameter->type, parameter->name);
  }
}

void Checker::CheckFunction(ast::Function& function) {
  function.return_type = ResolveType(function.return_type_name);
  DeclareParameters(function);
  DeclareFunction(function);
  if (function.body == nullptr) return;
  const int errors = diagnostics_.error_count();
  current_ = &function;
  scopes_.Push();
  for (auto& parameter : function.parameters) DeclareVariable(*parameter);
  if (auto* block = std::get_if<ast::Block>(&function.body->node)) {
    CheckStatements(block->statements);
  } else {
    CheckStatement(*function.body);
  }
  scopes_.Pop();
  current_ = nullptr;
  if (function.return_type.kind == TypeKind::kVoid || function.return_type.kind == TypeKind::kError) return;
  // After a syntax error the return may be what did not parse.
  if (after_syntax_errors_ || diagnostics_.error_count() != errors || AlwaysReturns(*function.body)) return;
  if (HasReturn(*function.body)) {
    diagnostics_.Error(function.range, "X3507", "'" + function.name + "': not all control paths return a value");
  } else {
    diagnostics_.Error(function.range, "X3080", "'" + function.name + "': function must return a value");
  }
}

/// Depth first with a stack of its own: a file may hold a chain of calls as long as it has functions.
bool Checker::ReportCycle(const ast::Function& start, std::set<const ast::Function*>& done) {
  struct Frame {
    const ast::Function* function;
    std::vector<const ast::Function*> callees;
  };
  std::vector<Frame> stack;
  std::set<const ast::Function*> open;
  const auto enter = [&](const ast::Function& function) {
    const auto& calls = calls_[&function];
    stack.push_back({&function, {calls.begin(), calls.end()}});
    open.insert(&function);
    done.insert(&function);
  };
  enter(start);
  while (!stack.empty()) {
    Frame& frame = stack.back();
    if (frame.callees.empty()) {
      open.erase(frame.function);
      stack.pop_back();
      continue;
    }
    const ast::Function* callee = Definition(*frame.callees.back());
    frame.callees.pop_back();
    if (callee == nullptr) continue;
    if (open.contains(callee)) {
      std::vector<const ast::Function*> cycle;
      for (auto at = stack.rbegin(); at != stack.rend(); ++at) {
        cycle.insert(cycle.begin(), at->function);
        if (at->function == callee) break;
      }
      ReportCycle(cycle);
      return true;
    }
    if (!done.contains(callee)) enter(*callee);
  }
  return false;
}

void Checker::ReportCycle(const std::vector<const ast::Function*>& cycle) {
  Diagnostic& error = diagnostics_.Error(cycle.front()->range, "X3500",
                                         "'" + cycle.front()->name + "': recursive functions are not allowed");
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    const ast::Function* next = cycle[(i + 1) % cycle.size()];
    error.notes.push_back({cycle[i]->range, "'" + cycle[i]->name + "' calls '" + next->name + "'"});
  }
}

void Checker::CheckRecursion() {
  std::set<const ast::Function*> done;
  for (const auto& [name, overloads] : functions_) {
    for (const ast::Function* function : overloads) {
      if (function->body != nullptr && !done.contains(function) && ReportCycle(*function, done)) return;
    }
  }
}

}  // namespace burin::fx

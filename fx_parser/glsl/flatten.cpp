// SPDX-License-Identifier: Apache-2.0
// Branches that take derivatives in some invocations only. GLSL leaves those undefined; Direct3D 9's compilers evaluate
// both sides and keep one. Here: both branches run, on saved copies of what they write, where they hold nothing but
// computation. Branches that return, break or discard stay as they are, and so do those that all invocations take
// alike.
#include <algorithm>
#include <set>

#include "fx_parser/glsl/function_writer.h"
#include "fx_parser/semantics/constant.h"
#include "fx_parser/semantics/methods.h"
#include "fx_parser/semantics/walk.h"

namespace burin::fx {
namespace {

struct Traits {
  bool derivatives = false;
  bool effects = false;  ///< writes a global or discards, inside a called function
};

/// What evaluating an expression can do, through the functions it calls.
class TraitFinder {
 public:
  explicit TraitFinder(const Checker& checker) : checker_(checker) {}

  void Add(const ast::Expression& e) {
    AddOwn(e);
    while (!pending_.empty()) {  // not by recursion: chains of calls may be as long as the file
      const ast::Function* definition = checker_.Definition(*pending_.back());
      pending_.pop_back();
      if (definition == nullptr || !seen_.insert(definition).second) continue;
      found.effects = found.effects || HasDiscard(*definition->body);
      ForEachExpression(*definition->body, [&](const ast::Expression& inner) {
        std::set<const ast::Variable*> written;
        AppendWritten(inner, written);
        found.effects =
            found.effects || std::ranges::any_of(written, [](const ast::Variable* v) { return v->is_global; });
        AddOwn(inner);
      });
    }
  }

  static bool HasDiscard(const ast::Statement& statement) {
    if (std::holds_alternative<ast::Discard>(statement.node)) return true;
    const auto has = [](const ast::StatementPtr& s) { return s != nullptr && HasDiscard(*s); };
    if (const auto* block = std::get_if<ast::Block>(&statement.node))
      return std::ranges::any_of(block->statements, has);
    if (const auto* branch = std::get_if<ast::If>(&statement.node))
      return has(branch->then_branch) || has(branch->else_branch);
    if (const auto* loop = std::get_if<ast::For>(&statement.node)) return has(loop->body);
    if (const auto* loop = std::get_if<ast::While>(&statement.node)) return has(loop->body);
    if (const auto* loop = std::get_if<ast::DoWhile>(&statement.node)) return has(loop->body);
    if (const auto* choice = std::get_if<ast::Switch>(&statement.node)) {
      return std::ranges::any_of(choice->cases,
                                 [&](const ast::Case& arm) { return std::ranges::any_of(arm.statements, has); });
    }
    return false;
  }

  Traits found;

 private:
  void AddOwn(const ast::Expression& e) {
    const auto* call = std::get_if<ast::Call>(&e.node);
    if (call == nullptr) return;
    if (call->function != nullptr) {
      pending_.push_back(call->function);
      return;
    }
    const unsigned intrinsic = call->method >= 0      ? Methods()[static_cast<std::size_t>(call->method)].traits
                               : call->intrinsic >= 0 ? Intrinsics()[static_cast<std::size_t>(call->intrinsic)].traits
                                                      : 0;
    found.derivatives = found.derivatives || (intrinsic & kImplicitDerivatives) != 0;
    found.effects = found.effects || call->name == "clip";
  }

  const Checker& checker_;
  std::set<const ast::Function*> seen_;
  std::vector<const ast::Function*> pending_;
};

/// Only declarations, expressions and branches of them. Loops are left alone: what they do each time round may end
/// them.
bool OnlyComputes(const ast::Statement& statement, std::set<const ast::Variable*>& declared) {
  const auto computes = [&](const ast::StatementPtr& s) { return s == nullptr || OnlyComputes(*s, declared); };
  if (const auto* block = std::get_if<ast::Block>(&statement.node))
    return std::ranges::all_of(block->statements, computes);
  if (const auto* branch = std::get_if<ast::If>(&statement.node))
    return computes(branch->then_branch) && computes(branch->else_branch);
  if (const auto* declaration = std::get_if<ast::DeclarationStatement>(&statement.node)) {
    for (const auto& variable : declaration->variables) declared.insert(variable.get());
    return true;
  }
  return std::holds_alternative<ast::ExpressionStatement>(statement.node);
}

}  // namespace

/// Whether all invocations of a draw see one value: parameters and constants, and what is computed from them.
bool FunctionWriter::IsUniform(const ast::Expression& e) const {
  bool uniform = true;
  ForEachExpression(e, [&](const ast::Expression& inner) {
    if (const auto* name = std::get_if<ast::Name>(&inner.node); name != nullptr && name->variable != nullptr) {
      const ast::Variable& v = *name->variable;
      const bool constant =
          (v.qualifiers & ast::kConst) != 0 && v.initializer != nullptr && Evaluate(*v.initializer).has_value();
      const bool parameter = v.is_global && (v.qualifiers & ast::kStatic) == 0;
      const bool entry_argument = v.is_parameter && (v.qualifiers & ast::kUniform) != 0;
      uniform = uniform && (constant || ((parameter || entry_argument) && !stage_.is_written(v)));
    }
    const auto* call = std::get_if<ast::Call>(&inner.node);
    uniform =
        uniform && (call == nullptr ||
                    (call->function == nullptr && call->intrinsic >= 0 &&
                     LookupDimension(Intrinsics()[static_cast<std::size_t>(call->intrinsic)]) == Dimension::kUnknown));
  });
  return uniform;
}

bool FunctionWriter::Flatten(const ast::If& branch) {
  if (stage_.stage() != Stage::kFragment || branch.then_branch == nullptr || IsUniform(*branch.condition)) return false;
  std::set<const ast::Variable*> declared;
  std::set<const ast::Variable*> written;
  TraitFinder traits(stage_.checker());
  for (const ast::Statement* side : {branch.then_branch.get(), branch.else_branch.get()}) {
    if (side == nullptr) continue;
    if (!OnlyComputes(*side, declared)) return false;
    ForEachExpression(*side, [&](const ast::Expression& e) {
      AppendWritten(e, written);
      traits.Add(e);
    });
  }
  if (!traits.found.derivatives || traits.found.effects) return false;
  struct Saved {
    std::string name;
    std::string before;
    std::string after;
  };
  // In the order of the text, not of addresses: two runs write one text.
  std::vector<const ast::Variable*> order;
  for (const ast::Variable* variable : written) {
    if (!declared.contains(variable)) order.push_back(variable);
  }
  std::ranges::sort(order, {}, [](const ast::Variable* v) {
    return std::tuple(v->range.begin.file, v->range.begin.line, v->range.begin.column, v->name);
  });
  const std::string condition = NewTemporary(ScalarType(Scalar::kBool));
  Line(condition + " = " + Condition(*branch.condition) + ";");
  std::vector<Saved> saved;
  for (const ast::Variable* variable : order) {
    saved.push_back({stage_.VariableName(*variable), NewTemporary(variable->type), NewTemporary(variable->type)});
    Line(saved.back().before + " = " + saved.back().name + ";");
  }
  --indent_;
  Body(branch.then_branch);
  ++indent_;
  for (const Saved& s : saved) {
    Line(s.after + " = " + s.name + ";");
    Line(s.name + " = " + s.before + ";");
  }
  --indent_;
  Body(branch.else_branch);
  ++indent_;
  for (const Saved& s : saved) Line("if (" + condition + ") " + s.name + " = " + s.after + ";");
  return true;
}

}  // namespace burin::fx

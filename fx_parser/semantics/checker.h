// SPDX-License-Identifier: Apache-2.0
#pragma once
// Resolves names, computes types and reports what is wrong, over a whole module. Unused functions are checked too.

#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "fx_parser/semantics/scope.h"
#include "fx_parser/source/diagnostic.h"
#include "fx_parser/syntax/ast.h"

namespace burin::fx {

/// Components that one variable may have: larger arrays are an error, so that products of sizes cannot overflow.
inline constexpr long kMaxVariableComponents = 1 << 20;
inline constexpr int kMaxStructDepth = 64;

class Checker {
 public:
  /// With `after_syntax_errors` unknown names are not reported: their declarations may be what did not parse.
  Checker(ast::Module& module, bool after_syntax_errors, Diagnostics& diagnostics);

  /// Checks every declaration but techniques, whose expressions the effect's builder hands to the functions below.
  void CheckModule();

  /// Types an expression at file scope; kError after a diagnostic.
  Type CheckExpression(ast::Expression& expression);
  /// The same; null, after a syntax error, becomes an expression of type kError.
  Type CheckExpression(ast::ExpressionPtr& expression);
  /// Reports X3017 or X3206 when the conversion is impossible or loses components; false when impossible.
  bool RequireConversion(const ast::Expression& expression, const Type& to);
  /// Types an initialiser, lists included, for a variable of this type.
  void CheckInitializer(ast::Expression& initializer, const Type& type, const std::string& name);
  /// The type of an annotation.
  Type ResolveType(ast::TypeName& name);
  Type ResolveArrayType(ast::TypeName& name, std::vector<ast::ExpressionPtr>& sizes,
                        const ast::Expression* initializer);

  [[nodiscard]] const std::vector<ast::Variable*>& globals() const { return globals_; }
  [[nodiscard]] const std::vector<ast::Technique*>& techniques() const { return techniques_; }
  [[nodiscard]] ast::Variable* FindGlobal(const std::string& name) const;
  /// All overloads by that name that have a body.
  [[nodiscard]] std::vector<const ast::Function*> FindFunctions(const std::string& name) const;
  [[nodiscard]] std::vector<std::string> FunctionNames() const;
  /// The function with the body of this prototype; itself when it has one; null when nobody defines it.
  [[nodiscard]] const ast::Function* Definition(const ast::Function& function) const;
  [[nodiscard]] Diagnostics& diagnostics() { return diagnostics_; }

 private:
  // declarations
  void CheckStruct(ast::Struct& structure);
  void MeasureStruct(ast::Struct& structure);
  void CheckTypedef(ast::Typedef& alias);
  void CheckGlobal(ast::Variable& variable);
  void CheckFunction(ast::Function& function);
  void DeclareParameters(ast::Function& function);
  void DeclareFunction(ast::Function& function);
  void DeclareVariable(ast::Variable& variable);
  void ReportRedefinition(const std::string& name, const Range& range, const Range* previous);
  void CheckRecursion();
  bool ReportCycle(const ast::Function& start, std::set<const ast::Function*>& done);
  void ReportCycle(const std::vector<const ast::Function*>& cycle);

  // statements
  void CheckStatement(ast::Statement& statement);
  void Visit(ast::Block& block, const Range& range);
  void Visit(ast::DeclarationStatement& declaration, const Range& range);
  void Visit(ast::ExpressionStatement& statement, const Range& range);
  void Visit(ast::If& branch, const Range& range);
  void Visit(ast::For& loop, const Range& range);
  void Visit(ast::While& loop, const Range& range);
  void Visit(ast::DoWhile& loop, const Range& range);
  void Visit(ast::Switch& choice, const Range& range);
  void Visit(ast::Return& leave, const Range& range);
  void Visit(ast::Break& leave, const Range& range);
  void Visit(ast::Continue& leave, const Range& range);
  void Visit(ast::Discard& leave, const Range& range);
  void CheckLocal(ast::Variable& variable);
  void CheckCondition(ast::ExpressionPtr& condition, const char* statement);
  void CheckStatements(std::vector<ast::StatementPtr>& statements);
  void CheckBody(ast::Statement& body);

  // expressions
  Type Check(ast::Expression& e, ast::BoolLiteral& literal);
  Type Check(ast::Expression& e, ast::IntLiteral& literal);
  Type Check(ast::Expression& e, ast::FloatLiteral& literal);
  Type Check(ast::Expression& e, ast::StringLiteral& literal);
  Type Check(ast::Expression& e, ast::Name& name);
  Type Check(ast::Expression& e, ast::Unary& unary);
  Type Check(ast::Expression& e, ast::Binary& binary);
  Type Check(ast::Expression& e, ast::Assign& assign);
  Type Check(ast::Expression& e, ast::Conditional& conditional);
  Type Check(ast::Expression& e, ast::Call& call);
  Type Check(ast::Expression& e, ast::Construct& construct);
  Type Check(ast::Expression& e, ast::Cast& cast);
  Type Check(ast::Expression& e, ast::Member& member);
  Type Check(ast::Expression& e, ast::Index& index);
  Type Check(ast::Expression& e, ast::InitializerList& list);
  Type Check(ast::Expression& e, ast::Compile& compile);
  Type Check(ast::Expression& e, ast::AsmBlock& block);
  Type Check(ast::Expression& e, ast::StateBlockExpression& block);
  /// A numeric operand, no array; reports X3022 otherwise.
  bool RequireNumeric(const ast::Expression& operand);
  bool RequireLvalue(const ast::Expression& target);
  void WarnTruncation(const ast::Expression& operand, const Type& to);
  Type CheckUserCall(ast::Expression& e, ast::Call& call, const std::vector<Type>& types);
  Type CheckIntrinsicCall(ast::Expression& e, ast::Call& call, const std::vector<Type>& types);
  Type CheckMethodCall(ast::Call& call, const std::vector<Type>& types);
  void ReportNoOverload(const ast::Call& call);
  /// X3004, with a note where the name is declared further down.
  void ReportUndeclared(const std::string& name, const Range& range, const std::string& near);
  [[nodiscard]] std::string NearestFunction(const std::string& name) const;
  [[nodiscard]] const Range* FindLater(const std::string& name, const Location& use) const;
  /// Flattened components of an initialiser list; -1 after an error in it.
  long CheckListElements(ast::InitializerList& list);

  ast::Module& module_;
  Diagnostics& diagnostics_;
  bool after_syntax_errors_;
  ScopeStack scopes_;
  std::vector<ast::Variable*> globals_;
  std::vector<ast::Technique*> techniques_;
  std::map<std::string, std::vector<ast::Function*>> functions_;
  std::unordered_map<const ast::Function*, std::set<const ast::Function*>> calls_;
  ast::Function* current_ = nullptr;  ///< the function whose body is being checked
  int loop_depth_ = 0;
  int switch_depth_ = 0;
};

}  // namespace burin::fx

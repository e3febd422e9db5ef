// SPDX-License-Identifier: Apache-2.0
#pragma once
// Writes the body of one instance of a function. Expressions become GLSL expressions; what GLSL cannot say in one goes
// through temporaries at the top of the function and the comma operator, so that order and laziness stay as written.

#include <string>
#include <vector>

#include "fx_parser/glsl/stage_writer.h"
#include "fx_parser/semantics/intrinsics.h"
#include "fx_parser/semantics/swizzle.h"

namespace burin::fx {

class FunctionWriter {
 public:
  FunctionWriter(StageWriter& stage, SamplerBindings bindings) : stage_(stage), bindings_(std::move(bindings)) {}

  /// The whole definition.
  std::string Function(const ast::Function& function, const std::string& name);
  /// Statements (for main) that give `name` the initialiser's value, or zero.
  std::string Initialisation(const std::string& name, const Type& type, const ast::Expression* initializer);

  /// An expression of its own type's storage.
  std::string Expression(const ast::Expression& e);
  /// The same converted to `type`; initialiser lists too.
  std::string ExpressionAs(const ast::Expression& e, const Type& type);
  std::string Convert(const std::string& text, const Type& from, const Type& to);
  /// What a sampler expression names; null sampler after an error.
  SamplerBinding ResolveSampler(const ast::Expression& e);
  /// Declarations of the temporaries used so far.
  [[nodiscard]] std::string Temporaries() const { return temporaries_; }
  std::string NewTemporary(const Type& type);

 private:
  /// Something that can be assigned to. `setup` are comma-separated expressions that must run first.
  struct Lvalue {
    std::string setup;
    std::string text;
    Type type;
    Storage storage;                          ///< how it is held, which for int matrices is float
    std::vector<SwizzleComponent> scattered;  ///< components of the matrix `text`, when GLSL has no such swizzle
    Type matrix;                              ///< of `text` when scattered
  };

  // statements
  void Statement(const ast::Statement& statement);
  void Body(const ast::StatementPtr& statement);
  void Write(const ast::Block& block);
  void Write(const ast::DeclarationStatement& declaration);
  void Write(const ast::ExpressionStatement& statement);
  void Write(const ast::If& branch);
  void Write(const ast::For& loop);
  void Write(const ast::While& loop);
  void Write(const ast::DoWhile& loop);
  void Write(const ast::Switch& choice);
  void Write(const ast::Return& leave);
  void Write(const ast::Break& leave);
  void Write(const ast::Continue& leave);
  void Write(const ast::Discard& leave);
  void Line(const std::string& text);
  void Local(const ast::Variable& variable);
  std::string Condition(const ast::Expression& e);
  bool Flatten(const ast::If& branch);
  [[nodiscard]] bool IsUniform(const ast::Expression& e) const;

  // expressions
  std::string Emit(const ast::Expression& e, const ast::BoolLiteral& n);
  std::string Emit(const ast::Expression& e, const ast::IntLiteral& n);
  std::string Emit(const ast::Expression& e, const ast::FloatLiteral& n);
  std::string Emit(const ast::Expression& e, const ast::StringLiteral& n);
  std::string Emit(const ast::Expression& e, const ast::Name& n);
  std::string Emit(const ast::Expression& e, const ast::Unary& n);
  std::string Emit(const ast::Expression& e, const ast::Binary& n);
  std::string Emit(const ast::Expression& e, const ast::Assign& n);
  std::string Emit(const ast::Expression& e, const ast::Conditional& n);
  std::string Emit(const ast::Expression& e, const ast::Call& n);
  std::string Emit(const ast::Expression& e, const ast::Construct& n);
  std::string Emit(const ast::Expression& e, const ast::Cast& n);
  std::string Emit(const ast::Expression& e, const ast::Member& n);
  std::string Emit(const ast::Expression& e, const ast::Index& n);
  std::string Emit(const ast::Expression& e, const ast::InitializerList& n);
  std::string Emit(const ast::Expression& e, const ast::Compile& n);
  std::string Emit(const ast::Expression& e, const ast::AsmBlock& n);
  std::string Emit(const ast::Expression& e, const ast::StateBlockExpression& n);

  // operators
  std::string Arithmetic(ast::BinaryOperator op, const Type& common, const std::string& a, const Type& a_type,
                         const std::string& b, const Type& b_type, bool divisor_is_safe);
  std::string MatrixBits(ast::BinaryOperator op, const Type& type, const std::string& a, const std::string& b);
  std::string Comparison(ast::BinaryOperator op, const Type& common, const std::string& a, const std::string& b);
  std::string Logic(ast::BinaryOperator op, const ast::Binary& n, const Type& result);
  std::string Negated(const Type& type, const std::string& text);
  std::string Prelude(const char* name, const Storage& storage);
  /// Applies a componentwise form to the columns of matrices: `form` gets one text for each operand.
  template <class Form>
  std::string ByColumns(const Type& type, const std::vector<std::string>& operands, const std::vector<Type>& types,
                        Form form);
  std::string MatrixSelect(const Type& type, const std::string& condition, const std::string& a, const std::string& b);

  // conversions
  std::string Components(const std::string& text, const Type& type, std::vector<std::string>& components);
  std::string FromComponents(const Type& type, const std::vector<std::string>& components,
                             const std::vector<Scalar>& scalars, std::size_t& next);
  std::string List(const std::vector<ast::ExpressionPtr>& elements, const Type& type);
  bool ListMatches(const std::vector<ast::ExpressionPtr>& elements, const Type& type);
  void FlattenList(const std::vector<ast::ExpressionPtr>& elements, std::string& setup,
                   std::vector<std::string>& components, std::vector<Scalar>& scalars);
  std::string ConvertScalar(const std::string& text, const Storage& from, Scalar to);
  /// `text` itself, or a temporary that `setup` then assigns it to.
  std::string Reusable(const std::string& text, const Type& type, std::string& setup);
  static std::string Sequence(const std::string& setup, const std::string& value);

  std::string CompoundValue(const ast::Assign& n, const Type& result, const std::string& target);
  std::string Distribute(const ast::Construct& parts, const Type& type, const std::string& value);

  // lvalues
  Lvalue Target(const ast::Expression& e);
  Lvalue MemberTarget(const ast::Expression& e, const ast::Member& n);
  Lvalue IndexTarget(const ast::Expression& e, const ast::Index& n);
  std::string Read(const Lvalue& target);
  /// The assignment as an expression whose value is the target's.
  std::string Store(const Lvalue& target, const std::string& value, const Type& value_type);
  [[nodiscard]] static bool IsDirect(const Lvalue& target, const Type& type);
  std::string IndexText(const ast::Expression& index, std::uint32_t count);
  std::string SwizzleText(const std::string& text, const Type& type, const std::vector<SwizzleComponent>& swizzle);
  std::string ElementText(const std::string& text, const Type& type, const std::string& index);
  /// The value read from storage that may hold another scalar than the type says.
  std::string FromStorage(const std::string& text, const Storage& held, const Type& type);

  // calls
  std::string UserCall(const ast::Expression& e, const ast::Call& n);
  std::string IntrinsicText(const ast::Expression& e, const ast::Call& n);
  std::string Reinterpreted(const std::string& text, const Type& from, const Type& to);
  std::string MethodText(const ast::Expression& e, const ast::Call& n);
  std::string Lookup(const ast::Call& n, const Intrinsic& intrinsic, const IntrinsicCall& call);
  std::vector<SamplerBinding> LookupSamplers(const ast::Expression& e, std::string& chosen, std::string& setup);
  [[nodiscard]] std::string LookupText(const Intrinsic& intrinsic, const std::vector<std::string>& texts) const;
  std::string Mul(const std::string& a, const Type& a_type, const std::string& b, const Type& b_type);
  std::string Componentwise(const Intrinsic& intrinsic, const IntrinsicCall& call,
                            const std::vector<std::string>& arguments);
  std::string AnyAll(const std::string& name, const std::string& text, const Type& type);
  struct OutArgument {
    std::string setup;  ///< before the call
    std::string argument;
    std::string after;  ///< comma-separated, after the call
  };
  OutArgument Out(const ast::Expression& e, const Type& parameter, bool also_in);
  std::string WithOuts(const std::string& setup, const std::string& call, const std::string& after, const Type& result);

  StageWriter& stage_;
  SamplerBindings bindings_;
  std::string body_;
  std::string temporaries_;
  int indent_ = 1;
  const ast::Function* function_ = nullptr;
};

/// Whether evaluating the expression does more than give a value, or takes derivatives that need the neighbours: then
/// both sides of && || ?: must be evaluated everywhere, as Direct3D 9 does.
[[nodiscard]] bool NeedsEveryInvocation(const ast::Expression& e);

}  // namespace burin::fx

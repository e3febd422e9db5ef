// SPDX-License-Identifier: Apache-2.0
#pragma once
// The syntax tree of one effect, as parsed: names unresolved, types as written. semantics/ fills in Expression::type
// and the resolved pointers; nothing else of the tree changes after parsing.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "fx_parser/semantics/type.h"
#include "fx_parser/source/source.h"

namespace burin::fx::ast {

struct Expression;
struct Statement;
struct Variable;
struct Function;
struct Struct;
using ExpressionPtr = std::unique_ptr<Expression>;
using StatementPtr = std::unique_ptr<Statement>;

// ---- types as written -------------------------------------------------------------------------------------------

/// `float4x4`, `vector<float,3>`, `sampler2D`, `MyStruct`. The parser resolves built-in names to `type`; for a struct
/// or typedef name it sets `name` (and knows that the name is a type, for casts and declarations).
struct TypeName {
  Range range;
  std::string name;  ///< as written
  Type type;         ///< built-in types: complete. Struct: kind kStruct, resolved by semantics
};

enum Qualifier : std::uint32_t {
  kStatic = 1u << 0,
  kConst = 1u << 1,
  kUniform = 1u << 2,
  kExtern = 1u << 3,
  kShared = 1u << 4,
  kVolatile = 1u << 5,
  kRowMajor = 1u << 6,
  kColumnMajor = 1u << 7,
  kIn = 1u << 8,
  kOut = 1u << 9,  // inout: both
  kInline = 1u << 10,
  kNoInterpolation = 1u << 11,
  kCentroid = 1u << 12,
  kPrecise = 1u << 13,
};

// ---- expressions ------------------------------------------------------------------------------------------------

enum class UnaryOperator {
  kPlus,
  kNegate,
  kNot,
  kBitNot,
  kPreIncrement,
  kPreDecrement,
  kPostIncrement,
  kPostDecrement
};
enum class BinaryOperator {
  kMul,
  kDiv,
  kMod,
  kAdd,
  kSub,
  kShl,
  kShr,
  kLess,
  kGreater,
  kLessEqual,
  kGreaterEqual,
  kEqual,
  kNotEqual,
  kBitAnd,
  kBitXor,
  kBitOr,
  kAnd,
  kOr,
  kComma
};

struct BoolLiteral {
  bool value = false;
};
struct IntLiteral {
  std::uint64_t value = 0;
  bool is_unsigned = false;
};
struct FloatLiteral {
  double value = 0;
  bool is_half = false;
};
struct StringLiteral {
  std::string value;
};  ///< adjacent literals joined, escapes resolved
struct Name {
  std::string name;                    ///< may hold "::"
  const Variable* variable = nullptr;  ///< resolved by semantics
};
struct Unary {
  UnaryOperator op{};
  ExpressionPtr operand;
};
struct Binary {
  BinaryOperator op{};
  ExpressionPtr left, right;
};
/// `a = b` (op empty) or `a += b` (op set).
struct Assign {
  std::optional<BinaryOperator> op;
  ExpressionPtr target, value;
};
struct Conditional {
  ExpressionPtr condition, if_true, if_false;
};
/// A call by name: a user's function or an intrinsic; with an object, Direct3D 10's `texture.Sample(...)`.
struct Call {
  ExpressionPtr object;  ///< before the '.'; null but for a method
  std::string name;
  Range name_range;
  std::vector<ExpressionPtr> arguments;
  const Function* function = nullptr;  ///< resolved by semantics; null for an intrinsic
  int intrinsic = -1;                  ///< index in the intrinsics table
  int method = -1;                     ///< of an object: index in the methods table
};
struct Construct {
  TypeName type;
  std::vector<ExpressionPtr> arguments;
};  ///< float4(a, b)
struct Cast {
  TypeName type;
  std::vector<ExpressionPtr> array_sizes;
  ExpressionPtr operand;
};
/// `.member`, `.xyz`, `._m00_m11`: which one, semantics tells from the operand's type.
struct Member {
  ExpressionPtr operand;
  std::string name;
  Range name_range;
};
struct Index {
  ExpressionPtr operand, index;
};
struct InitializerList {
  std::vector<ExpressionPtr> elements;
};  ///< { a, { b, c } }
/// `compile vs_2_0 F(a, b)` and CgFX's `compile arbfp1 F`; also CompileShader(vs_2_0, F(a)).
struct Compile {
  std::string profile;
  Range profile_range;
  std::string function;
  Range function_range;
  std::vector<ExpressionPtr> arguments;
};
struct AsmBlock {
  std::string text;
};
/// A state block: sampler_state { ... } or stateblock_state { ... }.
struct StateBlock;
struct StateBlockExpression {
  std::unique_ptr<StateBlock> block;
};

struct Expression {
  Range range;
  Type type;       ///< filled by semantics
  int height = 1;  ///< of the tree, 1 for a leaf; at most kMaxExpressionHeight
  std::variant<BoolLiteral, IntLiteral, FloatLiteral, StringLiteral, Name, Unary, Binary, Assign, Conditional, Call,
               Construct, Cast, Member, Index, InitializerList, Compile, AsmBlock, StateBlockExpression>
      node;
};

// ---- declarations -----------------------------------------------------------------------------------------------

struct Annotation {
  TypeName type;  ///< empty name and kind kError where none is written (ReShade)
  std::string name;
  Range name_range;
  std::vector<ExpressionPtr> array_sizes;
  ExpressionPtr value;  ///< may be null
};

/// A global, local, struct member or function parameter.
struct Variable {
  Range range;  ///< of the name
  std::string name;
  std::uint32_t qualifiers = 0;
  TypeName type_name;
  std::vector<ExpressionPtr> array_sizes;  ///< a null element is []
  std::string semantic;                    ///< as written, empty if none
  Range semantic_range;
  std::vector<std::string> registers;  ///< of register(...) and packoffset(...), as written
  std::vector<Annotation> annotations;
  ExpressionPtr initializer;  ///< may be null; a StateBlockExpression for samplers (also ReShade's
                              ///< `sampler s { ... }` and `texture t { ... }`)
  bool is_global = false;
  bool is_parameter = false;  ///< of a function
  Type type;                  ///< with arrays; filled by semantics
};

struct Typedef {
  Range range;
  std::string name;
  TypeName type_name;
  std::vector<ExpressionPtr> array_sizes;
};

struct Function {
  Range range;  ///< of the name
  std::string name;
  std::uint32_t qualifiers = 0;
  TypeName return_type_name;
  std::vector<std::unique_ptr<Variable>> parameters;
  std::string semantic;  ///< of the returned value
  Range semantic_range;
  std::vector<Annotation> annotations;
  StatementPtr body;  ///< null for a prototype
  Type return_type;   ///< filled by semantics
};

/// Also Cg's interfaces.
struct Struct {
  static constexpr long kNotCounted = -2;
  Range range;
  std::string name;  ///< empty if anonymous
  std::vector<std::unique_ptr<Variable>> members;
  std::vector<std::unique_ptr<Function>> methods;  ///< their heads: no shader of ours can call them
  bool is_interface = false;
  // Filled by semantics, so that no one counts through structs inside structs again.
  long components = kNotCounted;  ///< numeric ones; -1 when something in it is not numeric
  long leaves = 1;                ///< members of all kinds, those of inner structs too
  int depth = 1;                  ///< of structs inside one another
};

// ---- statements -------------------------------------------------------------------------------------------------

struct Block {
  std::vector<StatementPtr> statements;
};
/// `float a = 1, b[2];` One statement, several variables; also a local struct.
struct DeclarationStatement {
  std::vector<std::unique_ptr<Variable>> variables;
  std::unique_ptr<Struct> structure;
  std::vector<std::unique_ptr<Typedef>> typedefs;
};
struct ExpressionStatement {
  ExpressionPtr expression;
};  ///< null: `;`
struct If {
  ExpressionPtr condition;
  StatementPtr then_branch, else_branch;
  std::vector<std::string> attributes;
};
struct For {
  StatementPtr init;
  ExpressionPtr condition, step;
  StatementPtr body;
  std::vector<std::string> attributes;
};
struct While {
  ExpressionPtr condition;
  StatementPtr body;
  std::vector<std::string> attributes;
};
struct DoWhile {
  StatementPtr body;
  ExpressionPtr condition;
  std::vector<std::string> attributes;
};
struct Case {
  ExpressionPtr value;
  std::vector<StatementPtr> statements;
  Range range;
};  ///< null value: default
struct Switch {
  ExpressionPtr selector;
  std::vector<Case> cases;
  std::vector<std::string> attributes;
};
struct Return {
  ExpressionPtr value;
};
struct Break {};
struct Continue {};
struct Discard {};

struct Statement {
  Range range;
  std::variant<Block, DeclarationStatement, ExpressionStatement, If, For, While, DoWhile, Switch, Return, Break,
               Continue, Discard>
      node;
};

// ---- techniques, passes, states ---------------------------------------------------------------------------------

/// `AlphaBlendEnable = true;`, `ColorOp[1] = SelectArg1;`, `Texture = <t>;`, and DX10's `SetBlendState(...)` (is_call).
struct StateAssignment {
  Range range;
  std::string name;  ///< as written
  Range name_range;
  ExpressionPtr index;  ///< of name[index]; may be null
  ExpressionPtr value;  ///< null for a call
  /// How the value was written: `v`, `(v)`, `<v>`. For state values, enumerants parse as Name and OR-lists as kBitOr.
  enum class Form { kPlain, kParenthesised, kAngled } form = Form::kPlain;
  bool is_call = false;
  std::vector<ExpressionPtr> arguments;
};

struct StateBlock {
  Range range;
  std::vector<StateAssignment> states;
};

struct Pass {
  Range range;  ///< of the name, or of the keyword
  std::string name;
  std::vector<Annotation> annotations;
  std::vector<StateAssignment> states;
};

struct Technique {
  Range range;
  std::string keyword;  ///< technique, technique10, technique11 (lower case)
  std::string name;     ///< may be empty
  std::vector<Annotation> annotations;
  std::vector<Pass> passes;
};

/// Everything at file scope, in order.
using Declaration = std::variant<std::unique_ptr<Struct>, std::unique_ptr<Typedef>, std::unique_ptr<Variable>,
                                 std::unique_ptr<Function>, std::unique_ptr<Technique>>;

struct Module {
  std::vector<Declaration> declarations;
};

}  // namespace burin::fx::ast

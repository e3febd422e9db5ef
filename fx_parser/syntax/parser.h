// SPDX-License-Identifier: Apache-2.0
#pragma once
// Recursive descent over the preprocessed tokens. One class, one .cpp per grammar area. A function that returns null or
// false has reported why; whoever holds a point to go on from (a ';', a '}', the next declaration) skips to it there.

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fx_parser/source/diagnostic.h"
#include "fx_parser/syntax/ast.h"
#include "fx_parser/syntax/name_scopes.h"
#include "fx_parser/syntax/token.h"

namespace burin::fx {

class Parser {
 public:
  Parser(TokenStream& stream, Diagnostics& diagnostics);

  ast::Module ParseModule();

 private:
  // parser.cpp: the vocabulary
  [[nodiscard]] const Token& Peek(std::size_t ahead = 0) const;
  [[nodiscard]] const Token& Previous() const { return tokens_[position_ == 0 ? 0 : position_ - 1]; }
  [[nodiscard]] bool Is(TokenKind kind, std::size_t ahead = 0) const { return Peek(ahead).kind == kind; }
  [[nodiscard]] bool IsWord(std::string_view word, std::size_t ahead = 0) const { return Peek(ahead).Is(word); }
  /// A word of the effect framework, whose case does not count.
  [[nodiscard]] bool IsEffectWord(std::string_view word, std::size_t ahead = 0) const;
  const Token& Advance();
  bool Accept(TokenKind kind);
  bool AcceptWord(std::string_view word);
  /// "expected `what`, found ..." unless the next token is of that kind.
  bool Expect(TokenKind kind, const std::string& what);
  /// The closing one of a pair; its note shows the opening one.
  bool ExpectClosing(TokenKind kind, const std::string& what, const Range& opening);
  /// "expected ';' after `what`", shown where it belongs. True also where the text goes on as if it were there.
  bool ExpectSemicolon(const std::string& what);
  bool ExpectName(const std::string& what, std::string& name, Range& range);
  void ReportUnexpected(const std::string& expected);
  Diagnostic& Report(const Range& range, std::string text, std::string code = "X3000");
  [[nodiscard]] bool stopped() const { return diagnostics_.exhausted(); }
  [[nodiscard]] Range RangeFrom(std::size_t first) const;
  /// The text of tokens [first, last), spaces as written.
  [[nodiscard]] std::string TextOf(std::size_t first, std::size_t last) const;
  /// The index of the token that closes the bracket at `open`, or that of the end.
  [[nodiscard]] std::size_t FindClosing(std::size_t open) const;

  // recovery.cpp
  void SkipStatement(std::size_t first);
  void SkipDeclaration(std::size_t first);
  [[nodiscard]] int OpenBraces(std::size_t first) const;
  [[nodiscard]] bool AtDeclarationKeyword() const;
  [[nodiscard]] bool AtTechnique(std::size_t ahead = 0) const;

  // parse_types.cpp
  struct Specifiers {
    std::uint32_t qualifiers = 0;
    ast::TypeName type;
    std::unique_ptr<ast::Struct> structure;  // when one is defined on the spot
  };
  [[nodiscard]] bool StartsQualifier(std::size_t ahead) const;
  [[nodiscard]] bool StartsType(std::size_t ahead) const;
  [[nodiscard]] bool IsTypeName(std::string_view name) const;
  [[nodiscard]] bool StartsQualifiedType(std::size_t ahead, std::size_t* end) const;
  [[nodiscard]] bool StartsDeclaration() const;
  [[nodiscard]] bool StartsCast() const;
  std::uint32_t ParseQualifiers();
  bool ParseSpecifiers(Specifiers& specifiers);
  bool ParseTypeName(ast::TypeName& type, std::uint32_t qualifiers);
  bool ParseTypeArguments(ast::TypeName& type);
  bool ParseVectorArguments(ast::TypeName& type);
  bool ReportUnknownType(ast::TypeName& type);
  [[nodiscard]] bool DefaultRowMajor() const;

  // parse_module.cpp
  void ParseTopLevel(ast::Module& module);
  bool ParseGlobal(ast::Module& module);
  bool ParseTypedef(std::vector<std::unique_ptr<ast::Typedef>>& typedefs, std::unique_ptr<ast::Struct>& structure);
  bool ParseBuffer(ast::Module& module);
  bool ParseNamespace(ast::Module& module);

  // parse_structs.cpp
  std::unique_ptr<ast::Struct> ParseStruct();
  bool ParseMember(ast::Struct& structure);
  bool ParseMethod(ast::Struct& structure, Specifiers& specifiers);
  [[nodiscard]] bool AtOuterFunction() const;

  // parse_variables.cpp
  using VariableList = std::vector<std::unique_ptr<ast::Variable>>;
  bool ParseVariables(const Specifiers& specifiers, bool is_global, VariableList& variables);
  std::unique_ptr<ast::Variable> ParseVariable(const Specifiers& specifiers, bool is_global);
  bool ParseDeclaratorTail(ast::Variable& variable);
  bool ParseArraySizes(std::vector<ast::ExpressionPtr>& sizes);
  bool ParseSemantics(std::string& semantic, Range& range, std::vector<std::string>* registers);
  bool ParseAnnotations(std::vector<ast::Annotation>& annotations);
  bool ParseAnnotationList(std::vector<ast::Annotation>& annotations);
  bool ParseAnnotationType(ast::TypeName& type);
  bool ParseAnnotation(ast::Annotation& annotation);
  bool SkipAnnotations(std::size_t first);
  bool ExpectClosingAngle(const Range& opening);

  // parse_functions.cpp
  std::unique_ptr<ast::Function> ParseFunction(Specifiers& specifiers);
  bool ParseParameters(ast::Function& function);
  bool ParseParameter(ast::Function& function);

  // parse_statements.cpp, parse_control_flow.cpp
  ast::StatementPtr ParseStatement();
  ast::StatementPtr ParseStatementKind();
  ast::StatementPtr ParseBlock();
  void ParseBlockContents(std::vector<ast::StatementPtr>& statements);
  ast::StatementPtr ParseDeclarationStatement();
  ast::StatementPtr ParseExpressionStatement();
  ast::StatementPtr ParseAsmStatement();
  bool CheckMissingBrace(std::size_t declaration);
  bool ParseAttributes(std::vector<std::string>& attributes);
  ast::StatementPtr ParseIf(std::vector<std::string> attributes);
  ast::StatementPtr ParseFor(std::vector<std::string> attributes);
  ast::StatementPtr ParseWhile(std::vector<std::string> attributes);
  ast::StatementPtr ParseDo(std::vector<std::string> attributes);
  ast::StatementPtr ParseSwitch(std::vector<std::string> attributes);
  bool ParseCaseLabel(ast::Case& label);
  ast::StatementPtr ParseJump();
  bool ParseForHeader(ast::For& loop);
  bool ParseHeader(const std::string& keyword, ast::ExpressionPtr& condition);
  bool SkipHeader(std::size_t open);
  template <class Node>
  ast::StatementPtr MakeStatement(std::size_t first, Node node);

  // parse_expressions.cpp, parse_primaries.cpp
  ast::ExpressionPtr ParseExpression();
  ast::ExpressionPtr ParseAssignment();
  ast::ExpressionPtr ParseConditional();
  ast::ExpressionPtr ParseBinary(int least_precedence);
  ast::ExpressionPtr ParseUnary();
  ast::ExpressionPtr ParseUnaryOperand();
  ast::ExpressionPtr ParseCast();
  ast::ExpressionPtr ParsePostfix();
  ast::ExpressionPtr ParsePostfixOperator(ast::ExpressionPtr operand, std::size_t first);
  ast::ExpressionPtr ParseMember(ast::ExpressionPtr operand, std::size_t first);
  ast::ExpressionPtr ParsePrimary();
  ast::ExpressionPtr ParsePrimaryKind();
  ast::ExpressionPtr ParseNumber();
  ast::ExpressionPtr ParseStringLiteral();
  ast::ExpressionPtr ParseParenthesised();
  ast::ExpressionPtr ParseIdentifier();
  ast::ExpressionPtr ParseConstruct();
  ast::ExpressionPtr ParseInitializerList();
  ast::ExpressionPtr ParseCompile();
  ast::ExpressionPtr ParseCompileShader();
  bool ParseEntryPoint(ast::Compile& compile);
  ast::ExpressionPtr ParseAsm();
  bool ParseArguments(std::vector<ast::ExpressionPtr>& arguments);
  /// A name as it was declared, whole.
  bool ParseQualifiedName(const std::string& what, std::string& name, Range& range);
  template <class Node>
  ast::ExpressionPtr Make(std::size_t first, Node node);
  ast::ExpressionPtr CheckHeight(ast::ExpressionPtr expression);

  // parse_techniques.cpp
  std::unique_ptr<ast::Technique> ParseTechnique();
  bool ParsePass(ast::Technique& technique);

  // parse_states.cpp
  void ParseStates(std::vector<ast::StateAssignment>& states, const std::string& what);
  bool ParseState(ast::StateAssignment& state, const std::string& what);
  bool ParseStateValue(ast::StateAssignment& state);
  ast::ExpressionPtr ParseStateBlock(const std::string& what);

  /// Counts one level of recursion while it lives.
  class Nesting {
   public:
    explicit Nesting(int& depth) : depth_(depth) { ++depth_; }
    ~Nesting() { --depth_; }
    Nesting(const Nesting&) = delete;
    Nesting& operator=(const Nesting&) = delete;

   private:
    int& depth_;
  };
  bool ReportTooDeep();

  /// Sets a flag for the length of a scope.
  class Setting {
   public:
    Setting(bool& flag, bool value) : flag_(flag), old_(flag) { flag_ = value; }
    ~Setting() { flag_ = old_; }
    Setting(const Setting&) = delete;
    Setting& operator=(const Setting&) = delete;

   private:
    bool& flag_;
    bool old_;
  };

  TokenStream& stream_;
  std::vector<Token>& tokens_;
  Diagnostics& diagnostics_;
  Diagnostic ignored_;  // what a report at the place of the last one returns
  std::size_t position_ = 0;
  std::size_t last_report_ = ~std::size_t{0};
  int expression_depth_ = 0;
  int statement_depth_ = 0;
  bool stop_at_greater_ = false;           // inside < >, where '>' ends the expression
  bool abandon_function_ = false;          // its '}' is missing: unwind to file scope
  const Token* function_brace_ = nullptr;  // the '{' of the function at hand
  std::string function_name_;
  NameScopes names_;
  std::string space_;  // the namespace at hand, "outer::inner::"
};

template <class Node>
ast::StatementPtr Parser::MakeStatement(std::size_t first, Node node) {
  auto statement = std::make_unique<ast::Statement>();
  statement->range = RangeFrom(first);
  statement->node = std::move(node);
  return statement;
}

template <class Node>
ast::ExpressionPtr Parser::Make(std::size_t first, Node node) {
  auto expression = std::make_unique<ast::Expression>();
  expression->range = RangeFrom(first);
  expression->node = std::move(node);
  return CheckHeight(std::move(expression));
}

}  // namespace burin::fx

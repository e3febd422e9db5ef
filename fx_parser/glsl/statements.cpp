// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/glsl/function_writer.h"
#include "fx_parser/semantics/constant.h"
#include "fx_parser/semantics/conversion.h"

namespace burin::fx {
namespace {

/// Without the parentheses around the whole.
std::string Bare(const std::string& text) {
  if (text.size() < 2 || text.front() != '(') return text;
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '(') ++depth;
    if (text[i] == ')' && --depth == 0) return i + 1 == text.size() ? text.substr(1, i - 1) : text;
  }
  return text;
}

}  // namespace

std::string FunctionWriter::Function(const ast::Function& function, const std::string& name) {
  function_ = &function;
  std::string parameters;
  std::string zeros;
  for (const auto& parameter : function.parameters) {
    if (bindings_.contains(parameter.get())) continue;
    const bool is_out = (parameter->qualifiers & ast::kOut) != 0;
    const bool is_in = !is_out || (parameter->qualifiers & ast::kIn) != 0;
    const std::string text = stage_.VariableName(*parameter);
    parameters += (parameters.empty() ? "" : ", ") + std::string(is_out ? (is_in ? "inout " : "out ") : "") +
                  stage_.TypeText(parameter->type) + " " + text;
    if (!is_in) zeros += Initialisation(text, parameter->type, nullptr);
  }
  if (const auto* block = std::get_if<ast::Block>(&function.body->node)) {
    for (const auto& statement : block->statements) Statement(*statement);
  } else {
    Statement(*function.body);
  }
  return stage_.TypeText(function.return_type) + " " + name + "(" + parameters + ") {\n" + temporaries_ + zeros +
         body_ + "}\n";
}

void FunctionWriter::Line(const std::string& text) {
  body_.append(static_cast<std::size_t>(indent_) * 2, ' ');
  body_ += text;
  body_ += '\n';
  if (body_.size() > kMaxStageText && !stage_.failed() && function_ != nullptr) {
    stage_.Error(function_->range, "B1013",
                 "the shader grows past what can be translated: too much text in one function");
  }
}

void FunctionWriter::Statement(const ast::Statement& statement) {
  if (stage_.failed()) return;
  std::visit([&](const auto& node) { Write(node); }, statement.node);
}

void FunctionWriter::Body(const ast::StatementPtr& statement) {
  ++indent_;
  if (statement != nullptr) {
    if (const auto* block = std::get_if<ast::Block>(&statement->node)) {
      for (const auto& inner : block->statements) Statement(*inner);
    } else {
      Statement(*statement);
    }
  }
  --indent_;
}

std::string FunctionWriter::Condition(const ast::Expression& e) {
  return Bare(ExpressionAs(e, ScalarType(Scalar::kBool)));
}

void FunctionWriter::Write(const ast::Block& block) {
  for (const auto& statement : block.statements) Statement(*statement);
}

void FunctionWriter::Local(const ast::Variable& variable) {
  // Tables of constants stay out of the function, where they would be filled again at every call.
  if ((variable.qualifiers & ast::kConst) != 0 && variable.type.is_array() && stage_.DeclareConstant(variable)) return;
  const std::string type = stage_.TypeText(variable.type);
  const std::string value = variable.initializer != nullptr ? ExpressionAs(*variable.initializer, variable.type)
                                                            : stage_.ZeroText(variable.type);
  const std::string name = stage_.VariableName(variable);
  if (!value.empty()) {
    Line(type + " " + name + " = " + value + ";");
    return;
  }
  Line(type + " " + name + ";");
  Line("for (int i = 0; i < " + std::to_string(variable.type.array.front()) + "; ++i) " + name +
       "[i] = " + stage_.ZeroText(*ElementType(variable.type)) + ";");
}

void FunctionWriter::Write(const ast::DeclarationStatement& declaration) {
  for (const auto& variable : declaration.variables) Local(*variable);
}

void FunctionWriter::Write(const ast::ExpressionStatement& statement) {
  if (statement.expression != nullptr) Line(Bare(Expression(*statement.expression)) + ";");
}

void FunctionWriter::Write(const ast::If& branch) {
  if (Flatten(branch)) return;
  Line("if (" + Condition(*branch.condition) + ") {");
  Body(branch.then_branch);
  if (branch.else_branch != nullptr) {
    Line("} else {");
    Body(branch.else_branch);
  }
  Line("}");
}

void FunctionWriter::Write(const ast::For& loop) {
  // Names are unique in the function, so the loop's variable may stand before the loop, and be read after it.
  std::string step;
  if (loop.init != nullptr) Statement(*loop.init);
  const std::string condition = loop.condition != nullptr ? Condition(*loop.condition) : "";
  if (loop.step != nullptr) step = Bare(Expression(*loop.step));
  Line("for (; " + condition + "; " + step + ") {");
  Body(loop.body);
  Line("}");
}

void FunctionWriter::Write(const ast::While& loop) {
  Line("while (" + Condition(*loop.condition) + ") {");
  Body(loop.body);
  Line("}");
}

void FunctionWriter::Write(const ast::DoWhile& loop) {
  Line("do {");
  Body(loop.body);
  Line("} while (" + Condition(*loop.condition) + ");");
}

void FunctionWriter::Write(const ast::Switch& choice) {
  Line("switch (" + ExpressionAs(*choice.selector, ScalarType(Scalar::kInt)) + ") {");
  ++indent_;
  for (const ast::Case& arm : choice.cases) {
    const auto value = arm.value != nullptr ? EvaluateAs(*arm.value, ScalarType(Scalar::kInt)) : std::nullopt;
    Line(value ? "case " + NumberText(value->numbers[0], Scalar::kInt) + ":" : "default:");
    ++indent_;
    for (const auto& statement : arm.statements) Statement(*statement);
    --indent_;
  }
  if (choice.cases.empty() || choice.cases.back().statements.empty()) Line("  break;");
  --indent_;
  Line("}");
}

void FunctionWriter::Write(const ast::Return& leave) {
  if (leave.value == nullptr) {
    Line("return;");
  } else if (function_ != nullptr && function_->return_type.kind == TypeKind::kVoid) {
    Line(Expression(*leave.value) + ";");
    Line("return;");
  } else {
    Line("return " + (function_ != nullptr ? ExpressionAs(*leave.value, function_->return_type) : "0") + ";");
  }
}

void FunctionWriter::Write(const ast::Break&) { Line("break;"); }
void FunctionWriter::Write(const ast::Continue&) { Line("continue;"); }

void FunctionWriter::Write(const ast::Discard&) {
  if (stage_.stage() == Stage::kVertex) {
    if (function_ != nullptr)
      stage_.Error(function_->range, "X4532", "'" + function_->name + "': discard cannot be used in a vertex shader");
    return;
  }
  Line("discard;");
}

}  // namespace burin::fx

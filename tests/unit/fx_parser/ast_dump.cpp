// SPDX-License-Identifier: Apache-2.0
#include <sstream>

#include "tests/unit/fx_parser/syntax_support.h"

namespace burin::fx::test {

namespace {

std::string TypeText(const ast::TypeName& type) {
  std::string text = type.type.row_major ? "row_major " : "";
  text += type.name.empty() ? "?" : type.name;
  return text;
}

std::string Sizes(const std::vector<ast::ExpressionPtr>& sizes) {
  std::string text;
  for (const auto& size : sizes) text += "[" + (size ? Dump(size.get()) : std::string()) + "]";
  return text;
}

template <class List>
std::string Each(const List& list) {
  std::string text;
  for (const auto& element : list) text += " " + Dump(element.get());
  return text;
}

std::string Attributes(const std::vector<std::string>& attributes) {
  std::string text;
  for (const auto& attribute : attributes) text += "[" + attribute + "]";
  return text;
}

std::string StateText(const ast::StateAssignment& state) {
  std::string text = state.name;
  if (state.is_call) return text + "(" + (state.arguments.empty() ? "" : Each(state.arguments).substr(1)) + ")";
  if (state.index) text += "[" + Dump(state.index.get()) + "]";
  const std::string value = Dump(state.value.get());
  using Form = ast::StateAssignment::Form;
  if (state.form == Form::kAngled) return text + "=<" + value + ">";
  if (state.form == Form::kParenthesised) return text + "=(" + value + ")";
  return text + "=" + value;
}

std::string States(const std::vector<ast::StateAssignment>& states) {
  std::string text;
  for (const auto& state : states) text += " " + StateText(state);
  return text;
}

std::string Annotations(const std::vector<ast::Annotation>& annotations) {
  std::string text;
  for (const auto& annotation : annotations) {
    text += text.empty() ? " <" : "; ";
    text += TypeText(annotation.type) + " " + annotation.name + Sizes(annotation.array_sizes);
    if (annotation.value) text += "=" + Dump(annotation.value.get());
  }
  return text.empty() ? text : text + ">";
}

std::string Operator(ast::BinaryOperator op) {
  constexpr const char* kTexts[] = {
      "*", "/", "%", "+", "-", "<<", ">>", "<", ">", "<=", ">=", "==", "!=", "&", "^", "|", "&&", "||", ","};
  return kTexts[static_cast<int>(op)];
}

struct ExpressionDump {
  std::string operator()(const ast::BoolLiteral& node) const { return node.value ? "true" : "false"; }
  std::string operator()(const ast::IntLiteral& node) const {
    return std::to_string(node.value) + (node.is_unsigned ? "u" : "");
  }
  std::string operator()(const ast::FloatLiteral& node) const {
    std::ostringstream text;
    text << node.value << (node.is_half ? "h" : "f");
    return text.str();
  }
  std::string operator()(const ast::StringLiteral& node) const { return "\"" + node.value + "\""; }
  std::string operator()(const ast::Name& node) const { return node.name; }
  std::string operator()(const ast::Unary& node) const {
    constexpr const char* kTexts[] = {"+", "-", "!", "~", "++", "--", "post++", "post--"};
    return std::string("(") + kTexts[static_cast<int>(node.op)] + " " + Dump(node.operand.get()) + ")";
  }
  std::string operator()(const ast::Binary& node) const {
    return "(" + Operator(node.op) + " " + Dump(node.left.get()) + " " + Dump(node.right.get()) + ")";
  }
  std::string operator()(const ast::Assign& node) const {
    return "(" + (node.op ? Operator(*node.op) : "") + "= " + Dump(node.target.get()) + " " + Dump(node.value.get()) +
           ")";
  }
  std::string operator()(const ast::Conditional& node) const {
    return "(? " + Dump(node.condition.get()) + " " + Dump(node.if_true.get()) + " " + Dump(node.if_false.get()) + ")";
  }
  std::string operator()(const ast::Call& node) const {
    const std::string object = node.object ? Dump(node.object.get()) + "." : "";
    return "(call " + object + node.name + Each(node.arguments) + ")";
  }
  std::string operator()(const ast::Construct& node) const {
    return "(new " + TypeText(node.type) + Each(node.arguments) + ")";
  }
  std::string operator()(const ast::Cast& node) const {
    return "(cast " + TypeText(node.type) + Sizes(node.array_sizes) + " " + Dump(node.operand.get()) + ")";
  }
  std::string operator()(const ast::Member& node) const {
    return "(. " + Dump(node.operand.get()) + " " + node.name + ")";
  }
  std::string operator()(const ast::Index& node) const {
    return "([] " + Dump(node.operand.get()) + " " + Dump(node.index.get()) + ")";
  }
  std::string operator()(const ast::InitializerList& node) const { return "{" + Each(node.elements) + " }"; }
  std::string operator()(const ast::Compile& node) const {
    return "(compile " + node.profile + " " + node.function + Each(node.arguments) + ")";
  }
  std::string operator()(const ast::AsmBlock& node) const { return "(asm '" + node.text + "')"; }
  std::string operator()(const ast::StateBlockExpression& node) const {
    return "(states" + States(node.block->states) + ")";
  }
};

std::string DeclarationsOf(const ast::DeclarationStatement& node) {
  std::string text;
  if (node.structure) text += " (struct " + node.structure->name + ")";
  for (const auto& entry : node.typedefs) text += " (typedef " + TypeText(entry->type_name) + " " + entry->name + ")";
  for (const auto& variable : node.variables) text += " " + Dump(*variable);
  return "(var" + text + ")";
}

struct StatementDump {
  std::string operator()(const ast::Block& node) const { return "{" + Each(node.statements) + " }"; }
  std::string operator()(const ast::DeclarationStatement& node) const { return DeclarationsOf(node); }
  std::string operator()(const ast::ExpressionStatement& node) const {
    return node.expression ? Dump(node.expression.get()) : ";";
  }
  std::string operator()(const ast::If& node) const {
    const std::string tail = node.else_branch ? " else " + Dump(node.else_branch.get()) : "";
    return Attributes(node.attributes) + "(if " + Dump(node.condition.get()) + " " + Dump(node.then_branch.get()) +
           tail + ")";
  }
  std::string operator()(const ast::For& node) const {
    return Attributes(node.attributes) + "(for " + Dump(node.init.get()) + " " + Dump(node.condition.get()) + " " +
           Dump(node.step.get()) + " " + Dump(node.body.get()) + ")";
  }
  std::string operator()(const ast::While& node) const {
    return Attributes(node.attributes) + "(while " + Dump(node.condition.get()) + " " + Dump(node.body.get()) + ")";
  }
  std::string operator()(const ast::DoWhile& node) const {
    return Attributes(node.attributes) + "(do " + Dump(node.body.get()) + " " + Dump(node.condition.get()) + ")";
  }
  std::string operator()(const ast::Switch& node) const {
    std::string text = Attributes(node.attributes) + "(switch " + Dump(node.selector.get());
    for (const auto& label : node.cases) {
      text += label.value ? " (case " + Dump(label.value.get()) : " (default";
      text += Each(label.statements) + ")";
    }
    return text + ")";
  }
  std::string operator()(const ast::Return& node) const {
    return node.value ? "(return " + Dump(node.value.get()) + ")" : "(return)";
  }
  std::string operator()(const ast::Break&) const { return "(break)"; }
  std::string operator()(const ast::Continue&) const { return "(continue)"; }
  std::string operator()(const ast::Discard&) const { return "(discard)"; }
};

std::string Qualifiers(std::uint32_t bits) {
  constexpr const char* kTexts[] = {"static",   "const",           "uniform",      "extern", "shared",
                                    "volatile", "row_major",       "column_major", "in",     "out",
                                    "inline",   "nointerpolation", "centroid",     "precise"};
  std::string text;
  for (int i = 0; i < 14; ++i) {
    if ((bits >> i & 1u) != 0 && i != 6) text += std::string(kTexts[i]) + " ";  // row_major: the type tells
  }
  return text;
}

struct DeclarationDump {
  std::string operator()(const std::unique_ptr<ast::Struct>& node) const {
    std::string text = "(struct" + (node->name.empty() ? "" : " " + node->name);
    for (const auto& member : node->members) text += " " + Dump(*member);
    return text + ")";
  }
  std::string operator()(const std::unique_ptr<ast::Typedef>& node) const {
    return "(typedef " + TypeText(node->type_name) + " " + node->name + Sizes(node->array_sizes) + ")";
  }
  std::string operator()(const std::unique_ptr<ast::Variable>& node) const { return Dump(*node); }
  std::string operator()(const std::unique_ptr<ast::Function>& node) const {
    std::string text =
        "(function " + Qualifiers(node->qualifiers) + TypeText(node->return_type_name) + " " + node->name;
    for (const auto& parameter : node->parameters) text += " " + Dump(*parameter);
    if (!node->semantic.empty()) text += " : " + node->semantic;
    text += Annotations(node->annotations);
    return text + (node->body ? " " + Dump(node->body.get()) : "") + ")";
  }
  std::string operator()(const std::unique_ptr<ast::Technique>& node) const {
    std::string text =
        "(" + node->keyword + (node->name.empty() ? "" : " " + node->name) + Annotations(node->annotations);
    for (const auto& pass : node->passes) {
      text += " (pass" + (pass.name.empty() ? "" : " " + pass.name) + Annotations(pass.annotations) +
              States(pass.states) + ")";
    }
    return text + ")";
  }
};

}  // namespace

std::string Dump(const ast::Expression* expression) {
  return expression ? std::visit(ExpressionDump{}, expression->node) : "nothing";
}

std::string Dump(const ast::Statement* statement) {
  return statement ? std::visit(StatementDump{}, statement->node) : "nothing";
}

std::string Dump(const ast::Variable& variable) {
  std::string text = "[" + Qualifiers(variable.qualifiers) + TypeText(variable.type_name);
  if (!variable.name.empty()) text += " " + variable.name;
  text += Sizes(variable.array_sizes);
  if (!variable.semantic.empty()) text += " : " + variable.semantic;
  for (const auto& place : variable.registers) text += " : (" + place + ")";
  text += Annotations(variable.annotations);
  if (variable.initializer) text += " = " + Dump(variable.initializer.get());
  return text + "]";
}

std::string Dump(const ast::Declaration& declaration) { return std::visit(DeclarationDump{}, declaration); }

std::string Dump(const ast::Module& module) {
  std::string text;
  for (const auto& declaration : module.declarations) text += (text.empty() ? "" : "\n") + Dump(declaration);
  return text;
}

}  // namespace burin::fx::test

// SPDX-License-Identifier: Apache-2.0
#pragma once
// What one shader stage's text is gathered in while functions are written: structs, uniforms, globals, functions.

#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "fx_parser/effect/value.h"
#include "fx_parser/glsl/names.h"
#include "fx_parser/glsl/prelude.h"
#include "fx_parser/semantics/checker.h"

namespace burin::fx {

enum class Stage { kVertex, kFragment };

/// A sampler that the file declares at file scope, or one element of an array of them.
struct SamplerBinding {
  const ast::Variable* sampler = nullptr;
  int element = -1;
  /// Direct3D 10's texture that the sampler looks up; null: the sampler's own.
  const ast::Variable* texture = nullptr;
  auto operator<=>(const SamplerBinding&) const = default;
};
/// As GLSL and Effect::samplers name it, without the element: "samp", "tex_with_samp".
[[nodiscard]] std::string SamplerNameOf(const SamplerBinding& binding);
/// What a function's sampler parameters stand for in one instance of it.
using SamplerBindings = std::map<const ast::Variable*, SamplerBinding>;

/// Limits on the text of one stage, against functions that call each other twice each, over and over.
inline constexpr std::size_t kMaxStageText = 4u << 20;
inline constexpr std::size_t kMaxInstances = 4096;
inline constexpr int kMaxCallDepth = 128;

class StageWriter {
 public:
  StageWriter(Stage stage, const Checker& checker, const std::set<const ast::Variable*>& written,
              Diagnostics& diagnostics)
      : stage_(stage), checker_(checker), written_(written), diagnostics_(diagnostics) {}

  [[nodiscard]] Stage stage() const { return stage_; }
  [[nodiscard]] Diagnostics& diagnostics() { return diagnostics_; }
  [[nodiscard]] const Checker& checker() const { return checker_; }
  [[nodiscard]] bool is_written(const ast::Variable& variable) const { return written_.contains(&variable); }
  [[nodiscard]] bool failed() const { return failed_; }
  void Fail() { failed_ = true; }
  /// One report for each thing and place, however many instances meet it.
  void Error(const Range& range, const char* code, const std::string& text);
  void Warning(const Range& range, const char* code, const std::string& text);

  /// "vec3", "T_Light", "mat4x4[2]"; declares structs on first use.
  std::string TypeText(const Type& type);
  std::string ZeroText(const Type& type);
  /// A constant of numeric, struct or array type.
  std::string ValueText(const Type& type, const std::vector<double>& numbers, std::size_t& next);
  std::string UniqueName(std::string_view prefix, std::string_view base) { return names_.Unique(prefix, base); }

  /// The name of a variable: locals and function parameters get one on first sight, globals are declared.
  std::string VariableName(const ast::Variable& variable);
  /// The uniform's name; notes the dimension that a look-up takes.
  std::string SamplerName(const SamplerBinding& binding, Dimension dimension, const Range& range);
  /// The function's text for these samplers is written on first use; empty after an error.
  std::string FunctionName(const ast::Function& function, const SamplerBindings& bindings, const Range& call);
  std::string PreludeName(const std::string& name, const std::string& type);
  /// Writes a literal initialiser as a constant at file scope; false when its value is not known here.
  bool DeclareConstant(const ast::Variable& variable);

  /// The entry point's uniform parameters have the values of its compile expression.
  void SetConstant(const ast::Variable& parameter, Value value) { constants_[&parameter] = std::move(value); }
  /// The expression's value where it is known here; empty otherwise.
  [[nodiscard]] std::optional<Value> ConstantOf(const ast::Expression& expression) const;

  /// All declarations, in the order GLSL needs. `initialisers()` belongs at the top of main.
  [[nodiscard]] std::string Declarations() const;
  [[nodiscard]] const std::string& initialisers() const { return initialisers_; }

  [[nodiscard]] const std::vector<const ast::Variable*>& parameters() const { return parameters_; }
  [[nodiscard]] const std::map<SamplerBinding, Dimension>& samplers() const { return samplers_; }
  /// Sampler bindings in order of first use.
  [[nodiscard]] const std::vector<SamplerBinding>& sampler_order() const { return sampler_order_; }

 private:
  [[nodiscard]] bool IsReported(const Range& range, const std::string& text) const;
  std::string StructName(const ast::Struct& structure);
  std::string DeclareGlobal(const ast::Variable& variable);
  std::string DeclareParameter(const ast::Variable& variable);

  struct InstanceKey {
    const ast::Function* function;
    std::vector<SamplerBinding> samplers;
    auto operator<=>(const InstanceKey&) const = default;
  };

  Stage stage_;
  const Checker& checker_;
  const std::set<const ast::Variable*>& written_;
  Diagnostics& diagnostics_;
  bool failed_ = false;
  int call_depth_ = 0;
  NameTable names_;
  std::unordered_map<const ast::Variable*, std::string> variable_names_;
  std::unordered_map<const ast::Struct*, std::string> struct_names_;
  std::map<InstanceKey, std::string> instances_;
  std::set<PreludeFunction> prelude_;
  std::map<const ast::Variable*, Value> constants_;
  std::vector<const ast::Variable*> parameters_;
  std::map<SamplerBinding, Dimension> samplers_;
  std::vector<SamplerBinding> sampler_order_;
  std::string structs_;
  std::string globals_;
  std::string functions_;
  std::string initialisers_;
};

}  // namespace burin::fx

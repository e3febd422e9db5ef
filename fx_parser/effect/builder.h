// SPDX-License-Identifier: Apache-2.0
#pragma once
// Turns a checked module into the Effect that the host runs.

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "fx_parser/effect/effect.h"
#include "fx_parser/effect/fixed_builder.h"
#include "fx_parser/glsl/fixed_pipeline.h"
#include "fx_parser/glsl/program.h"
#include "fx_parser/semantics/checker.h"

namespace burin::fx {

class EffectBuilder {
 public:
  /// `attributes`: the names that GBA<attribute> may use besides those of the file's own techniques.
  EffectBuilder(Checker& checker, const ast::Module& module, std::vector<std::string> attributes, Effect& effect);

  /// Without `write_programs` everything but the GLSL is built and checked: for modules whose functions have errors.
  void Build(bool write_programs);

 private:
  struct Shader {
    bool present = false;  ///< false: NULL
    EntryPoint entry;
    std::string unsupported;  ///< why this host cannot run it
    bool failed = false;      ///< reported
    /// Of an array whose element a parameter chooses; this shader is then that of the initial values.
    std::vector<Shader> options;
    const ast::Expression* choice = nullptr;
  };
  struct PassShaders {
    std::optional<Shader> vertex;
    std::optional<Shader> pixel;
    FixedPassStates fixed;
    // CgFX says in three states what CullMode says in one.
    std::optional<bool> cull_enable;
    bool cull_front = false;
    bool front_is_clockwise = false;
  };

  // parameters
  void BuildParameters();
  std::vector<EffectAnnotation> BuildAnnotations(std::vector<ast::Annotation>& annotations);
  // textures
  void BuildTextures();
  void BuildTexture(ast::Variable& variable);
  void CheckPassTargets();
  void BuildProceduralTextures();
  void BuildProceduralTexture(const ast::Variable& variable, Texture& texture);
  // samplers
  void BuildSamplers();
  void BuildSampler(const ast::Variable& variable, int element, ast::Expression* initializer);
  void ResolveSamplerState(ast::StateAssignment& assignment, Sampler& sampler);
  void ResolveSamplerTexture(ast::StateAssignment& assignment, Sampler& sampler);
  void ResolveDimensions();
  std::optional<std::size_t> FindSampler(const SamplerBinding& binding);
  // states
  std::optional<StateValue> ResolveState(ast::Expression& value, const std::string& state, int kind,
                                         std::span<const struct Enumerant> values, ast::StateAssignment::Form form);
  Type CheckStateValue(ast::Expression& value);
  std::optional<int> EnumerantValue(const ast::Expression& value, std::span<const struct Enumerant> values);
  // shaders
  Shader ResolveShader(ast::Expression& value, bool vertex, int depth = 0);
  Shader ResolveCompile(ast::Compile& compile, const Range& range, bool vertex);
  Shader ResolveShaderElement(ast::Index& index, const Range& range, bool vertex, int depth);
  const ast::Function* FindEntry(const ast::Compile& compile);
  // techniques
  void BuildTechniques();
  void BuildPass(ast::Pass& source, Technique& technique);
  void BuildPassState(ast::StateAssignment& assignment, Pass& pass, PassShaders& shaders,
                      std::vector<std::string>& unsupported);
  /// CgFX's states that have no counterpart of one value in Direct3D; false when this is none of them.
  bool BuildCgState(ast::StateAssignment& assignment, Pass& pass, PassShaders& shaders);
  // the fixed pipeline
  bool BuildFixedState(ast::StateAssignment& assignment, FixedPassStates& fixed);
  bool BuildStageState(ast::StateAssignment& assignment, TextureStageStates& stage);
  bool BuildTextureOfStage(ast::StateAssignment& assignment, TextureStageStates& stage);
  void AddFixedValue(ast::StateAssignment& assignment, FixedName name, int index, FixedPassStates& fixed);
  std::optional<int> FixedNumber(ast::StateAssignment& assignment, std::span<const struct Enumerant> values);
  std::optional<std::size_t> SamplerOfStage(const TextureStageStates& stage, const std::string& name,
                                            const Range& range);
  FixedPipeline MakeFixedPipeline(const FixedPassStates& fixed, const Pass& pass, bool own_texture,
                                  std::vector<std::size_t>& samplers);
  static SamplerState LinearFilter(SamplerStateName name, const Range& range);
  void RebindRegisters(const FixedPassStates& fixed, const std::vector<SamplerBinding>& bindings,
                       ShaderProgram& program);
  void SetState(Pass& pass, RenderState state, ast::Expression& value, std::span<const struct Enumerant> values = {});
  void FinishCgCulling(Pass& pass, const PassShaders& shaders);
  [[nodiscard]] std::optional<ShaderProgram> WriteShaders(Pass& pass, const PassShaders& shaders, const Shader* vertex,
                                                          const Shader* pixel);
  void WriteChoices(Pass& pass, const PassShaders& shaders);
  void NoteSamplers(const ProgramText& text, const Pass& pass, ShaderProgram& program);
  void WritePrograms(Pass& pass, const PassShaders& shaders, std::vector<std::string>& unsupported);
  void FindTargets(Technique& technique, Pass& pass);
  // scripts
  void BuildScripts();
  void BuildScript(const ast::Technique& source, Technique& technique);
  void BuildPassScript(const ast::Technique& source, Technique& technique, std::size_t pass);
  void AddScriptCommand(const struct ScriptCommand& command, const ast::Technique& source, Technique& technique,
                        std::optional<std::size_t> pass, const Range& range);
  void ChooseByScript();
  std::optional<std::size_t> FindParameter(const std::string& name, const std::string& command, const Range& range);
  void WarnScript(const Range& range, const std::string& text);
  void CheckDataFlow(const Technique& technique, const Pass& pass, int index);
  [[nodiscard]] Value DefaultOf(const ast::Variable& variable) const;

  Checker& checker_;
  Diagnostics& diagnostics_;
  std::vector<std::string> attributes_;
  std::set<std::string> custom_attributes_;
  Effect& effect_;
  bool write_programs_ = true;
  std::set<const ast::Variable*> written_;
  std::set<const ast::Variable*> negated_;
  std::map<const ast::Variable*, std::size_t> parameters_;
  std::map<const ast::Variable*, std::size_t> textures_;
  std::map<SamplerBinding, std::size_t> samplers_;
  bool is_scripted_ = false;    ///< some parameter is STANDARDSGLOBAL
  bool draws_geometry_ = true;  ///< what a pass without a script of its own does
};

}  // namespace burin::fx

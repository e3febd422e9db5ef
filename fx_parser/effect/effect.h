// SPDX-License-Identifier: Apache-2.0
#pragma once
// The result of the front end: plain data and GLSL.

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "fx_parser/effect/fixed_function.h"
#include "fx_parser/effect/format.h"
#include "fx_parser/effect/state.h"
#include "fx_parser/effect/value.h"
#include "fx_parser/source/source.h"
#include "fx_parser/syntax/ast.h"

namespace burin::fx {

struct EffectAnnotation {
  std::string name;
  Value value;
};

/// A numeric, string or struct global that the host may set. Static and const globals are no parameters.
struct Parameter {
  std::string name;
  Type type;
  std::string semantic;  ///< as written; compared without case
  std::vector<EffectAnnotation> annotations;
  Value default_value;  ///< evaluated; zeros when the effect gives none (then has_default is false)
  bool has_default = false;
  bool is_negated = false;  ///< some function takes its negative: of a light's direction that is as the light shines
  Range range;
};

/// The two stages of one pass, emitted as a pair.
struct ShaderProgram {
  std::string vertex_glsl;
  std::string fragment_glsl;
  std::string vertex_entry;                ///< "VSEdgeFilter", empty: the pass-through
  std::string fragment_entry;              ///< empty: the pass has no pixel shader (depth and stencil only)
  std::vector<std::size_t> parameters;     ///< indices in Effect::parameters that either stage reads
  std::vector<std::size_t> samplers;       ///< indices in Effect::samplers, in the order of their texture units
  std::vector<std::string> vertex_inputs;  ///< semantics read: "POSITION0", "TEXCOORD3"
  int targets = 1;                         ///< fragment outputs written: highest index + 1
  bool writes_depth = false;
  bool alpha_test = false;  ///< the text reads kUniformAlphaTest
};

/// GBA<attribute>_<FORMAT>[_S<scale>]
struct AttributeRole {
  std::string attribute;   ///< lower case, a name of Options::attributes, or that of a technique GBA<attribute>
  bool is_custom = false;  ///< filled by the technique GBA<attribute>
};
/// PASS<k>_<FORMAT>[_S<scale>][_RT<j>]
struct PassResultRole {
  int pass = 0;
  int target = 0;
};
/// Any other texture: a file named by an annotation or --param, or a stand-in.
struct FileRole {
  std::string file;  ///< of ResourceName / name / source / texture annotations; empty: none named
};

/// A texture of the semantic RENDERCOLORTARGET or RENDERDEPTHSTENCILTARGET: a target of scripts.
struct ScriptTargetRole {
  bool is_depth_stencil = false;
  bool is_offscreen = false;  ///< OFFSCREENRENDERTARGET: the host draws into it before the script runs
  double width_ratio = 1.0;   ///< against the frame
  double height_ratio = 1.0;
  int width = 0;  ///< in pixels; 0: by the ratio
  int height = 0;
};

/// A texture that a function of the effect fills (annotation `function`), once, before the first frame.
struct ProceduralRole {
  std::string function;
  int width = 0, height = 0, depth = 0;  ///< texels; depth of 3D textures only
  ShaderProgram program;                 ///< one slice or face: kUniformTexel says which
};

struct Texture {
  std::string name;
  Dimension dimension = Dimension::k2D;
  std::variant<FileRole, AttributeRole, PassResultRole, ScriptTargetRole, ProceduralRole> role;
  Format format = Format::kA8R8G8B8;  ///< of attributes and pass results
  double scale = 1.0;                 ///< against the frame
  std::string semantic;
  std::vector<EffectAnnotation> annotations;
  Range range;
};

struct Sampler {
  std::string name;
  Dimension dimension = Dimension::k2D;
  std::optional<std::size_t> texture;  ///< index in Effect::textures; empty: none bound
  std::vector<SamplerState> states;    ///< only those that the file sets, in order
  Range range;
};

/// Which element of an array of shaders a pass takes.
struct ShaderChoice {
  const ast::Expression* index = nullptr;  ///< over parameters, evaluated before each draw; null: there is no choice
  std::size_t count = 1;
};

struct Pass {
  std::string name;
  std::vector<EffectAnnotation> annotations;
  std::vector<PassState> states;
  ShaderProgram program;
  /// Where shaders are chosen as a frame is drawn: every vertex shader with every pixel shader, the pixel shaders
  /// of the first vertex shader first; an empty text stands for `program`, which is that of the initial values. Else
  /// empty.
  std::vector<ShaderProgram> choices;
  ShaderChoice vertex_choice;
  ShaderChoice pixel_choice;
  bool restores_states = false;        ///< no shader and nothing to draw with: the end of a technique of some engines
  std::optional<FixedFunction> fixed;  ///< where it stands in for a shader
  /// Indices in Effect::textures of this pass's targets, by target number; empty: it draws into the frame.
  std::vector<std::size_t> targets;
  /// Without a script: the vertex shader takes vertices through the projection, so that it means a scene's geometry.
  bool projects = false;
  Range range;
};

/// One step of a technique's script, the scripts of its passes put in where it runs them.
struct ScriptStep {
  enum class Action {
    kColorTarget,
    kDepthStencilTarget,  ///< `texture`, or the frame's own
    kSetClearColor,
    kSetClearDepth,
    kSetClearStencil,  ///< `parameter`
    kClearColor,
    kClearDepth,
    kClearStencil,
    kDrawGeometry,
    kDrawBuffer,  ///< `pass`: over the scene's geometry, over the whole target
    kViewer,      ///< `viewer`: RenderPort
    kDrawSource,  ///< ScriptExternal: the scene or picture as others draw it
    kLoop,
    kLoopIndex,
    kLoopEnd  ///< `parameter`: how often; what gets the turn's number
  };
  Action action{};
  int index = 0;         ///< of a colour target
  std::size_t pass = 0;  ///< in Technique::passes
  std::optional<std::size_t> texture;
  std::optional<std::size_t> parameter;
  std::string viewer;  ///< "SpotLight0"; empty: the camera
};

struct Technique {
  std::string name;
  std::vector<EffectAnnotation> annotations;
  std::vector<Pass> passes;
  std::vector<ScriptStep> script;        ///< empty: its passes in order
  std::string custom_attribute;          ///< of a technique named GBA<attribute>: lower case; else empty
  std::vector<std::string> unsupported;  ///< why this host cannot run it ("pass P0: asm shaders"); empty: it can
  Range range;
};

/// Owns its syntax tree, which state expressions point into. Move-only.
struct Effect {
  std::string path;
  std::vector<Parameter> parameters;
  std::vector<Texture> textures;
  std::vector<Sampler> samplers;
  std::vector<Technique> techniques;
  /// True when any texture has one of the extension's names: texel meets pixel with no half-pixel offset.
  bool uses_extension = false;
  /// Indices of the techniques that the file's own script names, the first choice first; empty: in the file's order.
  std::vector<std::size_t> preferred_techniques;
  std::shared_ptr<const ast::Module> module;
};

/// Indices of all samplers that the pass looks up, whichever shaders are chosen; each once.
[[nodiscard]] std::vector<std::size_t> SamplersOf(const Pass& pass);

[[nodiscard]] const EffectAnnotation* FindAnnotation(const std::vector<EffectAnnotation>&, std::string_view name);

}  // namespace burin::fx

// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/glsl/program.h"

#include <algorithm>

#include "fx_parser/glsl/entry_writer.h"
#include "fx_parser/glsl/interface.h"

namespace burin::fx {
namespace {

constexpr char kHeader[] = "#version 450 core\n";

std::string VaryingName(const Semantic& semantic) { return "burin_v_" + SanitisedName(semantic.Key()); }

std::string VaryingDeclarations(const std::vector<Semantic>& varyings, const char* direction) {
  std::string text;
  for (std::size_t i = 0; i < varyings.size(); ++i) {
    text += "layout(location = " + std::to_string(i) + ") " + direction + " vec4 " + VaryingName(varyings[i]) + ";\n";
  }
  return text;
}

std::string InputDeclarations(const std::vector<Semantic>& inputs) {
  std::string text;
  for (const Semantic& input : inputs) {
    text += "layout(location = " + std::to_string(*VertexInputLocation(input.Key())) + ") in vec4 burin_in_" +
            input.Key() + ";\n";
  }
  return text;
}

/// D3DCMPFUNC, as kUniformAlphaTest says.
std::string AlphaTest() {
  const std::string uniform(kUniformAlphaTest);
  return "uniform vec2 " + uniform +
         ";\n"
         "bool burin_alpha_passes(float a) {\n"
         "  float r = " +
         uniform +
         ".y;\n"
         "  switch (int(" +
         uniform +
         ".x)) {\n"
         "    case 1: return false;\n"
         "    case 2: return a < r;\n"
         "    case 3: return a == r;\n"
         "    case 4: return a <= r;\n"
         "    case 5: return a > r;\n"
         "    case 6: return a != r;\n"
         "    case 7: return a >= r;\n"
         "  }\n"
         "  return true;\n"
         "}\n";
}

/// Texture coordinates of a texel's centre, of cubes the direction through it (OpenGL 4.5, table 8.19, which is
/// Direct3D's too).
std::string TexelPosition() {
  const std::string uniform(kUniformTexel);
  return "uniform vec4 " + uniform +
         ";\n"
         "vec4 burin_texel_position() {\n"
         "  vec2 place = gl_FragCoord.xy * " +
         uniform +
         ".xy;\n"
         "  if (" +
         uniform + ".z != 0.0) return vec4(place, (" + uniform + ".w + 0.5) * " + uniform +
         ".z, 1.0);\n"
         "  vec2 p = place * 2.0 - 1.0;\n"
         "  switch (int(" +
         uniform +
         ".w)) {\n"
         "    case 0: return vec4(1.0, -p.y, -p.x, 1.0);\n"
         "    case 1: return vec4(-1.0, -p.y, p.x, 1.0);\n"
         "    case 2: return vec4(p.x, 1.0, p.y, 1.0);\n"
         "    case 3: return vec4(p.x, -1.0, -p.y, 1.0);\n"
         "    case 4: return vec4(p.x, -p.y, 1.0, 1.0);\n"
         "  }\n"
         "  return vec4(-p.x, -p.y, -1.0, 1.0);\n"
         "}\n";
}

void Collect(const StageWriter& stage, ProgramText& program) {
  program.parameters.insert(stage.parameters().begin(), stage.parameters().end());
  for (const SamplerBinding& binding : stage.sampler_order()) {
    if (std::find(program.samplers.begin(), program.samplers.end(), binding) == program.samplers.end())
      program.samplers.push_back(binding);
  }
  for (const auto& [binding, dimension] : stage.samplers()) program.dimensions.emplace(binding, dimension);
}

/// Without a pixel shader: the diffuse colour, as Direct3D's texture stages give it where they have no texture.
void WriteDiffuse(const ProgramRequest& request, ProgramText& program, std::vector<Semantic>& varyings) {
  const Semantic diffuse{"COLOR", 0};
  varyings.push_back(diffuse);
  program.targets = 1;
  std::string main = "  burin_out0 = " + VaryingName(diffuse) + ";\n";
  if (request.alpha_test) main += "  if (!burin_alpha_passes(burin_out0.a)) discard;\n";
  program.fragment_glsl = kHeader + VaryingDeclarations(varyings, "in") +
                          "layout(location = 0) out vec4 burin_out0;\n" + (request.alpha_test ? AlphaTest() : "") +
                          "void main() {\n" + main + "}\n";
}

void WriteFixedFragment(const ProgramRequest& request, ProgramText& program, std::vector<Semantic>& varyings) {
  program.targets = 1;
  std::string main = FixedPixelText(*request.fixed, varyings);
  if (request.alpha_test) main += "  if (!burin_alpha_passes(burin_out0.a)) discard;\n";
  program.fragment_glsl = kHeader + VaryingDeclarations(varyings, "in") +
                          "layout(location = 0) out vec4 burin_out0;\n" + FixedPixelDeclarations(*request.fixed) +
                          (request.alpha_test ? AlphaTest() : "") + "void main() {\n" + main + "}\n";
}

bool WriteFragment(const ProgramRequest& request, StageWriter& stage, ProgramText& program,
                   std::vector<Semantic>& varyings) {
  if (request.fixed != nullptr && request.fixed->is_pixel) {
    WriteFixedFragment(request, program, varyings);
    return true;
  }
  if (request.fragment.function == nullptr && request.vertex.function == nullptr) {
    program.fragment_glsl = std::string(kHeader) + "void main() {\n}\n";
    return true;
  }
  if (request.fragment.function == nullptr) {
    WriteDiffuse(request, program, varyings);
    return true;
  }
  FragmentEntry entry(stage, request.fragment);
  entry.fills_texture = request.fills_texture;
  std::string main = entry.Write();
  if (stage.failed()) return false;
  varyings = entry.varyings;
  program.writes_depth = entry.writes_depth;
  program.targets = entry.targets.empty() ? 0 : *entry.targets.rbegin() + 1;
  const bool alpha_test = request.alpha_test && entry.targets.contains(0);
  if (alpha_test) main += "  if (!burin_alpha_passes(burin_out0.a)) discard;\n";
  std::string text = kHeader + VaryingDeclarations(varyings, "in");
  for (const int target : entry.targets) {
    text += "layout(location = " + std::to_string(target) + ") out vec4 burin_out" + std::to_string(target) + ";\n";
  }
  if (alpha_test) text += AlphaTest();
  if (request.fills_texture) text += TexelPosition();
  program.fragment_glsl = text + stage.Declarations() + "void main() {\n" + main + "}\n";
  Collect(stage, program);
  return true;
}

/// The quadrilateral as it comes: position in clip space, texture coordinates as they are, white where a diffuse colour
/// is asked for, as the fixed pipeline without lighting has it.
std::string PassThrough(const std::vector<Semantic>& varyings, std::vector<Semantic>& inputs) {
  inputs.push_back({"POSITION", 0});
  std::string main = "  gl_Position = burin_in_POSITION0;\n";
  for (const Semantic& varying : varyings) {
    std::string value = "vec4(0.0)";
    if (varying == Semantic{"COLOR", 0}) {
      value = "vec4(1.0)";
    } else if (varying == Semantic{"POSITION", 0} ||
               (varying.name == "TEXCOORD" && VertexInputLocation(varying.Key()))) {
      if (varying.name != "POSITION") inputs.push_back(varying);
      value = "burin_in_" + varying.Key();
    }
    main += "  " + VaryingName(varying) + " = " + value + ";\n";
  }
  return main;
}

bool WriteVertex(const ProgramRequest& request, StageWriter& stage, ProgramText& program,
                 const std::vector<Semantic>& varyings) {
  std::string main;
  std::vector<Semantic> inputs;
  const bool is_fixed_vertex = request.fixed != nullptr && request.fixed->is_vertex;
  if (is_fixed_vertex) {
    main = FixedVertexText(*request.fixed, varyings, inputs);
  } else if (request.vertex.function == nullptr) {
    main = PassThrough(varyings, inputs);
  } else {
    VertexEntry entry(stage, request.vertex, varyings);
    main = entry.Write();
    if (stage.failed()) return false;
    if (!entry.writes_position) {
      stage.Error(request.vertex.range, "X4541",
                  "'" + request.vertex.function->name + "': vertex shader must write POSITION");
      return false;
    }
    inputs = entry.inputs;
    for (const Semantic& varying : varyings) {
      if (entry.written.contains(varying.Key())) continue;
      // The fixed pixel stage takes white for a diffuse colour that no one gives.
      const bool is_fixed = request.fragment.function == nullptr;
      const bool is_white = is_fixed && varying == Semantic{"COLOR", 0};
      main += "  " + VaryingName(varying) + (is_white ? " = vec4(1.0);\n" : " = vec4(0.0);\n");
    }
  }
  std::string text = kHeader + InputDeclarations(inputs) + VaryingDeclarations(varyings, "out");
  // The quadrilateral of a pass without a vertex shader is the host's, who has put it right.
  if (request.pixel_offset && (request.vertex.function != nullptr || is_fixed_vertex)) {
    const std::string uniform(kUniformPixelOffset);
    text += "uniform vec4 " + uniform + ";\n";
    main += "  gl_Position.xy += " + uniform + ".xy * gl_Position.w;\n";
  }
  if (is_fixed_vertex) text += FixedVertexFunctions(*request.fixed);
  program.vertex_glsl = text + stage.Declarations() + "void main() {\n" + main + "}\n";
  for (const Semantic& input : inputs) program.vertex_inputs.push_back(input.Key());
  Collect(stage, program);
  return true;
}

}  // namespace

ProgramText WriteProgram(const ProgramRequest& request, const Checker& checker,
                         const std::set<const ast::Variable*>& written, Diagnostics& diagnostics) {
  ProgramText program;
  std::vector<Semantic> varyings;
  StageWriter fragment(Stage::kFragment, checker, written, diagnostics);
  StageWriter vertex(Stage::kVertex, checker, written, diagnostics);
  const bool fragment_done = WriteFragment(request, fragment, program, varyings);
  const bool vertex_done = WriteVertex(request, vertex, program, varyings);
  if (!fragment_done || !vertex_done) {
    program.vertex_glsl.clear();
    program.fragment_glsl.clear();
  }
  for (const auto& [binding, dimension] : vertex.samplers()) {
    const auto at = fragment.samplers().find(binding);
    if (at != fragment.samplers().end() && at->second != dimension) {
      vertex.Error(
          request.vertex.range, "B1012",
          "sampler '" + binding.sampler->name + "' is looked up in different dimensions by the two stages of a pass");
    }
  }
  return program;
}

}  // namespace burin::fx

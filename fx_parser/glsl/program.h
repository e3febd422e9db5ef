// SPDX-License-Identifier: Apache-2.0
#pragma once
// A pair of linked stages as GLSL, from the entry points of one pass.

#include <map>
#include <set>
#include <string>
#include <vector>

#include "fx_parser/glsl/fixed_pipeline.h"
#include "fx_parser/glsl/stage_writer.h"

namespace burin::fx {

struct EntryPoint {
  const ast::Function* function = nullptr;        ///< null: a pass-through vertex stage, an empty fragment stage
  std::vector<const ast::Expression*> arguments;  ///< checked; for the uniform parameters, in order
  int shader_model = 3;                           ///< before 3, vertex colours are clamped
  Range range;                                    ///< of the compile expression
};

struct ProgramRequest {
  EntryPoint vertex;
  EntryPoint fragment;
  bool alpha_test = false;
  bool pixel_offset = false;
  const FixedPipeline* fixed = nullptr;  ///< for what has no function; null: the simplest
  bool fills_texture = false;  ///< the fragment's POSITION and PSIZE are a texel's place and size: kUniformTexel
};

struct ProgramText {
  std::string vertex_glsl;
  std::string fragment_glsl;
  std::set<const ast::Variable*> parameters;
  std::vector<SamplerBinding> samplers;  ///< fragment stage's first
  std::map<SamplerBinding, Dimension> dimensions;
  std::vector<std::string> vertex_inputs;
  int targets = 0;
  bool writes_depth = false;
};

/// Empty texts after an error, which is in `diagnostics`.
[[nodiscard]] ProgramText WriteProgram(const ProgramRequest& request, const Checker& checker,
                                       const std::set<const ast::Variable*>& written, Diagnostics& diagnostics);

}  // namespace burin::fx

// SPDX-License-Identifier: Apache-2.0
#pragma once
// What must hold of the whole front end for any bytes, shared by the fuzzer and the test that replays its corpus.

#include <string>

#include "fx_parser/fx_parser.h"

namespace burin::fx::fuzz {

/// Compiles the bytes as an effect: the text up to a line "//--" is the main file (a .cgfx where it begins with
/// "//cg"), the rest a file that it may include as "inner.fxh". Empty when all is well, else what is not.
inline std::string CheckEffect(const std::string& bytes) {
  const std::string separator = "\n//--\n";
  const std::size_t split = bytes.find(separator);
  const std::string path = bytes.starts_with("//cg") ? "main.cgfx" : "main.fx";
  InMemoryFileSystem files;
  files.files[path] = bytes.substr(0, split);
  files.files["inner.fxh"] = split == std::string::npos ? "" : bytes.substr(split + separator.size());
  Options options;
  options.attributes = {"color", "normal", "depth"};
  const CompileResult result = CompileEffect(path, files, options);
  int errors = 0;
  for (const Diagnostic& diagnostic : result.diagnostics) {
    errors += diagnostic.severity == Severity::kError ? 1 : 0;
    if (diagnostic.text.empty()) return "a diagnostic without a text";
    if (FormatDiagnostic(diagnostic, result.sources).empty()) return "a diagnostic that prints as nothing";
  }
  if (errors > Diagnostics::kMaxErrors) return "more errors than the limit";
  if (result.effect.has_value() != (errors == 0))
    return result.effect ? "an effect with errors" : "no effect, no errors";
  if (!result.effect) return {};
  for (const Technique& technique : result.effect->techniques) {
    for (const Pass& pass : technique.passes) {
      if (pass.program.vertex_glsl.empty() && technique.unsupported.empty()) return "a pass without its GLSL";
      for (const std::size_t s : pass.program.samplers) {
        if (s >= result.effect->samplers.size()) return "a sampler out of range";
      }
    }
    for (const ScriptStep& step : technique.script) {
      if (step.pass >= technique.passes.size()) return "a script with a pass out of range";
      if (step.texture && *step.texture >= result.effect->textures.size()) return "a script's texture out of range";
      if (step.parameter && *step.parameter >= result.effect->parameters.size())
        return "a script's parameter out of range";
    }
  }
  return {};
}

}  // namespace burin::fx::fuzz

// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the tests of the front end share: compiling a text from memory, messages as lines, GLSL validated by glslang.

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "fx_parser/fx_parser.h"

namespace burin::fx::test {

inline const std::vector<std::string>& Attributes() {
  static const std::vector<std::string> names = {"color",  "intensity", "alpha",    "albedo", "depth",
                                                 "normal", "position",  "objectid", "video"};
  return names;
}

inline CompileResult Compile(const std::string& text) {
  InMemoryFileSystem files;
  files.files["test.fx"] = text;
  Options options;
  options.attributes = Attributes();
  return CompileEffect("test.fx", files, options);
}

/// "3:5: error: undeclared identifier 'x' [X3004]", a line each, notes indented below.
inline std::string Messages(const CompileResult& result) {
  std::string text;
  const auto place = [](const Range& range) {
    return std::to_string(range.begin.line) + ":" + std::to_string(range.begin.column) + ": ";
  };
  for (const Diagnostic& d : result.diagnostics) {
    const char* severity = d.severity == Severity::kError     ? "error: "
                           : d.severity == Severity::kWarning ? "warning: "
                                                              : "note: ";
    text += place(d.range) + severity + d.text + " [" + d.code + "]\n";
    for (const Note& note : d.notes) text += "  " + place(note.range) + "note: " + note.text + "\n";
  }
  return text;
}

inline std::string Messages(const std::string& text) { return Messages(Compile(text)); }

inline bool HasGlslang() {
  static const bool has = std::system("glslangValidator --version > /dev/null 2>&1") == 0;
  return has;
}

/// Links the pair with glslangValidator; empty when it is valid, else the log.
inline std::string GlslLog(const ShaderProgram& program) {
  const std::string stem =
      (std::filesystem::temp_directory_path() / ("burin_glsl_" + std::to_string(getpid()))).string();
  std::ofstream(stem + ".vert") << program.vertex_glsl;
  std::ofstream(stem + ".frag") << program.fragment_glsl;
  const std::string command = "glslangValidator -l " + stem + ".vert " + stem + ".frag > " + stem + ".log 2>&1";
  const bool valid = std::system(command.c_str()) == 0;
  std::stringstream log;
  log << std::ifstream(stem + ".log").rdbuf();
  for (const char* suffix : {".vert", ".frag", ".log"}) std::filesystem::remove(stem + suffix);
  return valid ? "" : log.str() + program.vertex_glsl + program.fragment_glsl;
}

/// Validates many programs in one run of glslangValidator, each stage by itself; empty when all are valid, else the
/// log.
inline std::string GlslLogOfAll(const std::vector<const ShaderProgram*>& programs) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("burin_glsl_all_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  for (std::size_t i = 0; i < programs.size(); ++i) {
    const std::string stem = (folder / std::to_string(i)).string();
    std::ofstream(stem + ".vert") << programs[i]->vertex_glsl;
    std::ofstream(stem + ".frag") << programs[i]->fragment_glsl;
  }
  const std::string list = (folder / "log").string();
  const std::string command = "cd " + folder.string() + " && glslangValidator *.vert *.frag > log 2>&1";
  const bool valid = std::system(command.c_str()) == 0;
  std::stringstream log;
  log << std::ifstream(list).rdbuf();
  std::filesystem::remove_all(folder);
  return valid ? "" : log.str();
}

/// An effect whose pixel shader has this body; `declarations` stand before it.
inline std::string PixelEffect(const std::string& body, const std::string& declarations = "") {
  return declarations + "\nfloat4 PS(float4 t : TEXCOORD0) : COLOR { " + body +
         " }\ntechnique T { pass P { PixelShader = compile ps_3_0 PS(); } }\n";
}

inline std::string DataFile(const std::string& name) {
  const char* root = std::getenv("BURIN_SOURCE_DIR");
  return (std::filesystem::path(root != nullptr ? root : ".") / "tests/data/fx" / name).string();
}

}  // namespace burin::fx::test

// SPDX-License-Identifier: Apache-2.0
#include "core/gl/program.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <utility>
#include <vector>

#include "core/gl/debug.h"
#include "core/gl/program_cache.h"

namespace burin::gl {
namespace {

// A driver's update makes old binaries useless, and two drivers may share one cache.
std::string DriverIdentity() {
  std::string identity;
  for (const GLenum name : {GL_VENDOR, GL_RENDERER, GL_VERSION, GL_SHADING_LANGUAGE_VERSION}) {
    const auto* text = reinterpret_cast<const char*>(glGetString(name));
    identity += text == nullptr ? "" : text;
    identity += '\n';
  }
  return identity;
}

std::string CacheKey(const ProgramText& text) {
  std::string key = DriverIdentity();
  key += text.vertex;
  key += '\0';
  key += text.fragment;
  for (const std::string_view stage : {text.geometry, text.compute}) {
    if (stage.empty()) continue;
    key += '\0';
    key += stage;
  }
  return key;
}

std::string_view StageName(GLenum stage) {
  switch (stage) {
    case GL_VERTEX_SHADER:
      return "vertex";
    case GL_GEOMETRY_SHADER:
      return "geometry";
    case GL_COMPUTE_SHADER:
      return "compute";
    default:
      return "fragment";
  }
}

std::string_view SourceLine(std::string_view source, int number) {
  for (int line = 1; line < number && !source.empty(); ++line) {
    const std::size_t end = source.find('\n');
    source.remove_prefix(end == std::string_view::npos ? source.size() : end + 1);
  }
  return source.substr(0, source.find('\n'));
}

// The first line number of a log: "0:12(34): error: ..." (Mesa), "0(12) : error ..." (NVIDIA).
int LineOfLog(std::string_view log) {
  std::size_t at = log.find_first_of(":(");
  while (at != std::string_view::npos && at + 1 < log.size() &&
         std::isdigit(static_cast<unsigned char>(log[at + 1])) == 0) {
    at = log.find_first_of(":(", at + 1);
  }
  return at == std::string_view::npos || at + 1 >= log.size() ? 0
                                                              : std::atoi(std::string(log.substr(at + 1, 8)).c_str());
}

std::string LogOf(GLuint object, bool is_program) {
  GLint length = 0;
  is_program ? glGetProgramiv(object, GL_INFO_LOG_LENGTH, &length) : glGetShaderiv(object, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
  GLsizei written = 0;
  is_program ? glGetProgramInfoLog(object, length, &written, log.data())
             : glGetShaderInfoLog(object, length, &written, log.data());
  log.resize(static_cast<std::size_t>(written));
  while (!log.empty() && std::isspace(static_cast<unsigned char>(log.back())) != 0) log.pop_back();
  return log;
}

Result<GLuint> Compile(GLenum stage, std::string_view source, std::string_view label) {
  const GLuint shader = glCreateShader(stage);
  const GLchar* text = source.data();
  const auto length = static_cast<GLint>(source.size());
  glShaderSource(shader, 1, &text, &length);
  glCompileShader(shader);
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_TRUE) return shader;
  const std::string log = LogOf(shader, false);
  glDeleteShader(shader);
  const int line = LineOfLog(log);
  std::string message = fmt::format("{}: the driver refuses the {} shader:\n{}", label, StageName(stage), log);
  if (line > 0) message += fmt::format("\n{:5} | {}", line, SourceLine(source, line));
  return Fail(ErrorKind::kFailed, std::move(message));
}

bool IsLinked(GLuint program) {
  GLint linked = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  return linked == GL_TRUE;
}

Result<void> CompileAndLink(GLuint program, const ProgramText& text, std::string_view label) {
  std::vector<GLuint> shaders;
  const auto release = [&] {
    for (const GLuint shader : shaders) {
      glDetachShader(program, shader);
      glDeleteShader(shader);
    }
  };
  for (const auto& [stage, source] : {std::pair<GLenum, std::string_view>(GL_VERTEX_SHADER, text.vertex),
                                      std::pair<GLenum, std::string_view>(GL_GEOMETRY_SHADER, text.geometry),
                                      std::pair<GLenum, std::string_view>(GL_FRAGMENT_SHADER, text.fragment),
                                      std::pair<GLenum, std::string_view>(GL_COMPUTE_SHADER, text.compute)}) {
    if (source.empty()) continue;
    const Result<GLuint> shader = Compile(stage, source, label);
    if (!shader) {
      release();
      return std::unexpected(shader.error());
    }
    glAttachShader(program, *shader);
    shaders.push_back(*shader);
  }
  glProgramParameteri(program, GL_PROGRAM_BINARY_RETRIEVABLE_HINT, GL_TRUE);
  glLinkProgram(program);
  release();
  if (IsLinked(program)) return {};
  return Fail(ErrorKind::kFailed,
              fmt::format("{}: the driver cannot link the program:\n{}", label, LogOf(program, true)));
}

bool LoadBinary(GLuint program, const ProgramCache& cache, std::string_view key) {
  const std::optional<ProgramBinary> binary = cache.Load(key);
  if (!binary) return false;
  GLint count = 0;
  glGetIntegerv(GL_NUM_PROGRAM_BINARY_FORMATS, &count);
  std::vector<GLint> formats(static_cast<std::size_t>(count));
  if (count > 0) glGetIntegerv(GL_PROGRAM_BINARY_FORMATS, formats.data());
  // An unknown format is a GL error; a known one that the driver declines only leaves the program unlinked.
  if (std::ranges::find(formats, static_cast<GLint>(binary->format)) == formats.end()) return false;
  glProgramBinary(program, binary->format, binary->bytes.data(), static_cast<GLsizei>(binary->bytes.size()));
  return IsLinked(program);
}

void StoreBinary(GLuint program, const ProgramCache& cache, std::string_view key) {
  GLint size = 0;
  glGetProgramiv(program, GL_PROGRAM_BINARY_LENGTH, &size);
  if (size <= 0) return;
  ProgramBinary binary{.bytes = std::vector<std::byte>(static_cast<std::size_t>(size))};
  GLsizei written = 0;
  GLenum format = 0;
  glGetProgramBinary(program, size, &written, &format, binary.bytes.data());
  binary.format = format;
  binary.bytes.resize(static_cast<std::size_t>(written));
  cache.Store(key, binary);
}

}  // namespace

Result<Program> Program::Create(const ProgramText& text, std::string_view label) {
  AssertContextThread();
  Program program;
  program.handle_ = ProgramHandle(glCreateProgram());
  const ProgramCache cache = ProgramCache::Default();
  const std::string key = cache.enabled() ? CacheKey(text) : std::string();
  if (!cache.enabled() || !LoadBinary(program.id(), cache, key)) {
    const Result<void> linked = CompileAndLink(program.id(), text, label);
    if (!linked) return std::unexpected(linked.error());
    if (cache.enabled()) StoreBinary(program.id(), cache, key);
  }
  SetLabel(GL_PROGRAM, program.id(), label);
  return program;
}

int Program::UniformLocation(const std::string& name) const {
  const auto [entry, is_new] = locations_.try_emplace(name, -1);
  if (is_new) entry->second = glGetUniformLocation(id(), name.c_str());
  return entry->second;
}

}  // namespace burin::gl

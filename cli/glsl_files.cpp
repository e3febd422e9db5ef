// SPDX-License-Identifier: Apache-2.0
#include "cli/glsl_files.h"

#include <fmt/format.h>

#include <filesystem>
#include <span>
#include <system_error>

#include "core/base/atomic_file.h"
#include "core/base/file_io.h"

namespace burin::cli {
namespace {

// A file name's part: what shells and file systems take without ado.
std::string Part(const std::string& name, std::size_t number) {
  if (name.empty()) return fmt::format("{}", number);
  std::string part = name;
  for (char& c : part) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
    if (!plain) c = '_';
  }
  return part;
}

}  // namespace

Result<GlslFiles> GlslFiles::Create(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return Fail(ErrorKind::kFailed, fmt::format("cannot make folder '{}': {}", folder, error.message()));
  return GlslFiles(folder);
}

std::string GlslFiles::Unique(const std::string& stem) {
  std::string name = stem;
  for (int i = 2; !taken_.insert(name).second; ++i) name = fmt::format("{}-{}", stem, i);
  return name;
}

Result<void> GlslFiles::WriteFile(const std::string& name, const std::string& text) const {
  auto file = base::AtomicFile::Create((std::filesystem::path(folder_) / name).string());
  if (!file) return std::unexpected(file.error());
  if (const int error = base::WriteAll(file->descriptor(), std::as_bytes(std::span(text))); error != 0) {
    return Fail(ErrorKind::kFailed,
                fmt::format("cannot write '{}/{}': {}", folder_, name, std::generic_category().message(error)));
  }
  return file->Commit();
}

Result<void> GlslFiles::Write(const fx::Effect& effect) {
  const std::string effect_part = Part(std::filesystem::path(effect.path).stem().string(), 0);
  for (std::size_t t = 0; t < effect.techniques.size(); ++t) {
    const fx::Technique& technique = effect.techniques[t];
    for (std::size_t p = 0; p < technique.passes.size(); ++p) {
      const fx::ShaderProgram& program = technique.passes[p].program;
      if (program.vertex_glsl.empty()) continue;
      const std::string stem =
          Unique(fmt::format("{}.{}.{}", effect_part, Part(technique.name, t), Part(technique.passes[p].name, p)));
      if (auto written = WriteFile(stem + ".vert", program.vertex_glsl); !written) return written;
      if (program.fragment_glsl.empty()) continue;
      if (auto written = WriteFile(stem + ".frag", program.fragment_glsl); !written) return written;
    }
  }
  return {};
}

}  // namespace burin::cli

// SPDX-License-Identifier: Apache-2.0
#include "core/render/effect_file.h"

#include <fmt/format.h>

#include "core/gbuffer/attribute_table.h"

namespace burin::render {

std::string EffectFile::DiagnosticText(bool color) const {
  std::string text;
  for (const fx::Diagnostic& diagnostic : diagnostics) text += fx::FormatDiagnostic(diagnostic, sources, color);
  return text;
}

EffectFile CompileEffectFile(const std::string& path, const EffectOptions& options) {
  fx::Options fx_options;
  fx_options.include_folders = options.include_folders;
  fx_options.definitions = options.definitions;
  for (const gbuffer::AttributeInfo& info : gbuffer::AllAttributes()) fx_options.attributes.emplace_back(info.name);

  fx::CompileResult result = fx::CompileEffect(path, fx::DiskFileSystem(), fx_options);
  EffectFile file;
  file.path = path;
  if (result.effect) file.effect = std::make_shared<const fx::Effect>(*std::move(result.effect));
  file.diagnostics = std::move(result.diagnostics);
  file.sources = std::move(result.sources);
  for (const fx::Diagnostic& diagnostic : file.diagnostics) {
    if (diagnostic.severity == fx::Severity::kError) ++file.errors;
    if (diagnostic.severity == fx::Severity::kWarning) ++file.warnings;
  }
  return file;
}

Error ErrorOf(const EffectFile& file) {
  return {ErrorKind::kInput, fmt::format("{}: {} error{}", file.path, file.errors, file.errors == 1 ? "" : "s")};
}

}  // namespace burin::render

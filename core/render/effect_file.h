// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "fx_parser/fx_parser.h"

namespace burin::render {

struct EffectOptions {
  std::vector<std::string> include_folders;
  std::vector<std::pair<std::string, std::string>> definitions;
};

/// One effect file, compiled against the table of G-buffer attributes.
struct EffectFile {
  std::string path;
  std::shared_ptr<const fx::Effect> effect;  ///< null when there are errors
  std::vector<fx::Diagnostic> diagnostics;
  fx::SourceSet sources;
  int errors = 0;
  int warnings = 0;

  /// Every diagnostic as a compiler prints it.
  [[nodiscard]] std::string DiagnosticText(bool color) const;
};

/// Compiles one file; needs no GL device.
[[nodiscard]] EffectFile CompileEffectFile(const std::string& path, const EffectOptions& options);

/// "toon.fx: 2 errors", of kind kInput. Only for a file with errors.
[[nodiscard]] Error ErrorOf(const EffectFile& file);

}  // namespace burin::render

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>

#include "core/base/error.h"
#include "fx_parser/effect/effect.h"

namespace burin::cli {

/// Writes the shaders of an effect's passes as text files, for debuggers and other compilers.
class GlslFiles {
 public:
  /// Makes the folder. Errors: kFailed, naming it.
  [[nodiscard]] static Result<GlslFiles> Create(const std::string& folder);

  /// EFFECT.TECHNIQUE.PASS.vert and .frag for every pass that has a program. Names that are empty become numbers, what
  /// file names cannot hold becomes '_', and a name that is taken gets a number behind it.
  [[nodiscard]] Result<void> Write(const fx::Effect& effect);

 private:
  explicit GlslFiles(std::string folder) : folder_(std::move(folder)) {}
  Result<void> WriteFile(const std::string& name, const std::string& text) const;
  std::string Unique(const std::string& stem);

  std::string folder_;
  std::set<std::string> taken_;
};

}  // namespace burin::cli

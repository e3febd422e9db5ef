// SPDX-License-Identifier: Apache-2.0
#pragma once
// The front end's only door: effect text in, plain data, GLSL and diagnostics out. No GL, no scene, no third party.

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fx_parser/effect/effect.h"
#include "fx_parser/source/diagnostic.h"
#include "fx_parser/source/file_system.h"

namespace burin::fx {

struct Options {
  std::vector<std::string> include_folders;                       ///< -I, after the including file's own folder
  std::vector<std::pair<std::string, std::string>> definitions;   ///< -D NAME[=VALUE]
  std::vector<std::string> attributes;                            ///< names that GBA<attribute> may use
  std::vector<std::string> resource_extensions;                   ///< not used to open files; for messages
};

struct CompileResult {
  /// Empty when there are errors.
  std::optional<Effect> effect;
  std::vector<Diagnostic> diagnostics;   ///< in the order in which they were found
  SourceSet sources;
};

/// Preprocesses, parses, checks and writes GLSL for every technique. Never throws, never reads but through `files`.
/// Bounded: include depth, macro depth, expression depth and output size have limits that are errors.
[[nodiscard]] CompileResult CompileEffect(const std::string& path, const FileSystem& files, const Options& options);

/// The value of a parameter by its index in Effect::parameters, as the host has it now.
using ParameterLookup = std::function<const Value&(std::size_t parameter)>;

/// Evaluates a state's expression over the current parameter values.
[[nodiscard]] std::optional<Value> EvaluateExpression(const Effect&, const ast::Expression&, const ParameterLookup&);

}  // namespace burin::fx

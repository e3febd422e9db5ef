// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"

namespace burin::render {

/// An effect of the library that comes with the program.
struct ShippedEffect {
  std::string name;  ///< "edges/sobel": the path in the library without its extension
  std::string path;
  std::string purpose;  ///< the first comment line of the file that is no licence tag; may be empty
};

/// Ordered by name.
[[nodiscard]] std::vector<ShippedEffect> ShippedEffects();

/// True when the extension says that this is an effect: .fx, .fxh, .fxsub, .cgfx.
[[nodiscard]] bool IsEffectPath(const std::string& path);

/// The file of an effect argument: a path as it is, else a shipped effect by name ("edges/sobel", "edges/sobel.fx", or
/// "sobel" when only one ends so). Errors: kInput when nothing is found, naming where it was looked for and what is
/// near; kUsage when a short name means several.
[[nodiscard]] Result<std::string> FindEffect(const std::string& argument);

/// The arguments of `burin render` as effects and a source.
struct Inputs {
  std::vector<std::string> effects;  ///< files, in order
  std::string source;                ///< empty: none
};

/// Tells effects from the source: by extension, then by being a file, then as the name of a shipped effect. Errors:
/// kUsage for a second source; those of FindEffect.
[[nodiscard]] Result<Inputs> SortInputs(const std::vector<std::string>& arguments);

}  // namespace burin::render

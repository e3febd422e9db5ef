// SPDX-License-Identifier: Apache-2.0
#pragma once
// Scripts of NVIDIA's Standard Annotations and Semantics (SAS 0.8): "RenderColorTarget0=Scene; Pass=Blur; Draw=Buffer;".

#include <string>
#include <string_view>
#include <vector>

namespace burin::fx {

enum class ScriptVerb {
  kTechnique, kPass, kDraw, kColorTarget, kDepthStencilTarget, kClear, kClearSetColor, kClearSetDepth,
  kClearSetStencil, kExternal, kLoopByCount, kLoopGetIndex, kLoopEnd, kRenderPort, kSignature, kUnknown
};

struct ScriptCommand {
  ScriptVerb verb = ScriptVerb::kUnknown;
  std::string name;    ///< as written
  std::string value;   ///< behind '='; may be empty
  int index = 0;       ///< of RenderColorTarget<n>
};

/// Commands are parted by ';', doubled or left out at the end as may be; white space around names and values goes. Names
/// are matched without case.
[[nodiscard]] std::vector<ScriptCommand> ParseScript(std::string_view text);

/// For suggestions.
[[nodiscard]] std::vector<std::string> ScriptCommandNames();

/// The choices of "Technique=Technique?Main:Main10": Main, Main10. Of a plain name that name.
[[nodiscard]] std::vector<std::string> ScriptChoices(std::string_view value);

}  // namespace burin::fx

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/render/effect_file.h"

namespace burin::render {

/// What `burin info` says about an effect: in words, as JSON, and as a Graphviz graph of the data flow. `technique` is
/// what --technique asks for, empty: the first valid. Errors: those of effect::ChooseTechnique.
[[nodiscard]] Result<std::string> EffectText(const EffectFile& file, const std::string& technique);
[[nodiscard]] Result<std::string> EffectJson(const EffectFile& file, const std::string& technique);
[[nodiscard]] Result<std::string> EffectDot(const EffectFile& file, const std::string& technique);

/// The data flow of one pass: indices in Effect::textures, each once, in the order of first use.
struct PassFlow {
  std::vector<std::size_t> reads;
  std::vector<std::size_t> writes;  ///< empty: the frame
};
[[nodiscard]] PassFlow FlowOf(const fx::Effect& effect, const fx::Pass& pass);

/// "attribute normal", "result of pass 0", "file veggie.dds".
[[nodiscard]] std::string RoleText(const fx::Texture& texture);
/// "frame size", "3 x frame size".
[[nodiscard]] std::string SizeText(const fx::Texture& texture);
/// "0.5", "{0, 1, 0, 1}", "\"text\""; empty for an empty value.
[[nodiscard]] std::string ValueText(const fx::Value& value);

}  // namespace burin::render

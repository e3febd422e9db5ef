// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "fx_parser/syntax/macro_expander.h"

namespace burin::fx {

std::string_view MacroContext::Keep(std::string text, const Token& where) {
  text_bytes_ += text.size();
  if (text_bytes_ > kMaxTextBytes) {
    Stop(where, "macros make more than 16 MiB of text");
    return {};
  }
  return stream_.texts.emplace_back(std::move(text));
}

std::uint32_t MacroContext::AddExpansion(const Macro& macro, const Location& spot, std::uint32_t parent) {
  sources_.expansions.push_back({macro.name, spot, parent});
  return static_cast<std::uint32_t>(sources_.expansions.size());
}

bool MacroContext::Count(std::size_t tokens, const Token& where) {
  tokens_ += tokens;
  if (tokens_ <= kMaxTokens) return true;
  Stop(where, "macros expand to more than " + std::to_string(kMaxTokens) + " tokens");
  return false;
}

void MacroContext::Stop(const Token& where, std::string text) {
  if (!stopped_) diagnostics_.Error(where.range(), "B1003", std::move(text));
  stopped_ = true;
}

}  // namespace burin::fx

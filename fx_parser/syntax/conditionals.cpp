// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/syntax/condition.h"
#include "fx_parser/syntax/preprocessor.h"

namespace burin::fx {

namespace {

constexpr std::size_t kMaxConditionals = 1000;   // #if groups inside one another

}  // namespace

void Preprocessor::Begin(const Token& directive, bool condition) {
  if (conditionals_.size() == kMaxConditionals) {
    context_.Stop(directive, "conditional groups are nested more than 1000 deep");
    return;
  }
  const bool parent_live = live();
  conditionals_.push_back({directive, parent_live, parent_live && condition, parent_live && condition, false});
}

void Preprocessor::If(const Token& directive) {
  Begin(directive, live() && EvaluateCondition(context_, RestOfLineTokens(), directive));
}

void Preprocessor::Ifdef(const Token& directive) { IfMacro(directive, true); }

void Preprocessor::Ifndef(const Token& directive) { IfMacro(directive, false); }

void Preprocessor::IfMacro(const Token& directive, bool wanted) {
  Token name;
  bool condition = false;
  if (live() && ExpectMacroName(directive, name)) condition = (context_.macros.Find(name.text) != nullptr) == wanted;
  Begin(directive, condition);
}

// The #if that this #elif, #else or #endif of the same file belongs to.
Preprocessor::Conditional* Preprocessor::InnermostOf(const Token& directive) {
  if (conditionals_.size() > inputs_.back().conditionals) return &conditionals_.back();
  diagnostics_.Error(directive.range(), "B1008", "#" + std::string(directive.text) + " without #if");
  return nullptr;
}

void Preprocessor::Elif(const Token& directive) {
  Conditional* conditional = InnermostOf(directive);
  if (!conditional) return;
  if (conditional->has_else) {
    diagnostics_.Error(directive.range(), "B1008", "#elif after #else")
        .notes.push_back({conditional->directive.range(), "the group begins here"});
  }
  const bool candidate = conditional->parent_live && !conditional->taken && !conditional->has_else;
  conditional->live = candidate && EvaluateCondition(context_, RestOfLineTokens(), directive);
  conditional->taken |= conditional->live;
}

void Preprocessor::Else(const Token& directive) {
  Conditional* conditional = InnermostOf(directive);
  if (!conditional) return;
  if (conditional->has_else) {
    diagnostics_.Error(directive.range(), "B1008", "a second #else")
        .notes.push_back({conditional->directive.range(), "the group begins here"});
  }
  conditional->live = conditional->parent_live && !conditional->taken;
  conditional->taken = true;
  conditional->has_else = true;
}

void Preprocessor::Endif(const Token& directive) {
  if (InnermostOf(directive)) conditionals_.pop_back();
}

}  // namespace burin::fx

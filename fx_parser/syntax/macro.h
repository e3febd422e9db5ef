// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fx_parser/syntax/token.h"

namespace burin::fx {

struct Macro {
  enum class Builtin : std::uint8_t { kNone, kFile, kLine };
  std::string name;
  Range definition;                ///< of the name in its #define; no file for the host's
  bool is_function = false;
  bool is_variadic = false;        ///< the last parameter is __VA_ARGS__
  Builtin builtin = Builtin::kNone;
  std::vector<std::string> parameters;
  std::vector<Token> body;
  int active = 0;                  ///< expansions of it that are not finished: meanwhile its name stands for itself

  [[nodiscard]] std::optional<std::size_t> ParameterIndex(const Token& token) const;
  /// Same kind, parameters and body: a second definition like this is harmless.
  [[nodiscard]] bool SameAs(const Macro& other) const;
};

class MacroTable {
 public:
  void Define(std::shared_ptr<Macro> macro);
  void Undefine(std::string_view name);
  [[nodiscard]] std::shared_ptr<Macro> Find(std::string_view name) const;
  /// Grows whenever any definition changes: equal versions mean equal tables.
  [[nodiscard]] std::uint64_t version() const { return version_; }

 private:
  std::map<std::string, std::shared_ptr<Macro>, std::less<>> macros_;
  std::uint64_t version_ = 0;
};

}  // namespace burin::fx

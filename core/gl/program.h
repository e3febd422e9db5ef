// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>

#include "core/base/error.h"
#include "core/gl/handle.h"

namespace burin::gl {

/// The texts of a program's stages; an empty one is left out.
struct ProgramText {
  std::string_view vertex;
  std::string_view geometry;
  std::string_view fragment;      ///< empty: depth and stencil only
  std::string_view compute = {};  ///< alone
};

/// A linked vertex (+ geometry) + fragment program, or a compute program. Linked binaries are kept in
/// $XDG_CACHE_HOME/burin/programs (or ~/.cache), keyed by a hash of the texts and the driver's identity; a stale or
/// damaged entry is compiled anew. BURIN_NO_CACHE=1 turns it off.
class Program {
 public:
  Program() = default;
  /// Errors: kFailed with the driver's log and the numbered source line it names: a bug of ours, since the front end
  /// has checked the effect.
  [[nodiscard]] static Result<Program> Create(const ProgramText& text, std::string_view label);
  [[nodiscard]] static Result<Program> Create(std::string_view vertex, std::string_view fragment,
                                              std::string_view label) {
    return Create({vertex, {}, fragment}, label);
  }

  [[nodiscard]] std::uint32_t id() const { return handle_.id(); }
  /// -1 when the program does not use it. Cached.
  [[nodiscard]] int UniformLocation(const std::string& name) const;
  explicit operator bool() const { return static_cast<bool>(handle_); }

 private:
  ProgramHandle handle_;
  mutable std::unordered_map<std::string, int> locations_;
};

}  // namespace burin::gl

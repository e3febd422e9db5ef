// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "fx_parser/source/source.h"

namespace burin::fx {

enum class Severity { kNote, kWarning, kError };

struct Note {
  Range range;
  std::string text;
};

/// One message. `code` is FXC's number where FXC has the same condition ("X3000"), a "B...." of ours elsewhere.
struct Diagnostic {
  Severity severity = Severity::kError;
  Range range;
  std::string text;   ///< no capital, no full stop: "expected ';' after render state"
  std::string code;
  std::vector<Note> notes;
};

/// Collects diagnostics in order. After kMaxErrors errors `exhausted()` is true and further errors are dropped; the
/// front end then stops as soon as it can.
class Diagnostics {
 public:
  static constexpr int kMaxErrors = 20;
  static constexpr int kMaxWarnings = 100;   ///< further ones are dropped, so that hostile texts cannot fill memory

  /// The returned reference lets the caller add notes; valid until the next call.
  Diagnostic& Error(const Range& range, std::string code, std::string text);
  Diagnostic& Warning(const Range& range, std::string code, std::string text);

  [[nodiscard]] bool has_errors() const { return errors_ > 0; }
  [[nodiscard]] int error_count() const { return errors_; }
  [[nodiscard]] bool exhausted() const { return errors_ >= kMaxErrors; }
  [[nodiscard]] const std::vector<Diagnostic>& all() const { return all_; }
  [[nodiscard]] std::vector<Diagnostic> Take();

 private:
  std::vector<Diagnostic> all_;
  Diagnostic dropped_;
  int errors_ = 0;
};

/// One diagnostic as a compiler prints it: `toon.fx:12:17: error: expected ... [X3000]`, the source line, a caret line
/// (tabs kept so that the caret stands right), the chain of #include and macro notes, then its own notes.
/// `color` adds ANSI colours. Ends with a newline.
[[nodiscard]] std::string FormatDiagnostic(const Diagnostic&, const SourceSet&, bool color = false);

/// The nearest of `candidates` to `name` (edit distance, case ignored), or empty when none is near.
[[nodiscard]] std::string NearestName(const std::string& name, const std::vector<std::string>& candidates);

}  // namespace burin::fx

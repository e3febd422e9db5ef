// SPDX-License-Identifier: Apache-2.0
#include "fx_parser/source/diagnostic.h"

#include <utility>

namespace burin::fx {

Diagnostic& Diagnostics::Error(const Range& range, std::string code, std::string text) {
  if (exhausted()) {
    dropped_ = {};
    return dropped_;
  }
  ++errors_;
  all_.push_back({Severity::kError, range, std::move(text), std::move(code), {}});
  return all_.back();
}

Diagnostic& Diagnostics::Warning(const Range& range, std::string code, std::string text) {
  if (exhausted() || static_cast<int>(all_.size()) - errors_ >= kMaxWarnings) {
    dropped_ = {};
    return dropped_;
  }
  all_.push_back({Severity::kWarning, range, std::move(text), std::move(code), {}});
  return all_.back();
}

std::vector<Diagnostic> Diagnostics::Take() {
  errors_ = 0;
  return std::exchange(all_, {});
}

}  // namespace burin::fx

// SPDX-License-Identifier: Apache-2.0
// The messages of Open Job Description's "How Jobs Are Run": a percentage, a status line, and the reason of a failure.
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "cli/progress_modes.h"

namespace burin::cli {
namespace {

std::string OneLine(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  return text;
}

}  // namespace

void OpenJdProgress::OnStarted() { Write("openjd_status: rendering\n"); }

void OpenJdProgress::OnFrame(long frame, const std::string& path) {
  if (total() > 0) {
    const double percent = std::min(100.0, 100.0 * static_cast<double>(done()) / static_cast<double>(total()));
    Write(fmt::format("openjd_progress: {:.2f}\n", percent));
  }
  Write(fmt::format("openjd_status: frame {} {}\n", frame, OneLine(path)));
}

void OpenJdProgress::OnFinished(const Result<void>& result, long frames_done) {
  if (result) {
    Write(fmt::format("openjd_status: done, {} frames\n", frames_done));
  } else {
    Write(fmt::format("openjd_fail: {}\n", OneLine(result.error().message)));
  }
}

}  // namespace burin::cli

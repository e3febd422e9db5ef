// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "cli/progress_modes.h"

namespace burin::cli {
namespace {

constexpr int kBarColumns = 30;
constexpr std::chrono::milliseconds kRedraw{100};
constexpr const char* kClearLine = "\r\x1b[K";

std::string Duration(double seconds) {
  const long whole = static_cast<long>(seconds + 0.5);
  return whole >= 3600 ? fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60)
                       : fmt::format("{}:{:02}", whole / 60, whole % 60);
}

}  // namespace

void BarProgress::OnStarted() {
  started_ = drawn_ = Clock::now();
  Draw();
}

void BarProgress::OnFrame(long, const std::string&) {
  if (Clock::now() - drawn_ >= kRedraw) Draw();
}

bool BarProgress::OnMessage(const char*, const std::string&) {
  Write(kClearLine);
  return false;
}

void BarProgress::OnFinished(const Result<void>& result, long frames_done) {
  Write(kClearLine);
  if (!result || frames_done == 0) return;
  const double seconds = std::chrono::duration<double>(Clock::now() - started_).count();
  Write(fmt::format("{} frame{} in {:.1f} s\n", frames_done, frames_done == 1 ? "" : "s", seconds));
}

void BarProgress::Draw() {
  drawn_ = Clock::now();
  const double seconds = std::chrono::duration<double>(drawn_ - started_).count();
  const double rate = seconds > 0.0 ? static_cast<double>(done()) / seconds : 0.0;
  if (total() <= 0) {
    Write(fmt::format("{}frame {}  {:.1f}/s", kClearLine, done(), rate));
    return;
  }
  const double share = std::min(1.0, static_cast<double>(done()) / static_cast<double>(total()));
  const auto filled = static_cast<std::size_t>(share * kBarColumns);
  const std::string left =
      rate > 0.0 ? Duration(static_cast<double>(std::max(0L, total() - done())) / rate) : std::string("-:--");
  Write(fmt::format("{}[{}{}] {}/{}  {:.1f}/s  {} left", kClearLine, std::string(filled, '='),
                    std::string(kBarColumns - filled, ' '), done(), total(), rate, left));
}

}  // namespace burin::cli

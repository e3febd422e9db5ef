// SPDX-License-Identifier: Apache-2.0
#include <cstring>
#include <nlohmann/json.hpp>

#include "cli/progress_modes.h"

namespace burin::cli {
namespace {

std::string Line(const nlohmann::ordered_json& event) {
  // Paths may hold bytes that are no UTF-8; an event must not fail for them.
  return event.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace

void JsonProgress::OnDevice(const std::string& renderer) {
  renderer_ = renderer;
  Write(Line({{"event", "device"}, {"renderer", renderer}}));
}

void JsonProgress::OnStarted() {
  nlohmann::ordered_json event = {{"event", "start"}};
  event["frames"] = total() < 0 ? nlohmann::ordered_json() : nlohmann::ordered_json(total());
  Write(Line(event));
}

void JsonProgress::OnFrame(long frame, const std::string& path) {
  Write(Line({{"event", "frame"}, {"frame", frame}, {"path", path}, {"done", done()}}));
}

void JsonProgress::OnFrameFailed(long frame, const std::string& message) {
  Write(Line({{"event", "frame_failed"}, {"frame", frame}, {"message", message}}));
}

bool JsonProgress::OnMessage(const char* level, const std::string& text) {
  if (std::strcmp(level, "warning") != 0 && std::strcmp(level, "info") != 0) return false;
  Write(Line({{"event", level}, {"message", text}}));
  return true;
}

void JsonProgress::OnFinished(const Result<void>& result, long frames_done) {
  nlohmann::ordered_json event = {
      {"event", "end"}, {"status", result ? "done" : "failed"}, {"frames", frames_done}, {"renderer", renderer_}};
  if (!result) {
    event["exit_status"] = static_cast<int>(result.error().kind);
    event["message"] = result.error().message;
  }
  Write(Line(event));
}

}  // namespace burin::cli

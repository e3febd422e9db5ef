// SPDX-License-Identifier: Apache-2.0
#include "core/gl/context.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <thread>
#include <utility>

#include "core/base/cpu.h"
#include "core/gl/debug.h"
#include "core/gl/device_choice.h"
#include "core/gl/egl_context.h"
#include "core/gl/state.h"

namespace burin::gl {
namespace {

std::optional<std::thread::id> context_thread;

std::string GlText(GLenum name) {
  const auto* text = reinterpret_cast<const char*>(glGetString(name));
  return text == nullptr ? std::string() : std::string(text);
}

int GlInteger(GLenum name) {
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

DeviceInfo QueryInfo() {
  DeviceInfo info;
  info.renderer = GlText(GL_RENDERER);
  info.vendor = GlText(GL_VENDOR);
  info.version = GlText(GL_VERSION);
  info.is_software = IsSoftwareRenderer(info.renderer);
  info.max_texture_size = GlInteger(GL_MAX_TEXTURE_SIZE);
  info.max_draw_buffers = std::min(GlInteger(GL_MAX_DRAW_BUFFERS), GlInteger(GL_MAX_COLOR_ATTACHMENTS));
  info.max_samples = GlInteger(GL_MAX_SAMPLES);
  return info;
}

struct Opened {
  EglContext context;
  DeviceInfo info;
};

// Why a context that opened is still not what was asked for; empty: it is.
std::string Mismatch(const DeviceChoice& choice, const Candidate& candidate, const DeviceInfo& info) {
  if (candidate.must_match_renderer && !ContainsName(info.renderer, choice.name)) {
    return fmt::format("its renderer is '{}'", info.renderer);
  }
  if (choice.kind == DeviceChoice::Kind::kSoftware && !info.is_software) {
    return fmt::format("its renderer is '{}', no software", info.renderer);
  }
  // A hardware node whose driver is missing comes up as software: keep it for later, as auto's order demands.
  const bool wants_hardware = candidate.device.handle != nullptr && !candidate.device.is_software;
  if (wants_hardware && info.is_software)
    return fmt::format("its driver is missing, it renders by '{}'", info.renderer);
  return {};
}

std::string NothingToTry(const DeviceChoice& choice, const EglDevices& found, std::string_view text) {
  std::string message = fmt::format("--device {}: no such device", text);
  if (choice.kind == DeviceChoice::Kind::kAuto || choice.kind == DeviceChoice::Kind::kSoftware) {
    message = fmt::format("--device {}: no usable GL device", text);
  }
  if (found.devices.empty()) return message + ": " + found.problem;
  message += "; there are:";
  for (const EglDevice& device : found.devices) message += "\n  " + device.Describe();
  return message;
}

Result<Opened> OpenFirst(const ContextOptions& options) {
  const Result<DeviceChoice> choice = ParseDeviceChoice(options.device);
  if (!choice) return std::unexpected(choice.error());
  const EglDevices found = EnumerateEglDevices();
  const std::vector<Candidate> candidates = Candidates(*choice, found);
  if (candidates.empty()) return Fail(ErrorKind::kDevice, NothingToTry(*choice, found, options.device));

  std::string tried;
  for (const Candidate& candidate : candidates) {
    Result<EglContext> context = EglContext::Open(candidate.device, options.debug);
    std::string reason;
    if (context) {
      Opened opened{.context = std::move(*context), .info = QueryInfo()};
      reason = Mismatch(*choice, candidate, opened.info);
      if (reason.empty()) return opened;
    } else {
      reason = context.error().message;
    }
    tried += fmt::format("\n  {}: {}", candidate.device.Describe(), reason);
  }
  return Fail(ErrorKind::kDevice, fmt::format("--device {}: no usable GL device; tried:{}", options.device, tried));
}

}  // namespace

struct Context::State {
  EglContext egl;
  DeviceInfo info;
};

void SetDriverEnvironment(int threads) {
  // llvmpipe reads its thread count once, when the driver starts.
  const int count = threads > 0 ? threads : base::AvailableThreads();
  setenv("LP_NUM_THREADS", std::to_string(count).c_str(), threads > 0 ? 1 : 0);
  // Mesa's loader prints its own warnings about missing render nodes; ours says what was tried.
  setenv("EGL_LOG_LEVEL", "fatal", 0);
}

Context::Context() : state_(std::make_unique<State>()) {}

Context::~Context() { context_thread.reset(); }

const DeviceInfo& Context::info() const { return state_->info; }

Result<std::unique_ptr<Context>> Context::Create(const ContextOptions& options) {
  if (context_thread) return Fail(ErrorKind::kFailed, "a GL context is open already; there is one a process");
  Result<Opened> opened = OpenFirst(options);
  if (!opened) return std::unexpected(std::move(opened.error()));

  std::unique_ptr<Context> context(new Context());
  context->state_->egl = std::move(opened->context);
  context->state_->info = std::move(opened->info);
  context_thread = std::this_thread::get_id();
  if (options.debug) AbortOnDriverErrors();
  SetConventions();
  return context;
}

void AssertContextThread() {
  if (context_thread == std::this_thread::get_id()) return;
  std::fprintf(stderr, "burin: GL used %s\n",
               context_thread ? "on another thread than its context's" : "without a context");
  std::abort();
}

std::vector<std::string> ListDevices() {
  const EglDevices found = EnumerateEglDevices();
  std::vector<std::string> lines;
  for (const EglDevice& device : found.devices) lines.push_back(device.Describe());
  if (found.has_surfaceless) lines.push_back(EglDevice{}.Describe());
  if (lines.empty()) lines.push_back("none: " + found.problem);
  return lines;
}

}  // namespace burin::gl

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"

namespace burin::gl {

struct DeviceInfo {
  std::string renderer;  ///< GL_RENDERER
  std::string vendor;
  std::string version;  ///< GL_VERSION
  bool is_software = false;
  int max_texture_size = 0;
  int max_draw_buffers = 0;
  int max_samples = 0;
};

/// Tells software drivers, through the environment, how many threads to take (0: as many as the affinity mask has) and
/// to keep their warnings to themselves. Once, before the process starts any thread: the environment may not change
/// while another thread, or the constructor of a library that it loads, reads it. What the user set stands, but for
/// `threads`.
void SetDriverEnvironment(int threads);

struct ContextOptions {
  std::string device = "auto";  ///< auto|software|N|cuda:N|NAME, as --device
  bool debug = false;           ///< a debug context: every KHR_debug error or undefined behaviour aborts (tests)
};

/// A surfaceless EGL display with a GL 4.5 core context, current on the thread that made it. One at a time a process;
/// it outlives every GL object. Conventions set for its life: glClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE), so that row
/// 0 is the top row of every target and clip z is 0..w; pixel store alignment 1; no dithering; seamless cube maps.
class Context {
 public:
  /// Errors: kDevice, saying what was tried and why each failed; kUsage for a malformed `device`.
  [[nodiscard]] static Result<std::unique_ptr<Context>> Create(const ContextOptions& options);
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  [[nodiscard]] const DeviceInfo& info() const;

 private:
  Context();
  struct State;
  std::unique_ptr<State> state_;
};

/// The devices that `--device` can name, a line each, for messages and `--version --verbose`.
[[nodiscard]] std::vector<std::string> ListDevices();

}  // namespace burin::gl

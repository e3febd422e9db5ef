// SPDX-License-Identifier: Apache-2.0
#pragma once
// What --device asks for, and the order in which devices are tried. No EGL, no GL.

#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/gl/egl_device.h"

namespace burin::gl {

struct DeviceChoice {
  enum class Kind { kAuto, kSoftware, kIndex, kCuda, kName };
  Kind kind = Kind::kAuto;
  int number = 0;      ///< of kIndex and kCuda
  std::string name{};  ///< of kName, as given
};

/// Errors: kUsage for an empty text, a number out of range, "cuda:" without a number.
[[nodiscard]] Result<DeviceChoice> ParseDeviceChoice(std::string_view text);

/// A device to try; `must_match_renderer`: it counts only if GL_RENDERER holds the name that was asked for.
struct Candidate {
  EglDevice device;
  bool must_match_renderer = false;
};

/// Hardware first, then software, then the surfaceless platform, which is tried last since Mesa may give it any driver.
[[nodiscard]] std::vector<Candidate> Candidates(const DeviceChoice& choice, const EglDevices& found);

/// By GL_RENDERER: llvmpipe, softpipe, swrast, SWR, SwiftShader, "Software Rasterizer".
[[nodiscard]] bool IsSoftwareRenderer(std::string_view renderer);

/// Case is ignored.
[[nodiscard]] bool ContainsName(std::string_view text, std::string_view name);

}  // namespace burin::gl

// SPDX-License-Identifier: Apache-2.0
#pragma once
// The EGL displays of this machine, as --device sees them. EGL's types stay in the .cpp files.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burin::gl {

/// True when `list`, words separated by spaces, holds `token` as a whole word. EGL_EXT_device_drm is a prefix of
/// EGL_EXT_device_drm_render_node, so a plain search is not enough.
[[nodiscard]] bool HasToken(std::string_view list, std::string_view token);

struct EglDevice {
  void* handle = nullptr;    ///< EGLDeviceEXT; null for the surfaceless platform
  int index = -1;            ///< as EGL enumerates them: what `--device N` takes; -1 for the surfaceless platform
  std::string name;          ///< EGL's name of the renderer, where the driver tells it
  std::string primary_node;  ///< "/dev/dri/card0" or empty
  std::string render_node;   ///< "/dev/dri/renderD128" or empty
  std::optional<int> cuda;   ///< CUDA's number of it
  bool is_software = false;

  /// "device 0 (/dev/dri/renderD128, cuda:0)", "the surfaceless platform"
  [[nodiscard]] std::string Describe() const;
};

/// Why there is nothing to enumerate: no libEGL, or empty.
struct EglDevices {
  std::vector<EglDevice> devices;
  bool has_surfaceless = false;  ///< EGL_MESA_platform_surfaceless
  std::string problem;           ///< why `devices` is empty; empty when it is not
};

/// Asks EGL; starts no driver.
[[nodiscard]] EglDevices EnumerateEglDevices();

}  // namespace burin::gl

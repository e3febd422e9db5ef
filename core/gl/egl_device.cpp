// SPDX-License-Identifier: Apache-2.0
#include "core/gl/egl_device.h"

#include <dlfcn.h>
#include <epoxy/egl.h>
#include <fmt/format.h>

#include <array>

namespace burin::gl {
namespace {

// EGL_EXT_device_query_name; epoxy 1.5.10 knows the extension's number but Mesa 22.3 lists it only on some devices.
constexpr EGLint kRendererName = 0x335F;
constexpr EGLint kCudaDevice = 0x323A;         // EGL_NV_device_cuda
constexpr EGLint kDrmDeviceFile = 0x3233;      // EGL_EXT_device_drm
constexpr EGLint kDrmRenderNodeFile = 0x3377;  // EGL_EXT_device_drm_render_node

using QueryDevices = EGLBoolean (*)(EGLint, void**, EGLint*);
using QueryDeviceString = const char* (*)(void*, EGLint);
using QueryDeviceAttrib = EGLBoolean (*)(void*, EGLint, EGLAttrib*);

// Straight from libEGL: epoxy's own look-up of client extensions aborts the process when one is missing.
template <class Function>
Function Entry(const char* name) {
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}

std::string DeviceString(QueryDeviceString query, void* device, EGLint name) {
  const char* text = query(device, name);
  return text == nullptr ? std::string() : std::string(text);
}

EglDevice Inspect(void* handle, int index) {
  EglDevice device;
  device.handle = handle;
  device.index = index;
  const auto query_string = Entry<QueryDeviceString>("eglQueryDeviceStringEXT");
  const auto query_attrib = Entry<QueryDeviceAttrib>("eglQueryDeviceAttribEXT");
  if (query_string == nullptr) return device;
  const std::string extensions = DeviceString(query_string, handle, EGL_EXTENSIONS);
  device.is_software = HasToken(extensions, "EGL_MESA_device_software");
  if (HasToken(extensions, "EGL_EXT_device_query_name"))
    device.name = DeviceString(query_string, handle, kRendererName);
  if (HasToken(extensions, "EGL_EXT_device_drm"))
    device.primary_node = DeviceString(query_string, handle, kDrmDeviceFile);
  if (HasToken(extensions, "EGL_EXT_device_drm_render_node")) {
    device.render_node = DeviceString(query_string, handle, kDrmRenderNodeFile);
  }
  EGLAttrib cuda = 0;
  if (query_attrib != nullptr && HasToken(extensions, "EGL_NV_device_cuda") &&
      query_attrib(handle, kCudaDevice, &cuda) == EGL_TRUE) {
    device.cuda = static_cast<int>(cuda);
  }
  return device;
}

}  // namespace

bool HasToken(std::string_view list, std::string_view token) {
  while (!list.empty()) {
    const std::size_t end = list.find(' ');
    if (list.substr(0, end) == token) return true;
    if (end == std::string_view::npos) break;
    list.remove_prefix(end + 1);
  }
  return false;
}

std::string EglDevice::Describe() const {
  if (handle == nullptr) return "the surfaceless platform";
  std::string details;
  const auto add = [&](const std::string& text) {
    if (!text.empty()) details += (details.empty() ? "" : ", ") + text;
  };
  add(name);
  add(render_node.empty() ? primary_node : render_node);
  if (cuda) add(fmt::format("cuda:{}", *cuda));
  if (is_software) add("software");
  return details.empty() ? fmt::format("device {}", index) : fmt::format("device {} ({})", index, details);
}

EglDevices EnumerateEglDevices() {
  EglDevices found;
  // epoxy aborts the process when libEGL is missing, so look first. The handle stays open: epoxy uses the same one.
  if (dlopen("libEGL.so.1", RTLD_LAZY | RTLD_LOCAL) == nullptr) {
    found.problem = "libEGL.so.1 cannot be loaded (Debian package libegl1)";
    return found;
  }
  const char* text = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const std::string extensions = text == nullptr ? "" : text;
  found.has_surfaceless = HasToken(extensions, "EGL_MESA_platform_surfaceless");
  const bool can_enumerate =
      HasToken(extensions, "EGL_EXT_device_base") || HasToken(extensions, "EGL_EXT_device_enumeration");
  const auto query = Entry<QueryDevices>("eglQueryDevicesEXT");
  if (!can_enumerate || !HasToken(extensions, "EGL_EXT_platform_device") || query == nullptr) {
    found.problem = "EGL cannot enumerate devices (no EGL_EXT_device_enumeration or EGL_EXT_platform_device)";
    return found;
  }
  std::array<void*, 64> handles{};
  EGLint count = 0;
  if (query(static_cast<EGLint>(handles.size()), handles.data(), &count) != EGL_TRUE || count == 0) {
    found.problem = "EGL knows no device";
    return found;
  }
  for (int i = 0; i < count; ++i) found.devices.push_back(Inspect(handles[static_cast<std::size_t>(i)], i));
  return found;
}

}  // namespace burin::gl

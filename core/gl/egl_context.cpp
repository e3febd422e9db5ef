// SPDX-License-Identifier: Apache-2.0
#include "core/gl/egl_context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fmt/format.h>

#include <utility>

namespace burin::gl {
namespace {

std::string EglErrorName(EGLint code) {
  switch (code) {
    case EGL_SUCCESS:
      return "no reason given";
    case EGL_NOT_INITIALIZED:
      return "EGL_NOT_INITIALIZED";
    case EGL_BAD_ACCESS:
      return "EGL_BAD_ACCESS";
    case EGL_BAD_ALLOC:
      return "EGL_BAD_ALLOC";
    case EGL_BAD_ATTRIBUTE:
      return "EGL_BAD_ATTRIBUTE";
    case EGL_BAD_CONFIG:
      return "EGL_BAD_CONFIG";
    case EGL_BAD_DISPLAY:
      return "EGL_BAD_DISPLAY";
    case EGL_BAD_MATCH:
      return "EGL_BAD_MATCH";
    case EGL_BAD_PARAMETER:
      return "EGL_BAD_PARAMETER";
    default:
      return fmt::format("EGL error 0x{:04x}", code);
  }
}

std::unexpected<Error> EglFail(const char* what) {
  return Fail(ErrorKind::kDevice, fmt::format("{} ({})", what, EglErrorName(eglGetError())));
}

EGLDisplay DisplayOf(const EglDevice& device) {
  const auto get =
      reinterpret_cast<EGLDisplay (*)(EGLenum, void*, const EGLint*)>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (get == nullptr) return EGL_NO_DISPLAY;
  if (device.handle != nullptr) return get(EGL_PLATFORM_DEVICE_EXT, device.handle, nullptr);
  return get(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
}

// Any configuration will do, since no surface is ever made; drivers without EGL_KHR_no_config_context want one.
EGLConfig AnyConfig(EGLDisplay display, std::string_view extensions) {
  if (HasToken(extensions, "EGL_KHR_no_config_context") || HasToken(extensions, "EGL_MESA_configless_context")) {
    return EGL_NO_CONFIG_KHR;
  }
  const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_DONT_CARE, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = EGL_NO_CONFIG_KHR;
  EGLint count = 0;
  eglChooseConfig(display, wanted, &config, 1, &count);
  return config;
}

EGLContext CreateCoreContext(EGLDisplay display, std::string_view extensions, bool debug) {
  const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                               4,
                               EGL_CONTEXT_MINOR_VERSION,
                               5,
                               EGL_CONTEXT_OPENGL_PROFILE_MASK,
                               EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                               EGL_CONTEXT_OPENGL_DEBUG,
                               debug ? EGL_TRUE : EGL_FALSE,
                               EGL_NONE};
  return eglCreateContext(display, AnyConfig(display, extensions), EGL_NO_CONTEXT, attributes);
}

}  // namespace

EglContext::EglContext(EglContext&& other) noexcept
    : display_(std::exchange(other.display_, nullptr)), context_(std::exchange(other.context_, nullptr)) {}

EglContext& EglContext::operator=(EglContext&& other) noexcept {
  if (this != &other) {
    Close();
    display_ = std::exchange(other.display_, nullptr);
    context_ = std::exchange(other.context_, nullptr);
  }
  return *this;
}

EglContext::~EglContext() { Close(); }

// The display stays initialised: EGL shares it with the whole process and hands it out again, and terminating it would
// unload the driver under the tools that name its leaks.
void EglContext::Close() {
  if (display_ == nullptr) return;
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  if (context_ != nullptr) eglDestroyContext(display_, context_);
  display_ = nullptr;
  context_ = nullptr;
}

Result<EglContext> EglContext::Open(const EglDevice& device, bool debug) {
  const EGLDisplay display = DisplayOf(device);
  if (display == EGL_NO_DISPLAY) return EglFail("no EGL display");
  EGLint major = 0, minor = 0;
  if (eglInitialize(display, &major, &minor) != EGL_TRUE) return EglFail("eglInitialize failed");
  EglContext opened;
  opened.display_ = display;
  if (major == 1 && minor < 5) {
    return Fail(ErrorKind::kDevice, fmt::format("EGL {}.{} is too old, 1.5 is needed", major, minor));
  }
  const std::string extensions = eglQueryString(display, EGL_EXTENSIONS);
  if (!HasToken(extensions, "EGL_KHR_surfaceless_context")) {
    return Fail(ErrorKind::kDevice, "no EGL_KHR_surfaceless_context");
  }
  if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) return EglFail("no desktop OpenGL");
  opened.context_ = CreateCoreContext(display, extensions, debug);
  if (opened.context_ == EGL_NO_CONTEXT) return EglFail("no OpenGL 4.5 core context");
  if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, opened.context_) != EGL_TRUE) {
    return EglFail("eglMakeCurrent failed");
  }
  const int version = epoxy_gl_version();
  if (version < 45) {
    return Fail(ErrorKind::kDevice, fmt::format("OpenGL {}.{}, 4.5 is needed", version / 10, version % 10));
  }
  return opened;
}

}  // namespace burin::gl

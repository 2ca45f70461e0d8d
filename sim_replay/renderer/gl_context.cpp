// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/renderer/gl_context.h"

#include <string>

#include "config/exit_code.h"

namespace hindsight {
namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw FatalError(kExitNoDevice, "no EGL to render with: " + what +
                                      "; install libegl1 and libgl1-mesa-dri (Mesa), which need no GPU");
}

EGLDisplay surfaceless_display() {
  if (!epoxy_has_egl()) refuse("libEGL is not there");
  // libepoxy ends the program when it is asked for a function that nobody provides.
  if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_base")) refuse("no EGL_EXT_platform_base");
  return eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
}

}  // namespace

GlContext::GlContext() : display_(surfaceless_display()) {
  if (display_ == EGL_NO_DISPLAY) refuse("no display of the surfaceless platform");
  if (!eglInitialize(display_, nullptr, nullptr)) refuse("eglInitialize failed");
  if (!eglBindAPI(EGL_OPENGL_API)) refuse("it does not offer OpenGL");
  const EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION,
                           4,
                           EGL_CONTEXT_MINOR_VERSION,
                           5,
                           EGL_CONTEXT_OPENGL_PROFILE_MASK,
                           EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                           EGL_NONE};
  context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted);
  if (context_ == EGL_NO_CONTEXT) refuse("no OpenGL 4.5 core context");
}

// The display is the process's, not ours: another renderer may live on it.
GlContext::~GlContext() { eglDestroyContext(display_, context_); }

GlContext::Current::Current(const GlContext& context) : display_(context.display_) {
  eglBindAPI(EGL_OPENGL_API);
  if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context.context_)) {
    refuse("the context belongs to another thread");
  }
}

GlContext::Current::~Current() { eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }

}  // namespace hindsight

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <epoxy/egl.h>
#include <epoxy/gl.h>

namespace hindsight {

/// An OpenGL 4.5 core context without window or screen: Mesa's surfaceless platform of EGL, which renders on
/// the CPU where there is no GPU. It may be used by one thread at a time, in turn.
class GlContext {
 public:
  /// FatalError(kExitNoDevice) that says "no EGL" and what is missing.
  GlContext();
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  /// Makes the context the calling thread's, for as long as it lives.
  class Current {
   public:
    explicit Current(const GlContext& context);
    ~Current();
    Current(const Current&) = delete;
    Current& operator=(const Current&) = delete;

   private:
    EGLDisplay display_;
  };

 private:
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace hindsight

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <epoxy/gl.h>

#include <vector>

namespace hindsight {

/// A picture to draw into, of one format.
class GlImage {
 public:
  GlImage(GLenum format, int width, int height, GLenum filter) {
    glCreateTextures(GL_TEXTURE_2D, 1, &id_);
    glTextureStorage2D(id_, 1, format, width, height);
    for (const GLenum name : std::initializer_list<GLenum>{GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
      glTextureParameteri(id_, name, static_cast<GLint>(filter));
    }
    for (const GLenum name : std::initializer_list<GLenum>{GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
      glTextureParameteri(id_, name, GL_CLAMP_TO_EDGE);
    }
  }
  ~GlImage() { glDeleteTextures(1, &id_); }
  GlImage(const GlImage&) = delete;
  GlImage& operator=(const GlImage&) = delete;
  GLuint id() const { return id_; }
  void bind(GLuint unit) const { glBindTextureUnit(unit, id_); }

 private:
  GLuint id_ = 0;
};

/// A frame buffer of such pictures: colours, and depth where there is one.
class GlTarget {
 public:
  GlTarget(const std::vector<const GlImage*>& colours, const GlImage* depth) {
    glCreateFramebuffers(1, &id_);
    std::vector<GLenum> buffers;
    for (const GlImage* colour : colours) {
      buffers.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(buffers.size()));
      glNamedFramebufferTexture(id_, buffers.back(), colour->id(), 0);
    }
    glNamedFramebufferDrawBuffers(id_, static_cast<GLsizei>(buffers.size()), buffers.data());
    if (depth) glNamedFramebufferTexture(id_, GL_DEPTH_ATTACHMENT, depth->id(), 0);
  }
  ~GlTarget() { glDeleteFramebuffers(1, &id_); }
  GlTarget(const GlTarget&) = delete;
  GlTarget& operator=(const GlTarget&) = delete;
  GLuint id() const { return id_; }

 private:
  GLuint id_ = 0;
};

}  // namespace hindsight

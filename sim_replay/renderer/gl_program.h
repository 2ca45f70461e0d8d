// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <epoxy/gl.h>

#include <glm/glm.hpp>
#include <string>

namespace hindsight {

/// A vertex and a fragment shader, linked. Lives and dies while its context is current. Uniforms are set by
/// name; a name that the shaders do not use is passed over, as OpenGL does.
class GlProgram {
 public:
  /// FatalError(kExitSoftware) with the compiler's words.
  GlProgram(const std::string& vertex, const std::string& fragment);
  ~GlProgram() { glDeleteProgram(id_); }
  GlProgram(const GlProgram&) = delete;
  GlProgram& operator=(const GlProgram&) = delete;

  void use() const { glUseProgram(id_); }
  void set(const char* name, int value) const { glProgramUniform1i(id_, at(name), value); }
  void set(const char* name, unsigned value) const { glProgramUniform1ui(id_, at(name), value); }
  void set(const char* name, float value) const { glProgramUniform1f(id_, at(name), value); }
  void set(const char* name, glm::vec2 v) const { glProgramUniform2f(id_, at(name), v.x, v.y); }
  void set(const char* name, glm::vec3 v) const { glProgramUniform3f(id_, at(name), v.x, v.y, v.z); }
  void set(const char* name, glm::vec4 v) const { glProgramUniform4f(id_, at(name), v.x, v.y, v.z, v.w); }
  void set(const char* name, const glm::mat4& m) const {
    glProgramUniformMatrix4fv(id_, at(name), 1, GL_FALSE, &m[0][0]);
  }
  void set(const char* name, const glm::mat3& m) const {
    glProgramUniformMatrix3fv(id_, at(name), 1, GL_FALSE, &m[0][0]);
  }

 private:
  GLint at(const char* name) const { return glGetUniformLocation(id_, name); }

  GLuint id_;
};

}  // namespace hindsight

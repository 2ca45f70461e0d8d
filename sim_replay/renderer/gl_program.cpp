// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/renderer/gl_program.h"

#include <array>

#include "config/exit_code.h"

namespace hindsight {
namespace {

GLuint compile(GLenum kind, const std::string& source) {
  const GLuint shader = glCreateShader(kind);
  const std::string text = "#version 450 core\n" + source;
  const char* lines = text.c_str();
  glShaderSource(shader, 1, &lines, nullptr);
  glCompileShader(shader);
  GLint good = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good) return shader;
  std::array<char, 2048> words{};
  glGetShaderInfoLog(shader, static_cast<GLsizei>(words.size()), nullptr, words.data());
  throw FatalError(kExitSoftware, std::string("renderer: shader does not compile: ") + words.data());
}

}  // namespace

GlProgram::GlProgram(const std::string& vertex, const std::string& fragment) : id_(glCreateProgram()) {
  for (const GLuint shader : {compile(GL_VERTEX_SHADER, vertex), compile(GL_FRAGMENT_SHADER, fragment)}) {
    glAttachShader(id_, shader);
    glDeleteShader(shader);
  }
  glLinkProgram(id_);
  GLint good = 0;
  glGetProgramiv(id_, GL_LINK_STATUS, &good);
  if (good) return;
  std::array<char, 2048> words{};
  glGetProgramInfoLog(id_, static_cast<GLsizei>(words.size()), nullptr, words.data());
  throw FatalError(kExitSoftware, std::string("renderer: shaders do not link: ") + words.data());
}

}  // namespace hindsight

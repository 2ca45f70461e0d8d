// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

namespace hindsight {

/// A picture of linear values in the making: red, green, blue, and a fourth channel with a meaning of its
/// own.
struct Texels {
  int width = 0;
  int height = 0;
  std::vector<glm::vec4> rgba;

  Texels(int width_, int height_, glm::vec4 fill = {})
      : width(width_),
        height(height_),
        rgba(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), fill) {}

  glm::vec4& at(int x, int y) { return rgba[index(x, y)]; }
  const glm::vec4& at(int x, int y) const { return rgba[index(x, y)]; }
  /// For pictures that go on beyond their edges with their other side; both sizes are powers of two.
  glm::vec4& wrapped(int x, int y) { return at(x & (width - 1), y & (height - 1)); }
  const glm::vec4& wrapped(int x, int y) const { return at(x & (width - 1), y & (height - 1)); }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
};

}  // namespace hindsight

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace hindsight {

/// 8-bit BGR, row by row without padding; not owned.
struct ColorView {
  std::span<const std::uint8_t> bgr;
  int width_px = 0;
  int height_px = 0;

  const std::uint8_t* pixel(int column, int row) const {
    return &bgr[3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(width_px) +
                     static_cast<std::size_t>(column))];
  }
};

}  // namespace hindsight

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Is this another picture than the last? A camera that hangs may go on delivering the last one under new
// stamps: the vehicle would be driven by a view of the past. Of a scene that stands still no two pictures are
// the same to the last bit, as a sensor has noise; one that has none is black or white all over, and shows
// nothing either.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "drivers/samples.h"

namespace hindsight {

/// One thread. Allocates at construction, and when a picture is larger than those said there.
class PictureWatch {
 public:
  PictureWatch(int width_px, int height_px) {
    last_.reserve(row_bytes(width_px) * static_cast<std::size_t>(height_px) / kEvery + row_bytes(width_px));
  }

  /// Whether it differs from the picture before, in any of the rows that are looked at; the first one does.
  bool is_another(const Frame& frame) {
    const std::span<const std::uint8_t> picture(frame.bgr);
    const std::size_t row = row_bytes(frame.width_px), rows = row == 0 ? 0 : picture.size() / row;
    const std::size_t size = (rows + kEvery - 1) / kEvery * row;
    bool differs = last_.size() != size;
    last_.resize(size);
    for (std::size_t y = 0; y < rows; y += kEvery) {
      const auto seen = picture.subspan(y * row, row);
      const auto known = std::span(last_).subspan(y / kEvery * row, row);
      differs = differs || !std::ranges::equal(seen, known);
      if (differs) std::ranges::copy(seen, known.begin());
    }
    return differs;
  }

 private:
  static constexpr std::size_t kEvery = 16;  ///< rows: noise is in each
  static std::size_t row_bytes(int width_px) { return 3 * static_cast<std::size_t>(width_px); }

  std::vector<std::uint8_t> last_;  ///< the rows looked at, one after the other
};

}  // namespace hindsight

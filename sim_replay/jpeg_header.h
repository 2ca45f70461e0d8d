// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace hindsight {

struct JpegHeader {
  int width_px = 0;
  int height_px = 0;
  bool baseline_colour = false;  ///< as cameras send MJPEG: sequential, 8 bits, three components
};

/// What a JPEG says of itself. Empty where the bytes are no JPEG or end before its picture does.
std::optional<JpegHeader> read_jpeg_header(std::span<const std::uint8_t> bytes);

}  // namespace hindsight

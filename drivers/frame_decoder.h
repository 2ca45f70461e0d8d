// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string_view>

#include "drivers/samples.h"

namespace hindsight {

enum class DecodeResult : std::uint8_t {
  ok,
  wrong_length,  ///< the bytes are not as many as a picture of this size and format has
  wrong_size,    ///< a JPEG of another width or height than the frame's
  corrupt        ///< a JPEG that cannot be decoded without a warning
};
std::string_view to_string(DecodeResult result);

/// Turns a frame's raw bytes into BGR, for live frames and for replayed ones alike: fills `frame.bgr`,
/// resized to width_px * height_px * 3 (no allocation where that much is reserved; libjpeg itself allocates
/// for each JPEG). What `bgr` holds after a failure is unspecified.
///
/// The result depends on the bytes alone: integer arithmetic, for JPEG the exact integer DCT, and nothing
/// kept from frame to frame. YUYV: BT.601 with the video range (Y 16-235), each pair of pixels sharing its
/// chroma. MJPEG: libjpeg-turbo, which also knows frames without Huffman tables, as webcams send them. Bgr24:
/// a copy. Any thread; never throws.
DecodeResult decode_frame(Frame& frame);

}  // namespace hindsight

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "drivers/samples.h"

namespace hindsight {

/// Frames lost since start, by why.
struct FrameCounts {
  std::uint32_t missed = 0;  ///< gaps in the sequence numbers: never reached us
  std::uint32_t broken = 0;  ///< marked V4L2_BUF_FLAG_ERROR
  std::uint32_t wrong_length = 0;
};

/// Judges the buffers of one stream by what the kernel says of them, before a byte is looked at. Pure: no
/// device, no clock.
class FrameScreen {
 public:
  /// How many bytes a frame may have.
  FrameScreen(std::size_t least_bytes, std::size_t most_bytes)
      : least_bytes_(least_bytes), most_bytes_(most_bytes) {}

  /// Whether the frame is worth a look; counts it where it is not, and the gap before it in any case.
  bool judge(std::uint32_t sequence, bool error_flag, std::size_t bytes, FrameCounts& counts);

 private:
  std::size_t least_bytes_;
  std::size_t most_bytes_;
  bool has_last_ = false;
  std::uint32_t last_sequence_ = 0;
};

}  // namespace hindsight

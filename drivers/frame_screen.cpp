// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "drivers/frame_screen.h"

namespace hindsight {
namespace {

// A jump further than this is a driver that numbers its frames in its own way, not a loss.
constexpr std::uint32_t kLargestGap = 1000;

}  // namespace

bool FrameScreen::judge(std::uint32_t sequence, bool error_flag, std::size_t bytes, FrameCounts& counts) {
  const std::uint32_t gap = sequence - last_sequence_ - 1;  // modulo 2^32, as the counter itself
  if (has_last_ && gap <= kLargestGap) counts.missed += gap;
  has_last_ = true;
  last_sequence_ = sequence;
  const bool right_length = bytes >= least_bytes_ && bytes <= most_bytes_;
  if (error_flag)
    ++counts.broken;
  else if (!right_length)
    ++counts.wrong_length;
  return !error_flag && right_length;
}

}  // namespace hindsight

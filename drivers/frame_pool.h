// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <memory>

#include "drivers/samples.h"

namespace hindsight {

/// A fixed number of frames, all memory reserved at construction, so that a running loop never allocates. The
/// pool must outlive every FrameRef it gave out. One producer thread takes; any thread may drop references.
class FramePool {
 public:
  /// `bytes_per_frame`: room reserved for the raw bytes; `pixels`: width * height of the decoded picture.
  FramePool(std::size_t slots, std::size_t bytes_per_frame, std::size_t pixels)
      : slots_(std::make_unique<FrameSlot[]>(slots)), count_(slots) {
    for (std::size_t i = 0; i < slots; ++i) {
      slots_[i].frame.bytes.reserve(bytes_per_frame);
      slots_[i].frame.bgr.reserve(pixels * 3);
    }
  }

  /// A free slot, or an empty reference if every slot is in use (the caller drops the frame and counts it).
  FrameRef take() {
    // The first free one, not the next: slots that are never needed then never become resident memory.
    for (std::size_t i = 0; i < count_; ++i) {
      if (slots_[i].references.load(std::memory_order_acquire) == 0) return FrameRef(&slots_[i]);
    }
    return {};
  }

 private:
  std::unique_ptr<FrameSlot[]> slots_;
  std::size_t count_;
};

}  // namespace hindsight

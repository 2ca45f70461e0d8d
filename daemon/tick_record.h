// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>

#include "daemon/outbox.h"
#include "daemon/stop_reason.h"
#include "drivers/tick_input.h"

namespace hindsight {

/// One tick, whole: what it saw and what it published. The loop fills it, publisher and recorder read it.
struct TickRecord {
  TickInput input;
  Outbox outbox;
  StopReason reason = StopReason::not_armed;  ///< the tick's decision

  TickRecord() { input.reserve(); }

  bool free() const { return holds_.load(std::memory_order_acquire) == 0; }
  /// Called by the loop before it hands the record to `readers` threads, each of which calls release() once.
  void hand_out(int readers) { holds_.store(readers + 1, std::memory_order_release); }
  void release() {
    if (holds_.fetch_sub(1, std::memory_order_acq_rel) != 2) return;
    // The last reader: the frame goes back to the camera's pool now, not when the record is used again.
    input.frame = {};
    holds_.store(0, std::memory_order_release);
  }

 private:
  std::atomic<int> holds_{0};  ///< 0: free; else readers left + 1
};

/// A fixed number of records. Sized so that one is always free: a queue that is full refuses, it never holds more.
class TickRecordPool {
 public:
  explicit TickRecordPool(std::size_t count) : records_(std::make_unique<TickRecord[]>(count)), count_(count) {}

  TickRecord* take() {
    for (std::size_t i = 0; i < count_; ++i) {
      if (records_[i].free()) return &records_[i];
    }
    return nullptr;
  }

 private:
  std::unique_ptr<TickRecord[]> records_;
  std::size_t count_;
};

}  // namespace hindsight

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <atomic>
#include <functional>
#include <semaphore>
#include <thread>

#include "daemon/heartbeats.h"
#include "daemon/spsc_queue.h"
#include "daemon/tick_record.h"

namespace hindsight {

/// A thread that works through finished ticks behind a bounded queue: publisher and recorder. The loop never waits for
/// it; a tick that finds the queue full is refused and counted.
class TickConsumer {
 public:
  using Handler = std::function<void(const TickRecord&)>;

  /// `between`, if given, is called again and again, also while no tick comes.
  TickConsumer(ThreadId id, std::size_t capacity, Heartbeats& heartbeats, Handler handler,
               std::function<void()> between = {});
  /// Works off what is queued, then ends the thread.
  ~TickConsumer();

  /// Called by the loop. The consumer releases the record when it is done with it; if it refuses the record, the
  /// caller must.
  bool offer(TickRecord* record);
  std::uint32_t refused() const { return refused_.load(std::memory_order_relaxed); }

 private:
  void work();

  ThreadId id_;
  Heartbeats& heartbeats_;
  Handler handler_;
  std::function<void()> between_;
  SpscQueue<TickRecord*> queue_;
  std::counting_semaphore<> waiting_{0};
  std::atomic<bool> ending_{false};
  std::atomic<std::uint32_t> refused_{0};
  std::thread thread_;
};

}  // namespace hindsight

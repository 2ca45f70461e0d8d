// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/tick_consumer.h"

#include <utility>

#include "daemon/beating_thread.h"
#include "drivers/monotonic_clock.h"

namespace hindsight {

TickConsumer::TickConsumer(ThreadId id, std::size_t capacity, Heartbeats& heartbeats, Handler handler,
                           std::function<void()> between)
    : id_(id), heartbeats_(heartbeats), handler_(std::move(handler)), between_(std::move(between)), queue_(capacity),
      thread_(start_beating_thread(id, heartbeats, [this] { work(); })) {}

TickConsumer::~TickConsumer() {
  ending_.store(true, std::memory_order_release);
  waiting_.release();
  thread_.join();
}

bool TickConsumer::offer(TickRecord* record) {
  if (!queue_.push(record)) {
    refused_.fetch_add(1, std::memory_order_relaxed);
    return false;
  }
  waiting_.release();
  return true;
}

void TickConsumer::work() {
  while (true) {
    heartbeats_.beat(id_, monotonic_now());
    static_cast<void>(waiting_.try_acquire_for(std::chrono::milliseconds(50)));
    // Read before the queue: what was offered before the end was asked for is still worked off.
    const bool ending = ending_.load(std::memory_order_acquire);
    TickRecord* record = nullptr;
    while (queue_.pop(record)) {
      handler_(*record);
      record->release();
      heartbeats_.beat(id_, monotonic_now());
    }
    if (between_) between_();
    if (ending) return;
  }
}

}  // namespace hindsight

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <atomic>
#include <string_view>

#include "drivers/samples.h"

namespace hindsight {

enum class ThreadId : std::uint8_t { loop, reflex, camera, can, gpio, gps, command, publisher, recorder };
constexpr int kThreadCount = 9;
constexpr std::array<std::string_view, kThreadCount> kThreadNames = {
    "loop", "reflex", "camera", "can", "gpio", "gps", "command", "publisher", "recorder"};

/// Every thread of a live run beats; one place (the main thread) judges, and only it feeds the watchdog.
class Heartbeats {
 public:
  void beat(ThreadId thread, Time now) { at(thread).store(now.count(), std::memory_order_relaxed); }
  /// The first thread that has beaten at least once and not since `limit` ago; empty if there is none.
  std::string_view late(Time now, Time limit) const {
    for (std::size_t i = 0; i < kThreadCount; ++i) {
      const Time::rep last = beats_[i].load(std::memory_order_relaxed);
      if (last != 0 && now - Time(last) > limit) return kThreadNames[i];
    }
    return {};
  }

 private:
  std::atomic<Time::rep>& at(ThreadId thread) { return beats_[static_cast<std::size_t>(thread)]; }
  std::array<std::atomic<Time::rep>, kThreadCount> beats_{};
};

}  // namespace hindsight

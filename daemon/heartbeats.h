// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <atomic>
#include <string_view>

#include "drivers/samples.h"

namespace hindsight {

enum class ThreadId : std::uint8_t { loop, reflex, camera, can, gpio, gps, command, publisher, recorder, flight_recorder };
constexpr int kThreadCount = 10;
constexpr std::array<std::string_view, kThreadCount> kThreadNames = {
    "loop", "reflex", "camera", "can", "gpio", "gps", "command", "publisher", "recorder", "flight"};

constexpr std::string_view name_of(ThreadId thread) { return kThreadNames[static_cast<std::size_t>(thread)]; }

/// Every thread of a live run beats; one place (daemon/thread_judge.h, on the main thread) judges.
class Heartbeats {
 public:
  void beat(ThreadId thread, Time now) { at(thread).store(now.count(), std::memory_order_relaxed); }
  /// The thread ended by an exception; it will not beat again.
  void die(ThreadId thread) { at(thread).store(kDead, std::memory_order_relaxed); }

  /// The first thread that died; empty if there is none.
  std::string_view dead() const {
    return first([](Time::rep last) { return last == kDead; });
  }
  /// The first thread that has beaten at least once and not since `limit` ago; empty if there is none.
  std::string_view late(Time now, Time limit) const {
    return first([&](Time::rep last) { return last > 0 && now - Time(last) > limit; });
  }

 private:
  static constexpr Time::rep kDead = -1;

  std::string_view first(auto&& is_ill) const {
    for (std::size_t i = 0; i < kThreadCount; ++i) {
      if (is_ill(beats_[i].load(std::memory_order_relaxed))) return kThreadNames[i];
    }
    return {};
  }
  std::atomic<Time::rep>& at(ThreadId thread) { return beats_[static_cast<std::size_t>(thread)]; }
  std::array<std::atomic<Time::rep>, kThreadCount> beats_{};
};

}  // namespace hindsight

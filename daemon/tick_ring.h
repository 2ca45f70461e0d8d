// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "drivers/samples.h"

namespace hindsight {

/// The newest ticks, encoded, in a fixed piece of memory: a tick that needs room pushes the oldest out.
class TickRing {
 public:
  struct Tick {
    std::uint64_t index = 0;
    Time now{};
    std::size_t begin = 0;
    std::size_t size = 0;
  };

  explicit TickRing(std::size_t bytes) : memory_(bytes) {}

  /// False where the tick is larger than the whole ring; it is then left out.
  bool push(std::uint64_t index, Time now, std::span<const std::uint8_t> bytes);
  void forget_before(Time time);

  const std::deque<Tick>& ticks() const { return ticks_; }  ///< oldest first
  std::span<const std::uint8_t> bytes_of(const Tick& tick) const {
    return std::span(memory_).subspan(tick.begin, tick.size);
  }

 private:
  std::vector<std::uint8_t> memory_;
  std::deque<Tick> ticks_;
  std::size_t end_ = 0;  ///< where the next tick goes, if there is room before the memory's end
};

}  // namespace hindsight

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/tick_ring.h"

#include <algorithm>

namespace hindsight {

bool TickRing::push(std::uint64_t index, Time now, std::span<const std::uint8_t> bytes) {
  if (bytes.size() > memory_.size()) return false;
  // A tick is never split: what does not fit before the memory's end begins at its start.
  const std::size_t begin = end_ + bytes.size() <= memory_.size() ? end_ : 0;
  const std::size_t end = begin + bytes.size();
  const auto in_the_way = [&](const Tick& tick) {
    const bool overlaps = tick.begin < end && begin < tick.begin + tick.size;
    const bool skipped = begin < end_ && tick.begin >= end_;  // older than what is at the start
    return overlaps || skipped;
  };
  while (!ticks_.empty() && in_the_way(ticks_.front())) ticks_.pop_front();
  std::copy(bytes.begin(), bytes.end(), memory_.begin() + static_cast<std::ptrdiff_t>(begin));
  ticks_.push_back({index, now, begin, bytes.size()});
  end_ = end;
  return true;
}

void TickRing::forget_before(Time time) {
  while (!ticks_.empty() && ticks_.front().now < time) ticks_.pop_front();
}

}  // namespace hindsight

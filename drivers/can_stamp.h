// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>

#include "drivers/samples.h"

namespace hindsight {

/// Monotonic time of a frame that the kernel stamped with the wall clock (SO_TIMESTAMPNS knows no other).
///
/// The frame's age is the wall clock's reading now less its stamp; its time is `now` less that age. A step of
/// the wall clock between arrival and reading makes the age wrong by the step, in either direction; but a
/// frame that waited in the queue came after the queue was last seen empty, so the result is held between
/// `last_empty` and `now`.
constexpr Time monotonic_stamp(Time wall_stamp, Time wall_now, Time now, Time last_empty) {
  return std::clamp(now - (wall_now - wall_stamp), std::min(last_empty, now), now);
}

}  // namespace hindsight

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/slip_watch.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hindsight {
namespace {

constexpr double kTrackWidth_m = 0.6;

/// A watch over motors that both swing at 3 Hz as slipping ones do, at 0.8 m/s.
bool told_of_swing(bool ground_seen, double ground_mps) {
  SlipWatch watch(SlipDetectorParams{}, 50.0, GroundSlipParams{}, kTrackWidth_m);
  bool told = false;
  for (int i = 1; i <= 50 * 10; ++i) {
    const Time now = from_seconds(0.02 * i);
    const double current_a = 4.0 + (i > 250 ? 3.5 * std::sin(2.0 * M_PI * 3.0 * to_seconds(now)) : 0.0);
    watch.add_currents(now, current_a, current_a);
    watch.add_speeds(now, 0.8, 0.8);
    if (i % 5 != 0) continue;
    if (ground_seen)
      watch.add_step({now - from_seconds(0.1), now, {true, 0.1 * ground_mps, 0.0, 0.001, 200}});
    told = watch.update(now, {{{0.8, 0.8}, {0.8, 0.8}}}) || told;
  }
  return told;
}

TEST(SlipWatch, BelievesTheGroundWhileItIsSeenAndCurrentsElse) {
  EXPECT_TRUE(told_of_swing(false, 0.0));
  EXPECT_FALSE(told_of_swing(true, 0.8)) << "the vehicle goes as fast as its wheels";
  EXPECT_TRUE(told_of_swing(true, 0.1));
}

}  // namespace
}  // namespace hindsight

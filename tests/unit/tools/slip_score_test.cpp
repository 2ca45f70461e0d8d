// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/slip_score.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tools/statistics.h"

namespace hindsight::tools {
namespace {

constexpr double kRate_hz = 20.0;
constexpr double kTrackWidth_m = 0.6;

/// A minute of steady load at 10 ticks a second, currents at 20 Hz; the left motor swings at 3 Hz between the
/// times given, and the truth says slip between others.
SlipTrace trace_of(double swing_from_s, double swing_to_s, double slip_from_s, double slip_to_s) {
  SlipTrace trace;
  for (int i = 0; i < 60 * 20; ++i) {
    const double t = i / kRate_hz;
    const double swing =
        t >= swing_from_s && t < swing_to_s ? 4.0 * std::sin(2.0 * std::numbers::pi * 3.0 * t) : 0.0;
    trace.currents.push_back({from_seconds(t), 4.0 + swing, 4.0});
    trace.see_truth(from_seconds(t), t >= slip_from_s && t < slip_to_s);
    if (i % 2 == 0) trace.ticks.push_back({from_seconds(t), {{{0.5, 0.5}, {0.5, 0.5}}}});
  }
  return trace;
}

SlipScore score_of(const SlipTrace& trace) {
  SlipScore score;
  score_slip({}, kRate_hz, kTrackWidth_m, trace, score);
  return score;
}

TEST(SlipScoreTest, TellsASlipAndItsDelay) {
  const SlipScore score = score_of(trace_of(20.0, 25.0, 20.0, 25.0));
  ASSERT_EQ(score.slips.size(), 1U);
  EXPECT_NEAR(score.slips[0].lasted_s, 5.0, 0.1);
  EXPECT_GT(score.slips[0].delay_s, 0.5);
  EXPECT_LT(score.slips[0].delay_s, 2.0);
  EXPECT_EQ(score.false_alarms, 0);
  EXPECT_EQ(score.share_told_within(2.0), 1.0);
}

TEST(SlipScoreTest, CountsASwingWithoutSlipAsOneFalseAlarm) {
  const SlipScore score = score_of(trace_of(20.0, 25.0, 50.0, 52.0));
  EXPECT_EQ(score.false_alarms, 1);
  ASSERT_EQ(score.slips.size(), 1U);
  EXPECT_TRUE(std::isinf(score.slips[0].delay_s));
  EXPECT_EQ(score.share_told_within(1.0), 0.0);
}

TEST(SlipScoreTest, QuietTimeLeavesOutSlipsAndWhatFollowsThem) {
  const SlipScore score = score_of(trace_of(20.0, 25.0, 20.0, 25.0));
  EXPECT_NEAR(score.quiet_h * 3600.0, 60.0 - 5.0 - to_seconds(SlipTrace::kAftermath), 0.2);
}

TEST(SlipScoreTest, AShortGripDoesNotEndASlip) {
  SlipTrace trace;
  for (const double s : {1.0, 1.2, 1.6, 3.0}) trace.see_truth(from_seconds(s), true);
  trace.see_truth(from_seconds(3.1), false);
  ASSERT_EQ(trace.slips.size(), 2U);
  EXPECT_EQ(trace.slips[0].end, from_seconds(1.6));
  EXPECT_EQ(trace.slips[1].begin, from_seconds(3.0));
}

TEST(SlipScoreTest, ASlipThatEndedBeforeIsNotAskedFor) {
  SlipScore score;
  score.slips = {{0.5, 0.8}, {1.5, 0.9}, {3.0, 1.4}};
  EXPECT_EQ(score.lasted(1.0), 2);
  EXPECT_EQ(score.share_told_within(1.0), 0.5);
  EXPECT_EQ(score.share_told_within(2.0), 1.0);
  EXPECT_EQ(score.delay_s(1.0, 1.0), 1.4);
}

TEST(StatisticsTest, AQuantileIsOneOfTheValues) {
  EXPECT_EQ(quantile_of({4.0, 1.0, 3.0, 2.0}, 0.5), 2.0);
  EXPECT_EQ(quantile_of({4.0, 1.0, 3.0, 2.0}, 0.75), 3.0);
  EXPECT_EQ(quantile_of({4.0, 1.0}, 1.0), 4.0);
  EXPECT_EQ(quantile_of({4.0, 1.0}, 0.0), 1.0);
  EXPECT_EQ(quantile_of({}, 0.5), 0.0);
}

}  // namespace
}  // namespace hindsight::tools

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/timing_histogram.h"

#include <gtest/gtest.h>

#include <numeric>

namespace hindsight {
namespace {

TEST(TimingHistogram, EachDurationIsBetweenItsBinsEdges) {
  for (std::int64_t us = 1; us < 700'000; us += 1 + us / 50) {
    TimingHistogram histogram;
    histogram.add(std::chrono::microseconds(us));
    const auto& counts = histogram.counts();
    const auto bin = static_cast<std::size_t>(std::find(counts.begin(), counts.end(), 1) - counts.begin());
    ASSERT_LT(bin + 1, TimingHistogram::kBins);
    EXPECT_LE(TimingHistogram::lower_edge_us(bin), static_cast<double>(us));
    EXPECT_GT(TimingHistogram::lower_edge_us(bin + 1), us == 1 ? 1.0 : static_cast<double>(us));
  }
}

TEST(TimingHistogram, WhatIsTooShortOrTooLongIsInTheOuterBins) {
  TimingHistogram histogram;
  for (const Time duration : {Time(-5), Time(0), Time(999)}) histogram.add(duration);
  histogram.add(std::chrono::hours(1));
  EXPECT_EQ(histogram.counts().front(), 3);
  EXPECT_EQ(histogram.counts().back(), 1);
  EXPECT_EQ(std::accumulate(histogram.counts().begin(), histogram.counts().end(), 0), 4);
}

}  // namespace
}  // namespace hindsight

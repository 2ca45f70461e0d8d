// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "drivers/source_reporter.h"

#include <gtest/gtest.h>

#include "drivers/backoff.h"
#include "recording_sink.h"

namespace hindsight {
namespace {

using std::chrono::milliseconds;

TEST(SourceReporter, TellsChangesOnce) {
  RecordingSink sink;
  SourceReporter reporter(Source::camera, sink);
  for (int i = 0; i < 3; ++i) reporter.fresh(milliseconds(i));
  for (int i = 3; i < 6; ++i) reporter.failed(milliseconds(i), ENODEV);
  ASSERT_EQ(sink.reports.size(), 2U);
  EXPECT_EQ(sink.reports[0].state, SourceState::fresh);
  EXPECT_EQ(sink.reports[1].state, SourceState::failed);
  EXPECT_EQ(sink.reports[1].error_code, ENODEV);
  EXPECT_EQ(sink.reports[1].stamp, milliseconds(3));
}

TEST(SourceReporter, TellsLossesAtMostTenTimesASecond) {
  RecordingSink sink;
  SourceReporter reporter(Source::can, sink);
  for (int ms = 1000; ms < 2000; ++ms) {
    reporter.set_dropped(static_cast<std::uint32_t>(ms));
    reporter.flush(milliseconds(ms));
  }
  EXPECT_EQ(sink.reports.size(), 10U);
  const auto before = sink.reports.size();
  reporter.flush(milliseconds(3000));
  reporter.flush(milliseconds(4000));
  EXPECT_EQ(sink.reports.size(), before + 1) << "the last count once, then nothing new";
}

TEST(Backoff, PausesGrowUpToTheLongestAndStartAgainAfterSuccess) {
  Backoff backoff({.first_s = 0.1, .longest_s = 0.3});
  EXPECT_LE(backoff.remaining(milliseconds(1)), Time{});
  std::vector<Time> pauses;
  for (int i = 0; i < 4; ++i) {
    backoff.failed(milliseconds(1000));
    pauses.push_back(backoff.remaining(milliseconds(1000)));
  }
  EXPECT_EQ(pauses,
            (std::vector<Time>{milliseconds(100), milliseconds(200), milliseconds(300), milliseconds(300)}));
  backoff.succeeded();
  backoff.failed(milliseconds(2000));
  EXPECT_EQ(backoff.remaining(milliseconds(2000)), milliseconds(100));
}

}  // namespace
}  // namespace hindsight

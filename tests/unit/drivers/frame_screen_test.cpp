// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "drivers/frame_screen.h"

#include <gtest/gtest.h>

namespace hindsight {
namespace {

class Screening : public testing::Test {
 protected:
  bool judge(std::uint32_t sequence, bool error = false, std::size_t bytes = 100) {
    return screen_.judge(sequence, error, bytes, counts_);
  }
  FrameScreen screen_{100, 200};
  FrameCounts counts_;
};

TEST_F(Screening, GapsInTheSequenceAreCounted) {
  for (const std::uint32_t sequence : {7U, 8U, 11U, 12U}) EXPECT_TRUE(judge(sequence));
  EXPECT_EQ(counts_.missed, 2U);
}

TEST_F(Screening, TheSequenceMayWrapAndStandStill) {
  EXPECT_TRUE(judge(0xFFFFFFFFU));
  EXPECT_TRUE(judge(0));
  EXPECT_TRUE(judge(0)) << "a driver that does not count";
  EXPECT_EQ(counts_.missed, 0U);
}

TEST_F(Screening, BrokenAndShortFramesAreDroppedAndCounted) {
  EXPECT_FALSE(judge(0, true));
  EXPECT_FALSE(judge(1, false, 99));
  EXPECT_FALSE(judge(2, false, 201));
  EXPECT_FALSE(judge(3, false, 0));
  EXPECT_TRUE(judge(4, false, 200));
  EXPECT_EQ(counts_.broken, 1U);
  EXPECT_EQ(counts_.wrong_length, 3U);
  EXPECT_EQ(counts_.missed, 0U) << "a dropped frame is no gap";
}

}  // namespace
}  // namespace hindsight

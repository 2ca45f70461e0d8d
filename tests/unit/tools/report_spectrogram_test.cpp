// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/report_spectrogram.h"

#include <gtest/gtest.h>

#include <limits>

#include "tools/report_style.h"

namespace hindsight::tools {
namespace {

constexpr std::size_t kBins = 21;  // 0 to 10 Hz

SpectrumTrace quiet(std::size_t ticks) {
  return {.bins = kBins, .hz_per_bin = 0.5, .amplitudes = std::vector<float>(kBins * ticks, 0.0F)};
}

bool brighter(const cv::Vec3b& a, const cv::Vec3b& b) { return a[0] + a[1] + a[2] > b[0] + b[1] + b[2]; }

TEST(Spectrogram, HasLowFrequenciesAtTheBottomAndTimeToTheRight) {
  SpectrumTrace trace = quiet(30);
  trace.amplitudes[25 * kBins + 6] = 0.6F;  // 3 Hz in tick 25
  const cv::Mat picture = draw_spectrogram(trace, 100);
  ASSERT_EQ(picture.size(), cv::Size(30, 20));
  for (int row = 0; row < picture.rows; ++row) {
    for (int column = 0; column < picture.cols; ++column) {
      const bool lit = brighter(picture.at<cv::Vec3b>(row, column), picture.at<cv::Vec3b>(0, 0));
      EXPECT_EQ(lit, row == 14 && column == 25) << "row " << row << ", column " << column;
    }
  }
}

TEST(Spectrogram, KeepsAPeakWhenTicksShareAColumn) {
  SpectrumTrace trace = quiet(1000);
  trace.amplitudes[501 * kBins + 6] = 0.6F;
  const cv::Mat picture = draw_spectrogram(trace, 100);
  ASSERT_EQ(picture.cols, 100);
  EXPECT_TRUE(brighter(picture.at<cv::Vec3b>(14, 50), picture.at<cv::Vec3b>(14, 49)));
}

TEST(Spectrogram, IsGreyWhileTheWindowFills) {
  SpectrumTrace trace = quiet(2);
  for (std::size_t bin = 0; bin < kBins; ++bin)
    trace.amplitudes[bin] = std::numeric_limits<float>::quiet_NaN();
  const cv::Mat picture = draw_spectrogram(trace, 100);
  EXPECT_EQ(picture.at<cv::Vec3b>(5, 0), kFaint.pixel());
  EXPECT_NE(picture.at<cv::Vec3b>(5, 1), kFaint.pixel());
}

TEST(Spectrogram, OfNothingIsEmpty) { EXPECT_TRUE(draw_spectrogram({}, 100).empty()); }

}  // namespace
}  // namespace hindsight::tools

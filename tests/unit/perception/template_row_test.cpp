// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/template_row.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "config/exit_code.h"
#include "perception/quad_correlation.h"

namespace hindsight {
namespace {

cv::Mat random_picture(cv::Size size, std::uint64_t seed) {
  cv::RNG random(seed);
  cv::Mat picture(size, CV_8UC3);
  random.fill(picture, cv::RNG::UNIFORM, 0, 256);
  cv::GaussianBlur(picture, picture, {5, 5}, 1.5);
  return picture;
}

ColorView view(const cv::Mat& picture) {
  return {{picture.data, picture.total() * picture.elemSize()}, picture.cols, picture.rows};
}

/// One row of what OpenCV's matchTemplate says.
cv::Mat opencv_row(const cv::Mat& picture, const cv::Mat& strip, int top, int method) {
  cv::Mat result;
  cv::matchTemplate(picture.rowRange(top, top + strip.rows), strip, result, method);
  return result;
}

TEST(TemplateRow, SquaredDifferenceEqualsOpencv) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
    cv::RNG random(seed);
    const cv::Mat then = random_picture({random.uniform(120, 720), 60}, seed + 10),
                  now = random_picture(then.size(), seed + 20);
    const int width = random.uniform(3, then.cols), height = random.uniform(1, 30);
    const int left = random.uniform(0, then.cols - width + 1), top = random.uniform(0, 60 - height + 1);
    TemplateRow row(then.cols, then.cols, 30);
    row.take(view(then), left, top, width, height);
    const int at = random.uniform(0, 60 - height + 1);
    const auto response = row.search(view(now), at, TemplateMatch::squared_difference);
    const cv::Mat expected =
        opencv_row(now, then(cv::Rect(left, top, width, height)), at, cv::TM_SQDIFF_NORMED);
    ASSERT_EQ(response.size(), expected.total());
    for (int x = 0; x < expected.cols; ++x)
      EXPECT_NEAR(response[static_cast<std::size_t>(x)], expected.at<float>(x), 1e-4)
          << "seed " << seed << " x " << x;
  }
}

TEST(TemplateRow, CorrelationDoesNotMindLight) {
  const cv::Mat now = random_picture({300, 40}, 7);
  cv::Mat darker;
  now.convertTo(darker, CV_8U, 0.5, 20.0);
  TemplateRow row(300, 100, 20);
  row.take(view(darker), 120, 10, 80, 20);
  const auto response = row.search(view(now), 10, TemplateMatch::correlation);
  const auto best = std::min_element(response.begin(), response.end());
  EXPECT_EQ(best - response.begin(), 120);
  EXPECT_LT(*best, 0.01);
  EXPECT_GT(row.search(view(now), 10, TemplateMatch::squared_difference)[120], 0.05);
}

TEST(TemplateRow, FlatPicturesAreNoMatchAndNoNan) {
  const cv::Mat flat(40, 100, CV_8UC3, cv::Scalar::all(0));
  TemplateRow row(100, 50, 20);
  row.take(view(flat), 0, 0, 50, 20);
  for (const auto match : {TemplateMatch::squared_difference, TemplateMatch::correlation})
    for (const float value : row.search(view(flat), 5, match)) EXPECT_EQ(value, 1.0F);
}

TEST(TemplateRow, RefusesStripsWhoseSumsOverflow) {
  EXPECT_THROW(TemplateRow(4000, 4000, 100), FatalError);
  EXPECT_NO_THROW(TemplateRow(720, 720, 20));
}

TEST(QuadCorrelation, EachKernelEqualsTheSumsAsTheyAreWritten) {
  cv::RNG random(11);
  const std::size_t places = 2 * kPlacesAtOnce;
  for (const std::size_t quads : {1U, 2U, 19U}) {
    std::vector<std::uint8_t> pixels(places + 4 * quads + 3), strip(4 * quads);
    for (std::uint8_t& p : pixels) p = static_cast<std::uint8_t>(random.uniform(0, 256));
    for (std::uint8_t& t : strip) t = static_cast<std::uint8_t>(random.uniform(0, 256));
    for (const std::size_t k : {7U, 8U}) pixels.at(k) = 255;
    strip.at(0) = strip.at(1) = 127, strip.at(2) = strip.at(3) = 128;
    std::vector<std::uint32_t> row, weights;
    for (std::size_t x = 0; x + 3 < pixels.size(); ++x) row.push_back(quad_of(&pixels[x], 1));
    for (std::size_t j = 0; j < quads; ++j) weights.push_back(quad_of(&strip[4 * j], 1));
    for (AddQuadProducts* const kernel : quad_product_kernels()) {
      std::vector<std::uint32_t> sums(places, 5);
      kernel(row.data(), weights.data(), quads, places, sums.data());
      for (std::size_t x = 0; x < places; ++x) {
        int expected = 5;
        for (std::size_t j = 0; j < strip.size(); ++j)
          expected += pixels[x + j] * static_cast<std::int8_t>(strip[j]);
        ASSERT_EQ(static_cast<std::int32_t>(sums[x]), expected) << quads << " quads, x " << x;
      }
    }
  }
}

}  // namespace
}  // namespace hindsight

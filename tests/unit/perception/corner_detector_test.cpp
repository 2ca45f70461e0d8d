// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/corner_detector.h"

#include <gtest/gtest.h>

#include <map>
#include <opencv2/imgproc.hpp>
#include <random>

#include "tests/unit/perception/synthetic_texture.h"

namespace hindsight {
namespace {

using test::Texture;

constexpr int kWidth = 161, kHeight = 97;

GreyImage grey_of(int width, int height, auto&& value) {
  GreyImage grey(width, height);
  bgr_to_grey(test::draw(width, height, value), grey);
  return grey;
}

cv::Mat to_float(const GreyImage& grey) {
  cv::Mat image(grey.height_px(), grey.width_px(), CV_64F);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) image.at<double>(y, x) = grey.row(y)[x];
  }
  return image;
}

/// The same quantity, step by step in double precision.
cv::Mat reference_eigenvalues(const GreyImage& grey, int kernel_px, double sigma_px) {
  const cv::Mat image = to_float(grey);
  cv::Mat padded, smooth, gx, gy;
  const int pad = 16;
  cv::copyMakeBorder(image, padded, pad, pad, pad, pad, cv::BORDER_REPLICATE);
  cv::GaussianBlur(padded, smooth, {kernel_px, kernel_px}, sigma_px);
  cv::Sobel(smooth, gx, CV_64F, 1, 0, 3, 1.0 / 8.0);
  cv::Sobel(smooth, gy, CV_64F, 0, 1, 3, 1.0 / 8.0);
  cv::Mat eigenvalues(image.size(), CV_64F);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      double xx = 0.0, xy = 0.0, yy = 0.0;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          const double ex = gx.at<double>(y + pad + dy, x + pad + dx),
                       ey = gy.at<double>(y + pad + dy, x + pad + dx);
          xx += ex * ex;
          xy += ex * ey;
          yy += ey * ey;
        }
      }
      eigenvalues.at<double>(y, x) = 0.5 * ((xx + yy) - std::hypot(xx - yy, 2.0 * xy));
    }
  }
  return eigenvalues;
}

/// All rows of MinEigenvalueRows.
cv::Mat eigenvalues_of(const GreyImage& grey, int kernel_px, double sigma_px, float& largest) {
  MinEigenvalueRows rows(grey.width_px(), grey.height_px(), kernel_px, sigma_px);
  cv::Mat all(grey.height_px(), grey.width_px(), CV_32F);
  rows.compute(grey, [&](int y) { std::copy_n(rows.row(y), all.cols, all.ptr<float>(y)); });
  largest = rows.largest();
  return all;
}

TEST(MinEigenvalueRows, AgreesWithPlainDoublePrecision) {
  const Texture texture(1);
  const GreyImage grey = grey_of(kWidth, kHeight, [&](int x, int y) { return texture.at(x, y); });
  for (const auto& [kernel_px, sigma_px] : {std::pair{11, 2.15}, {5, 1.0}, {1, 1.0}}) {
    float found_largest = 0.0F;
    const cv::Mat found = eigenvalues_of(grey, kernel_px, sigma_px, found_largest);
    const cv::Mat expected = reference_eigenvalues(grey, kernel_px, sigma_px);
    double largest = 0.0;
    cv::minMaxLoc(expected, nullptr, &largest);
    EXPECT_NEAR(found_largest, largest, 0.03 * largest) << kernel_px;  // weights are whole parts of 256
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        ASSERT_NEAR(found.at<float>(y, x), expected.at<double>(y, x), 0.03 * largest)
            << kernel_px << ": " << x << ", " << y;
      }
    }
  }
}

TEST(CornerDetector, TakesTheLocalMaximaOfItsMapInOrder) {
  const Texture texture(2);
  const GreyImage grey = grey_of(kWidth, kHeight, [&](int x, int y) { return texture.at(x, y); });
  CornerParams params;
  params.quality = 0.02;
  params.min_spacing_px = 6.5;
  params.quota_per_cell = 0;
  float strongest = 0.0F;
  const cv::Mat map = eigenvalues_of(grey, params.smoothing_kernel_px, params.smoothing_sigma_px, strongest);

  std::multimap<float, Point2f, std::greater<>> maxima;  // brute force
  for (int y = 1; y < kHeight - 1; ++y) {
    for (int x = 1; x < kWidth - 1; ++x) {
      const float value = map.at<float>(y, x);
      bool largest = value > 0.02F * strongest;
      for (int i = 0; i < 9; ++i) largest = largest && map.at<float>(y + i / 3 - 1, x + i % 3 - 1) <= value;
      if (largest) maxima.emplace(value, Point2f{static_cast<float>(x), static_cast<float>(y)});
    }
  }
  std::vector<Point2f> expected;
  for (const auto& [value, p] : maxima) {
    const bool free = std::none_of(expected.begin(), expected.end(), [&p = p](const Point2f& q) {
      return std::hypot(p.x_px - q.x_px, p.y_px - q.y_px) < 6.5F;
    });
    if (free) expected.push_back(p);
  }

  CornerDetector detector(params, kWidth, kHeight);
  const auto corners = detector.detect(grey);
  ASSERT_GT(expected.size(), 30U);
  ASSERT_EQ(corners.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(corners[i].x_px, expected[i].x_px) << i;
    EXPECT_EQ(corners[i].y_px, expected[i].y_px) << i;
  }
}

TEST(CornerDetector, QuotaKeepsOneStrongCornerRegionFromStarvingTheRest) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> strong(0, 255), weak(124, 131);
  const GreyImage grey = grey_of(160, 96, [&](int x, int) { return x < 40 ? strong(random) : weak(random); });
  CornerParams params;
  params.quality = 0.0;
  params.min_spacing_px = 0.0;
  params.quota_columns = 4;
  params.quota_rows = 2;
  params.quota_per_cell = 7;
  CornerDetector detector(params, 160, 96);
  std::map<int, int> in_cell;
  for (const auto& c : detector.detect(grey)) {
    ++in_cell[static_cast<int>(c.y_px) / 48 * 4 + static_cast<int>(c.x_px) / 40];
  }
  EXPECT_EQ(in_cell.size(), 8U);
  for (const auto& [cell, count] : in_cell) EXPECT_EQ(count, 7) << cell;
}

TEST(CornerDetector, KeepsTheStrongestWhenThereAreTooMany) {
  const Texture texture(4);
  const GreyImage grey = grey_of(kWidth, kHeight, [&](int x, int y) { return texture.at(x, y); });
  CornerParams params;
  CornerDetector all(params, kWidth, kHeight);
  params.max_features = 10;
  CornerDetector few(params, kWidth, kHeight);
  const auto a = all.detect(grey), b = few.detect(grey);
  ASSERT_EQ(b.size(), 10U);
  for (std::size_t i = 0; i < b.size(); ++i) EXPECT_EQ(a[i].x_px, b[i].x_px);
}

TEST(CornerDetector, FindsNothingInAFlatImage) {
  CornerDetector detector({}, 64, 48);
  EXPECT_TRUE(detector.detect(grey_of(64, 48, [](int, int) { return 0; })).empty());
  EXPECT_TRUE(detector.detect(grey_of(64, 48, [](int, int) { return 255; })).empty());
}

TEST(GreyImage, AgreesWithOpencvWithinOneLevel) {
  std::mt19937 random(5);
  cv::Mat bgr(33, 71, CV_8UC3), expected;
  for (int i = 0; i < 33 * 71 * 3; ++i) bgr.data[i] = static_cast<unsigned char>(random() & 255U);
  cv::cvtColor(bgr, expected, cv::COLOR_BGR2GRAY);
  GreyImage grey(71, 33);
  bgr_to_grey({bgr.data, bgr.total() * 3}, grey);
  for (int y = 0; y < 33; ++y) {
    for (int x = 0; x < 71; ++x) ASSERT_NEAR(grey.row(y)[x], expected.at<unsigned char>(y, x), 1);
  }
  EXPECT_EQ(grey.row(-GreyImage::kBorderPx)[-GreyImage::kBorderPx], grey.row(0)[0]);
  EXPECT_EQ(grey.row(32 + GreyImage::kBorderPx)[70 + GreyImage::kBorderPx], grey.row(32)[70]);
}

}  // namespace
}  // namespace hindsight

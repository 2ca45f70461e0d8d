// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/optical_flow.h"

#include <gtest/gtest.h>

#include "tests/unit/perception/synthetic_texture.h"

namespace hindsight {
namespace {

using test::draw;
using test::Texture;

constexpr int kWidth = 320, kHeight = 200;

struct Quality {
  std::size_t vectors;
  double median_error_px;
  double worst_of_95_percent_px;
};

/// `where_before(x, y)`: the place in frame t-1 of what is at (x, y) in frame t.
Quality measure(const OpticalFlowParams& params, const Texture& texture, auto&& where_before,
                double gain = 1.0, double offset = 0.0) {
  OpticalFlow flow(params, kWidth, kHeight);
  EXPECT_TRUE(flow.update(draw(kWidth, kHeight, [&](int x, int y) { return texture.at(x, y); })).empty());
  const auto vectors = flow.update(draw(kWidth, kHeight, [&](int x, int y) {
    const auto [u, v] = where_before(x, y);
    return gain * texture.at(u, v) + offset;
  }));
  std::vector<double> errors;
  for (const FlowVector& f : vectors) {
    const auto [u, v] = where_before(f.x_px, f.y_px);
    errors.push_back(std::hypot(f.x_px + f.dx_px - u, f.y_px + f.dy_px - v));
  }
  if (errors.empty()) return {0, INFINITY, INFINITY};
  std::sort(errors.begin(), errors.end());
  return {errors.size(), errors[errors.size() / 2], errors[errors.size() * 95 / 100]};
}

auto shift(double dx, double dy) {
  return [=](double x, double y) { return std::pair{x + dx, y + dy}; };
}

TEST(OpticalFlow, FindsSubPixelTranslations) {
  const Texture texture(10);
  for (const auto& [dx, dy] : {std::pair{0.0, 0.0}, {0.3, -0.4}, {2.5, 1.25}, {-7.8, 4.1}, {19.6, -11.3}}) {
    const Quality q = measure({}, texture, shift(dx, dy));
    EXPECT_GT(q.vectors, 150U) << dx << ", " << dy;
    EXPECT_LT(q.median_error_px, 0.05) << dx << ", " << dy;
    EXPECT_LT(q.worst_of_95_percent_px, 0.3) << dx << ", " << dy;
  }
}

TEST(OpticalFlow, FindsRotationAndExpansion) {
  const Texture texture(11);
  const auto affine = [](double scale, double angle_rad) {
    return [=](double x, double y) {
      const double cx = kWidth / 2.0, cy = kHeight / 2.0, c = std::cos(angle_rad), s = std::sin(angle_rad);
      return std::pair{cx + scale * (c * (x - cx) - s * (y - cy)),
                       cy + scale * (s * (x - cx) + c * (y - cy))};
    };
  };
  for (const auto& [scale, angle_rad] : {std::pair{1.0, 0.03}, {0.96, 0.0}, {1.05, -0.02}}) {
    const Quality q = measure({}, texture, affine(scale, angle_rad));
    EXPECT_GT(q.vectors, 150U) << scale << ", " << angle_rad;
    EXPECT_LT(q.median_error_px, 0.1) << scale << ", " << angle_rad;
    EXPECT_LT(q.worst_of_95_percent_px, 0.5) << scale << ", " << angle_rad;
  }
}

TEST(OpticalFlow, KeepsItsWayWhenTheExposureChanges) {
  const Quality q = measure({}, Texture(12), shift(3.4, -1.7), 0.8, 12.0);
  EXPECT_GT(q.vectors, 100U);
  EXPECT_LT(q.median_error_px, 0.4);
  OpticalFlowParams keep_mean;
  keep_mean.tracker.remove_mean = false;
  EXPECT_LT(q.median_error_px,
            0.5 * measure(keep_mean, Texture(12), shift(3.4, -1.7), 0.8, 12.0).median_error_px);
}

TEST(OpticalFlow, DropsWhatHasNoMatch) {
  const Texture before(13), after(14);
  OpticalFlow flow({}, kWidth, kHeight);
  flow.update(draw(kWidth, kHeight, [&](int x, int y) { return before.at(x, y); }));
  const std::size_t matched =
      flow.update(draw(kWidth, kHeight, [&](int x, int y) { return after.at(x, y); })).size();
  EXPECT_LT(matched, flow.features().size() / 5);
}

TEST(OpticalFlow, FlatFramesHaveNoFlow) {
  OpticalFlow flow({}, kWidth, kHeight);
  const auto flat = draw(kWidth, kHeight, [](int, int) { return 77; });
  const Texture texture(15);
  const auto textured = draw(kWidth, kHeight, [&](int x, int y) { return texture.at(x, y); });
  EXPECT_TRUE(flow.update(flat).empty());
  EXPECT_TRUE(flow.update(flat).empty());
  EXPECT_TRUE(flow.features().empty());
  EXPECT_TRUE(flow.update(textured).empty());
  EXPECT_FALSE(flow.features().empty());
  EXPECT_TRUE(flow.update(flat).empty());
}

TEST(OpticalFlow, ForgetsTheLastFrameOnReset) {
  const Texture texture(16);
  const auto frame = draw(kWidth, kHeight, [&](int x, int y) { return texture.at(x, y); });
  OpticalFlow flow({}, kWidth, kHeight);
  flow.update(frame);
  EXPECT_FALSE(flow.update(frame).empty());
  flow.reset();
  EXPECT_TRUE(flow.update(frame).empty());
}

TEST(OpticalFlow, SameFramesGiveTheSameBits) {
  const Texture texture(17);
  const auto run = [&] {
    OpticalFlow flow({}, kWidth, kHeight);
    std::vector<FlowVector> all;
    for (int t = 0; t < 3; ++t) {
      const auto v =
          flow.update(draw(kWidth, kHeight, [&](int x, int y) { return texture.at(x + 1.7 * t, y - t); }));
      all.insert(all.end(), v.begin(), v.end());
    }
    return all;
  };
  const auto a = run(), b = run();
  ASSERT_EQ(a.size(), b.size());
  ASSERT_GT(a.size(), 300U);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].dx_px, b[i].dx_px);
    EXPECT_EQ(a[i].dy_px, b[i].dy_px);
  }
}

TEST(OpticalFlow, WorksOnTinyImages) {
  OpticalFlow flow({}, 8, 5);
  const auto frame = draw(8, 5, [](int x, int y) { return 37 * x + 91 * y * x; });
  flow.update(frame);
  for (const FlowVector& v : flow.update(frame)) EXPECT_LT(std::hypot(v.dx_px, v.dy_px), 0.1);
}

}  // namespace
}  // namespace hindsight

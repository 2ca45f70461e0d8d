// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/motion_tracker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace hindsight {
namespace {

constexpr int kWidth = 640, kHeight = 480;

struct Thing {
  double x_px, y_px, vx_px, vy_px;  ///< over the ground
  double half_px = 10.0;
};

/// Flow of a ground that the camera passes over with (3, -1) px/frame, and of things that move over it.
/// Corners keep their places on ground and things, so that their vectors can be chained.
class FlowScene {
 public:
  explicit FlowScene(unsigned seed) : random_(seed) {
    std::uniform_real_distribution<double> x(-400.0, 1100.0), y(-400.0, 900.0);
    for (int i = 0; i < 3000; ++i) ground_.push_back({x(random_), y(random_)});
  }
  std::vector<Thing> things;

  std::vector<FlowVector> next() {
    std::vector<FlowVector> flow;
    for (auto& [x, y] : ground_) add(flow, x += 3.0, y -= 1.0, -3.0, 1.0);
    for (Thing& t : things) {
      t.x_px += 3.0 + t.vx_px, t.y_px += -1.0 + t.vy_px;
      for (int i = 0; i < 16; ++i) {
        const double x = t.x_px + t.half_px * (i % 4 - 1.5) / 1.5,
                     y = t.y_px + t.half_px * (i / 4 - 1.5) / 1.5;
        add(flow, x, y, -3.0 - t.vx_px, 1.0 - t.vy_px);
      }
    }
    return flow;
  }

 private:
  void add(std::vector<FlowVector>& flow, double x, double y, double dx, double dy) {
    const float now_x = static_cast<float>(x), now_y = static_cast<float>(y);
    if (x < 0 || y < 0 || x >= kWidth || y >= kHeight) return;
    std::normal_distribution<double> noise(0.0, 0.08);
    flow.push_back(
        {now_x, now_y, static_cast<float>(dx + noise(random_)), static_cast<float>(dy + noise(random_))});
  }
  std::mt19937 random_;
  std::vector<std::pair<double, double>> ground_;
};

MotionTracker tracker(const MotionParams& params = {}) { return {params, kWidth, kHeight, 4000}; }

TEST(MotionTracker, FollowsThreeThingsUnderTheirNumbers) {
  FlowScene scene(30);
  scene.things = {{100, 300, 2.0, 0.0}, {500, 100, -4.0, 1.0}, {300, 400, 0.0, -1.5}};
  MotionTracker motion = tracker();
  std::vector<std::int32_t> ids(3);
  for (int frame = 0; frame < 40; ++frame) {
    const auto tracks = motion.update(scene.next()).tracks;
    if (frame < 28) continue;
    ASSERT_EQ(tracks.size(), 3U) << frame;
    for (std::size_t i = 0; i < 3; ++i) {
      const Thing& thing = scene.things[i];
      const auto mine = std::min_element(tracks.begin(), tracks.end(), [&](const Track& a, const Track& b) {
        const Point2f p{static_cast<float>(thing.x_px), static_cast<float>(thing.y_px)};
        return distance_px(a.at_px, p) < distance_px(b.at_px, p);
      });
      EXPECT_LT(std::hypot(mine->at_px.x_px - thing.x_px, mine->at_px.y_px - thing.y_px), 8.0);
      EXPECT_LT(std::hypot(mine->v_px.x_px - thing.vx_px, mine->v_px.y_px - thing.vy_px), 1.0);
      if (ids[i] == 0) ids[i] = mine->id;
      EXPECT_EQ(mine->id, ids[i]);
    }
  }
}

TEST(MotionTracker, TellsNothingWhereNothingMoves) {
  FlowScene scene(31);
  MotionTracker motion = tracker();
  for (int frame = 0; frame < 60; ++frame) EXPECT_TRUE(motion.update(scene.next()).tracks.empty()) << frame;
}

TEST(MotionTracker, FindsWhatWasHiddenAgainUnderItsNumber) {
  FlowScene scene(32);
  scene.things = {{150, 300, 3.0, 0.0}};
  MotionTracker motion = tracker();
  for (int frame = 0; frame < 20; ++frame) motion.update(scene.next());
  ASSERT_EQ(motion.report().tracks.size(), 1U);
  const std::int32_t id = motion.report().tracks[0].id;
  for (int frame = 0; frame < 6; ++frame) {
    std::vector<FlowVector> flow = scene.next();
    flow.resize(flow.size() - 16);  // without the thing's
    motion.update(flow);
  }
  for (int frame = 0; frame < 5; ++frame) motion.update(scene.next());
  ASSERT_EQ(motion.report().tracks.size(), 1U);
  EXPECT_EQ(motion.report().tracks[0].id, id);
}

TEST(MotionTracker, ForgetsAllAtACutAndWithoutTexture) {
  FlowScene scene(33), other(34);
  scene.things = {{150, 300, 3.0, 0.0}};
  MotionTracker motion = tracker();
  for (int frame = 0; frame < 20; ++frame) motion.update(scene.next());
  ASSERT_FALSE(motion.report().tracks.empty());
  // Matches across a cut are wrong ones: no motion that half of them agree on.
  std::vector<FlowVector> flow = other.next();
  std::mt19937 random(35);
  std::uniform_real_distribution<float> anywhere(-60.0F, 60.0F);
  for (FlowVector& v : flow) v.dx_px = anywhere(random), v.dy_px = anywhere(random);
  EXPECT_TRUE(motion.update(flow).tracks.empty());
  EXPECT_TRUE(motion.update({}).tracks.empty());
  EXPECT_TRUE(motion.update(other.next()).tracks.empty());
}

TEST(MotionTracker, IsTheSameEveryTime) {
  FlowScene scene(36), again(36);
  scene.things = again.things = {{100, 300, 2.0, 0.5}, {500, 100, -4.0, 1.0}};
  MotionTracker a = tracker(), b = tracker();
  for (int frame = 0; frame < 30; ++frame) {
    const auto x = a.update(scene.next()).tracks, y = b.update(again.next()).tracks;
    ASSERT_EQ(x.size(), y.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
      EXPECT_EQ(x[i].id, y[i].id);
      EXPECT_EQ(x[i].at_px.x_px, y[i].at_px.x_px);
      EXPECT_EQ(x[i].v_px.y_px, y[i].v_px.y_px);
    }
  }
}

}  // namespace
}  // namespace hindsight

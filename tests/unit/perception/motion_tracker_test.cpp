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
  int side = 4;  ///< corners along each
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
      const double middle = 0.5 * (t.side - 1);
      for (int i = 0; i < t.side * t.side; ++i) {
        const double x = t.x_px + t.half_px * (i % t.side - middle) / middle,
                     y = t.y_px + t.half_px * (i / t.side - middle) / middle;
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

/// What stands above the ground sways over it as the camera sways, 0.5 px a frame at most and 5 px to and
/// fro.
TEST(MotionTracker, DoesNotTellWhatOnlySwaysToAndFro) {
  FlowScene scene(37);
  scene.things = {{200, 300, 0.0, 0.0, 25.0}, {450, 200, 0.0, 0.0, 25.0}};
  MotionTracker motion = tracker();
  int told = 0;
  for (int frame = 0; frame < 200; ++frame) {
    for (Thing& t : scene.things) {
      t.vx_px = 0.5 * std::sin(0.2 * frame), t.vy_px = 0.3 * std::sin(0.31 * frame);
      t.x_px -= 3.0, t.y_px += 1.0;  // the camera keeps them in view, with its ground
    }
    told += static_cast<int>(motion.update(scene.next()).tracks.size());
  }
  EXPECT_LE(told, 20);  // of 400
}

/// Swings that take a thing off its place, but not away from home: to and fro by about its size.
TEST(MotionTracker, SoonLetsGoOfWhatSwaysFar) {
  struct Sway {
    double radius_px, swing_px, rad_per_frame;
  };
  for (const Sway& sway : {Sway{8.0, 15.0, 0.1}, Sway{16.0, 20.0, 0.2}}) {
    FlowScene scene(42);
    scene.things = {{320.0, 240.0, 0.0, 0.0, sway.radius_px}};
    MotionTracker motion = tracker();
    int told = 0;
    for (int frame = 0; frame < 200; ++frame) {
      scene.things[0].vx_px = 0.5 * sway.swing_px * sway.rad_per_frame * std::sin(sway.rad_per_frame * frame);
      told += static_cast<int>(motion.update(scene.next()).tracks.size());
    }
    EXPECT_GT(told, 0) << "else another rule tells it";
    EXPECT_LE(told, 30);
  }
}

/// A lorry is longer than the kernel of mean-shift, and shows corners at its ends alone.
TEST(MotionTracker, TellsALongThingOnce) {
  FlowScene scene(38);
  scene.things = {{80, 300, 8.0, 0.0, 5.0}, {130, 300, 8.0, 0.0, 5.0}};
  MotionTracker motion = tracker();
  for (int frame = 0; frame < 30; ++frame) {
    const auto tracks = motion.update(scene.next()).tracks;
    if (frame < 15) continue;
    EXPECT_EQ(tracks.size(), 1U) << frame;
  }
}

/// Front and rear of a lorry that drives round a bend, more than eight frames' way apart: velocities differ.
TEST(MotionTracker, TellsALongThingOnceThatTurns) {
  constexpr double kRadius_px = 160.0, kSpeed_px = 6.0, kLength_px = 57.0;
  const auto at = [](double way_px) {
    return Eigen::Vector2d(kRadius_px * std::sin(way_px / kRadius_px),
                           -kRadius_px * std::cos(way_px / kRadius_px));
  };
  FlowScene scene(41);
  for (const double way_px : {0.0, kLength_px}) {
    const Eigen::Vector2d p = at(way_px);
    scene.things.push_back({200.0 + p.x(), 380.0 + p.y(), 0.0, 0.0, 5.0});
  }
  MotionTracker motion = tracker();
  for (int frame = 0; frame < 40; ++frame) {
    for (int end = 0; end < 2; ++end) {
      const double way_px = end * kLength_px + frame * kSpeed_px;
      const Eigen::Vector2d v = at(way_px + kSpeed_px) - at(way_px);
      scene.things[static_cast<std::size_t>(end)].vx_px = v.x();
      scene.things[static_cast<std::size_t>(end)].vy_px = v.y();
    }
    const auto tracks = motion.update(scene.next()).tracks;
    if (frame < 15) continue;
    EXPECT_EQ(tracks.size(), 1U) << frame;
  }
}

/// With a gap of three frames it would be another three before its corners could be compared.
TEST(MotionTracker, SeesAtOnceWhatComesIntoViewFast) {
  FlowScene scene(39);
  MotionParams params;
  params.gap_frames = 3;
  MotionTracker motion = tracker(params);
  for (int frame = 0; frame < 10; ++frame) motion.update(scene.next());
  scene.things = {{-20, 240, 9.0, 0.0}};
  int in_view = 0;
  for (int frame = 0; frame < 10; ++frame) {
    motion.update(scene.next());
    in_view += scene.things[0].x_px > scene.things[0].half_px;
    EXPECT_TRUE(in_view != 2 || !motion.report().features.empty());
    EXPECT_TRUE(in_view != 5 || motion.report().tracks.size() == 1U);
  }
  EXPECT_GE(in_view, 5);
}

/// As documented: what fills more than half of the view is the ground, and when it has gone, the ground is
/// the ground again and what was told is forgotten.
TEST(MotionTracker, TakesWhatFillsTheViewForTheGroundAsLongAsItDoes) {
  FlowScene scene(40);
  scene.things = {{320, 240, 1.0, 4.0, 250.0, 50}};
  MotionTracker motion = tracker();
  for (int frame = 0; frame < 12; ++frame) {
    scene.things[0].x_px -= 4.0, scene.things[0].y_px -= 3.0;  // stays before the camera
    const EgoMotion& ego = motion.update(scene.next()).ego;
    ASSERT_TRUE(ego.valid) << frame;
    const Point2f then = transformed(ego.H_then_now, {320.0F, 240.0F});
    EXPECT_NEAR(then.x_px, 320.0 - 3.0 - 1.0, 0.3) << frame;
    EXPECT_NEAR(then.y_px, 240.0 + 1.0 - 4.0, 0.3) << frame;
  }
  scene.things.clear();
  for (int frame = 0; frame < 40; ++frame) motion.update(scene.next());
  const Point2f then = transformed(motion.report().ego.H_then_now, {320.0F, 240.0F});
  EXPECT_NEAR(then.x_px, 320.0 - 3.0, 0.3);
  EXPECT_NEAR(then.y_px, 240.0 + 1.0, 0.3);
  EXPECT_TRUE(motion.report().tracks.empty());
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

/// A map that says the same of every place.
class EvenPrior final : public MotionPrior {
 public:
  explicit EvenPrior(double log_ratio) : log_ratio_(log_ratio) {}
  double probability(Point2f, Point2f) const override { return 0.0; }
  bool sample(Point2f, double, Point2f&) const override { return false; }
  double log_ratio(Point2f, Point2f) const override { return log_ratio_; }

 private:
  double log_ratio_;
};

int frames_until_told(const MotionPrior* prior) {
  FlowScene scene(33);
  MotionTracker motion = tracker();
  for (int frame = 0; frame < 10; ++frame) motion.update(scene.next(), prior);
  scene.things = {{300, 200, 2.0, 1.0}};
  for (int frame = 1; frame < 60; ++frame) {
    if (!motion.update(scene.next(), prior).tracks.empty()) return frame;
  }
  return 60;
}

TEST(MotionTracker, TellsSoonerWhatTheMapExpectsAndLaterWhatItDoesNot) {
  const EvenPrior unseen(0.0), usual(4.0), never(-3.0);
  const int without = frames_until_told(nullptr);
  EXPECT_LE(without, 4) << "its first three frames, one of them the one that the flow followed it from";
  EXPECT_EQ(frames_until_told(&unseen), without);
  EXPECT_LT(frames_until_told(&usual), without);
  EXPECT_GT(frames_until_told(&never), without);
  EXPECT_LT(frames_until_told(&never), 60) << "but it is told";
}

}  // namespace
}  // namespace hindsight

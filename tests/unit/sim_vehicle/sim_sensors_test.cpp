// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include <gtest/gtest.h>

#include <GeographicLib/LocalCartesian.hpp>
#include <algorithm>
#include <cmath>
#include <map>

#include "sim_replay/vehicle/gps_receiver.h"
#include "sim_replay/vehicle/ir_sensor.h"
#include "sim_replay/vehicle/wheel_encoder.h"
#include "test_drive.h"

namespace hindsight {
namespace {

TEST(AWheelEncoder, CountsWholeTicksThatWrap) {
  WheelEncoder encoder{Random(1)};
  double way_m = 0.0, sum = 0.0;
  double before = 0.0, counted = 0.0;
  for (int i = 0; i < 1000; ++i) {
    way_m += 0.02 * 1.0;
    encoder.report(way_m, 0.02);
    EXPECT_EQ(encoder.ticks(), std::floor(encoder.ticks()));
    EXPECT_GE(encoder.ticks(), 0.0);
    EXPECT_LT(encoder.ticks(), WheelEncoder::kTicksWrap);
    counted += std::fmod(encoder.ticks() - before + WheelEncoder::kTicksWrap, WheelEncoder::kTicksWrap);
    before = encoder.ticks();
    if (i >= 100) sum += encoder.speed_mps() / 900;
  }
  EXPECT_NEAR(counted / WheelEncoder::kTicksPerMetre, way_m, 0.015 * way_m);
  EXPECT_NEAR(sum, 1.0, 0.015);
  for (int i = 0; i < 50; ++i) encoder.report(way_m, 0.02);
  EXPECT_EQ(encoder.speed_mps(), 0.0);
}

/// Steps along each of many rays until something is met.
double marched_range_m(const IrMount& mount, const PlanarPose& X_WB, const std::vector<Obstacle>& obstacles) {
  const WorldPoint from = X_WB.to_world({mount.x_m, mount.y_m});
  double nearest_m = mount.longest_m;
  for (int ray = 0; ray < 201; ++ray) {
    const double angle_rad = X_WB.heading_rad + mount.half_angle_rad * (ray / 100.0 - 1.0);
    for (double range_m = 0.0; range_m < nearest_m; range_m += 0.0005) {
      const WorldPoint p{from.x_m + range_m * std::cos(angle_rad), from.y_m + range_m * std::sin(angle_rad)};
      if (std::any_of(obstacles.begin(), obstacles.end(),
                      [p](const Obstacle& o) { return distance_m(o, p) <= 0.0; })) {
        nearest_m = range_m;
      }
    }
  }
  return nearest_m;
}

/// Trunks may lie between rays or send back too little: those are seen by the marched rays only.
TEST(AnIrSensor, MeasuresWhatRaysMarchedThroughItsConeMeet) {
  Random random(12);
  int seen = 0, missed = 0;
  for (int i = 0; i < 300; ++i) {
    std::vector<Obstacle> obstacles;
    for (int k = 0; k < 3; ++k) {
      const WorldPoint a{random.uniform(-1.5, 3.0), random.uniform(-1.5, 1.5)};
      const WorldPoint b =
          random.chance(0.5) ? a : WorldPoint{a.x_m + random.uniform(-2.0, 2.0), a.y_m + 1.0};
      obstacles.push_back({a, b, random.uniform(0.08, 0.4), 2.0, TruthLabel::bush, false});
    }
    const IrMount mount;
    const PlanarPose X_WB{random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), random.uniform(-3.0, 3.0)};
    const double marched_m = marched_range_m(mount, X_WB, obstacles);
    const double range_m = ir_range_m(mount, X_WB, obstacles);
    if (range_m == mount.longest_m) {
      missed += marched_m < mount.longest_m ? 1 : 0;
      continue;
    }
    ++seen;
    EXPECT_GE(range_m, marched_m - 0.001) << i;
    EXPECT_LE(range_m, marched_m + 0.04) << i;
  }
  EXPECT_GT(seen, 80);
  EXPECT_LT(missed, 8);
}

TEST(AnIrSensor, LooksOverWhatIsLow) {
  const IrMount mount;
  std::vector<Obstacle> one{{{1.2, 0.25}, {1.2, 0.25}, 0.3, 0.2, TruthLabel::rock, false}};
  EXPECT_EQ(ir_range_m(mount, {}, one), mount.longest_m);
  one[0].height_m = 0.5;
  EXPECT_NEAR(ir_range_m(mount, {}, one), 0.55, 0.001);
}

TEST(AnIrSensor, SeesBushesThatCanBeDrivenThrough) {
  World world = flat_world(Ground::grass);
  world.bushes.push_back({{1.5, 0.35}, 0.3, 0.8, true, 1});
  TestDrive drive(world);
  drive.drive(0.0, 0.0, 1.0);
  EXPECT_NEAR(drive.signals().ir_left_m, 0.85, 0.06);
  EXPECT_EQ(drive.signals().ir_right_m, 1.5) << "nothing there: the longest range";
}

/// Seed 21, ten hours: the offset's standard deviation and how it is forgotten.
TEST(AGpsReceiver, WalksAsItIsSaidTo) {
  GpsReceiver receiver{Random(21)};
  const GeographicLib::LocalCartesian earth(kOriginLatitude_deg, kOriginLongitude_deg, kOriginAltitude_m);
  std::map<int, double> east_m;
  constexpr int kSeconds = 36000;
  for (int s = 0; s < kSeconds; ++s) {
    const auto fix = receiver.fix(from_seconds(s), {30.0, -20.0}, 1.0, 0.0);
    if (!fix) continue;
    double east = 0.0, north = 0.0, up = 0.0;
    earth.Forward(fix->latitude_deg, fix->longitude_deg, fix->altitude_m, east, north, up);
    east_m[s] = east - 30.0;
    EXPECT_GT(fix->horizontal_sigma_m, 1.9);
    EXPECT_LT(fix->horizontal_sigma_m, 2.2);
  }
  EXPECT_GT(east_m.size(), 0.97 * kSeconds);
  EXPECT_LT(east_m.size(), kSeconds) << "some are lost in the open too";
  double sum = 0.0, sum2 = 0.0, product = 0.0, pairs = 0.0;
  for (const auto& [s, error_m] : east_m) {
    sum += error_m;
    sum2 += error_m * error_m;
    const auto later = east_m.find(s + 60);
    if (later == east_m.end()) continue;
    product += error_m * later->second;
    pairs += 1.0;
  }
  const auto n = static_cast<double>(east_m.size());
  const double sigma_m = std::sqrt(sum2 / n);
  EXPECT_NEAR(sum / n, 0.0, 0.4);
  EXPECT_NEAR(sigma_m, 2.0, 0.3);
  EXPECT_NEAR(product / pairs / (sum2 / n), std::exp(-1.0), 0.1);
}

TEST(AGpsReceiver, LosesFixesUnderLeaves) {
  GpsReceiver receiver{Random(22)};
  int fixes = 0;
  for (int s = 0; s < 10000; ++s) fixes += receiver.fix(from_seconds(s), {}, 0.0, 0.8).has_value() ? 1 : 0;
  EXPECT_GT(fixes, 6000);
  EXPECT_LT(fixes, 9000);
}

TEST(ABase, ReportsAtTheRatesOfItsProtocol) {
  TestDrive drive(flat_world(Ground::grass));
  std::map<std::uint32_t, int> frames;
  std::size_t fixes = 0;
  for (int i = 0; i < 1000; ++i) {
    drive.step(WheelCommand{});
    for (const CanFrame& frame : drive.heard.can) ++frames[frame.id];
    fixes += drive.heard.fixes.size();
  }
  EXPECT_EQ(frames,
            (std::map<std::uint32_t, int>{{256, 500}, {257, 500}, {258, 200}, {259, 10}, {260, 1000}}));
  EXPECT_EQ(fixes, 10U);
  EXPECT_EQ(
      drive.signals().bus.bad_checksums + drive.signals().bus.bad_counters + drive.signals().bus.bad_values,
      0U);
  EXPECT_NEAR(drive.signals().battery_v, 26.0, 0.2);
  std::vector<LineEdge> levels;
  drive.vehicle.report_lines(drive.now, levels);
  EXPECT_EQ(levels.size(), 3U);
}

}  // namespace
}  // namespace hindsight

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/slip_detector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <random>
#include <vector>

#include "config/exit_code.h"

namespace hindsight {
namespace {

constexpr double kRate_hz = 50.0;
constexpr double kLoad_a = 5.0;
constexpr double kOnset_s = 10.0;

SlipDetectorParams thesis() {
  SlipDetectorParams params;
  params.half_width_hz = 0.5;
  params.window = "rectangular";
  params.local_peak = false;
  params.noise_probability = 1.0;
  params.min_dc_a = params.min_speed_mps = params.hold_s = 0.0;
  return params;
}

double sine(double t, double hz) { return std::sin(2.0 * M_PI * hz * t); }

/// Both motors at a load that wanders slowly (a tenth of it) under noise (a fifth of it).
class Motors {
 public:
  explicit Motors(const SlipDetectorParams& params, unsigned seed = 1)
      : detector(params, kRate_hz), random_(seed) {}

  /// Runs until `end_s`; `extra_a` is added to the left current. Returns when slip was first told from now
  /// on.
  std::optional<double> run(double end_s, const std::function<double(double)>& extra_a) {
    std::optional<double> told_s;
    for (; t_s < end_s; t_s += 1.0 / kRate_hz) {
      for (double& wander : wander_a_) wander += 0.004 * (0.2 * kLoad_a * 5.0 * normal_(random_) - wander);
      const Time now = from_seconds(t_s);
      const double noise_a = 0.2 * kLoad_a;
      detector.add_current(Wheel::left, now,
                           kLoad_a + wander_a_[0] + noise_a * normal_(random_) + extra_a(t_s));
      detector.add_current(Wheel::right, now, kLoad_a + wander_a_[1] + noise_a * normal_(random_));
      const WheelMotion motion{speed_mps, speed_mps};
      if (detector.update(now, {motion, motion}).slipping && !told_s) told_s = t_s;
    }
    return told_s;
  }
  std::optional<double> run(double end_s) {
    return run(end_s, [](double) { return 0.0; });
  }

  SlipDetector detector;
  double t_s = 0.0;
  double speed_mps = 0.5;

 private:
  std::mt19937 random_;
  std::normal_distribution<double> normal_{0.0, 1.0};
  std::array<double, 2> wander_a_{};
};

/// Median time from the beginning of an oscillation to the report, over seeds; all must be told.
double median_delay_s(const SlipDetectorParams& params, double hz, double amplitude_over_mean) {
  std::vector<double> delays_s;
  for (unsigned seed = 0; seed < 41; ++seed) {
    Motors motors(params, seed);
    EXPECT_FALSE(motors.run(kOnset_s).has_value()) << seed;
    const auto told_s = motors.run(
        kOnset_s + 4.0, [&](double t) { return amplitude_over_mean * kLoad_a * sine(t + 0.01 * seed, hz); });
    delays_s.push_back(told_s.value_or(1e9) - kOnset_s);
  }
  std::sort(delays_s.begin(), delays_s.end());
  EXPECT_LT(delays_s.back(), 2.5);
  return delays_s[delays_s.size() / 2];
}

TEST(SlipDetector, TellsAStrongOscillationWithinASecond) {
  EXPECT_LT(median_delay_s({}, 3.0, 1.2), 1.0);
  EXPECT_LT(median_delay_s({}, 2.8, 1.2), 1.05);
  EXPECT_LT(median_delay_s({}, 3.2, 1.2), 1.05);
}

TEST(SlipDetector, TellsAWeakerOneWithinTheWindow) {
  EXPECT_LT(median_delay_s({}, 3.0, 0.8), 1.4);
  EXPECT_LT(median_delay_s({}, 3.0, 0.65), 2.0);
}

TEST(SlipDetector, ThesisTellsBoth) {
  EXPECT_LT(median_delay_s(thesis(), 3.0, 1.2), 1.0);
  EXPECT_LT(median_delay_s(thesis(), 3.0, 0.65), 2.0);
}

TEST(SlipDetector, IsSilentOnTenMinutesOfLoad) {
  Motors motors(SlipDetectorParams{}, 3);
  EXPECT_FALSE(motors.run(600.0).has_value());
}

TEST(SlipDetector, SaysWhichWheelAndWhat) {
  Motors motors(SlipDetectorParams{}, 4);
  motors.run(kOnset_s);
  motors.run(kOnset_s + 3.0, [](double t) { return kLoad_a * sine(t, 3.0); });
  const SlipReport& report = motors.detector.report();
  EXPECT_TRUE(report.wheels[0].slipping);
  EXPECT_FALSE(report.wheels[1].slipping);
  EXPECT_NEAR(report.wheels[0].component, 0.5, 0.1);
  EXPECT_DOUBLE_EQ(report.wheels[0].component_hz, 3.0);
  EXPECT_NEAR(report.wheels[0].mean_a, kLoad_a, 1.5);
  EXPECT_GT(report.wheels[0].share, 0.7);
  EXPECT_NEAR(motors.detector.spectrum(Wheel::left).relative_amplitudes()[6], report.wheels[0].component,
              1e-6);
}

TEST(SlipDetector, IsSilentAtStandStill) {
  Motors motors(SlipDetectorParams{}, 5);
  motors.speed_mps = 0.0;
  EXPECT_FALSE(motors.run(10.0, [](double t) { return kLoad_a * sine(t, 3.0); }).has_value());
}

TEST(SlipDetector, IsSilentUnlessCommandedAndTurning) {
  SlipDetector detector(SlipDetectorParams{}, kRate_hz);
  const WheelMotion coasting{0.0, 0.5}, blocked{0.5, 0.0};
  for (double t = 0.0; t < 5.0; t += 1.0 / kRate_hz) {
    for (const Wheel wheel : {Wheel::left, Wheel::right}) {
      detector.add_current(wheel, from_seconds(t), kLoad_a + kLoad_a * sine(t, 3.0));
    }
    EXPECT_FALSE(detector.update(from_seconds(t), {coasting, blocked}).slipping);
  }
}

TEST(SlipDetector, TakesNoNeighbourForItsOwn) {
  for (const double hz : {1.0, 2.0, 2.5, 3.6, 4.0, 5.0}) {
    Motors motors(SlipDetectorParams{}, 6);
    EXPECT_FALSE(motors.run(60.0, [hz](double t) { return 1.2 * kLoad_a * sine(t, hz); }).has_value()) << hz;
  }
  Motors motors(thesis(), 6);
  EXPECT_TRUE(motors.run(60.0, [](double t) { return 1.2 * kLoad_a * sine(t, 2.5); }).has_value());
}

TEST(SlipDetector, TakesNoStepForAnOscillation) {
  for (const double step : {-0.8, 1.0, 4.0}) {
    Motors motors(SlipDetectorParams{}, 7);
    EXPECT_FALSE(motors.run(30.0, [&](double t) { return t > 10.0 ? step * kLoad_a : 0.0; }).has_value())
        << step;
  }
}

TEST(SlipDetector, IsSilentOnAnIdleMotor) {
  SlipDetector detector(SlipDetectorParams{}, kRate_hz);
  const WheelMotion motion{0.5, 0.5};
  for (double t = 0.0; t < 5.0; t += 1.0 / kRate_hz) {
    detector.add_current(Wheel::left, from_seconds(t), 0.5 + 0.5 * sine(t, 3.0));
    EXPECT_FALSE(detector.update(from_seconds(t), {motion, motion}).slipping);
  }
}

TEST(SlipDetector, TakesAReversedCurrentAlike) {
  SlipDetector detector(SlipDetectorParams{}, kRate_hz);
  const WheelMotion motion{-0.5, -0.5};
  for (double t = 0.0; t < 5.0; t += 1.0 / kRate_hz) {
    detector.add_current(Wheel::right, from_seconds(t), -kLoad_a + kLoad_a * sine(t, 3.0));
    detector.update(from_seconds(t), {motion, motion});
  }
  EXPECT_TRUE(detector.report().wheels[1].slipping);
}

TEST(SlipDetector, SlipEndsAfterTheHoldAndAtOnceWhenTheWheelStops) {
  Motors motors(SlipDetectorParams{}, 8);
  motors.run(kOnset_s);
  ASSERT_TRUE(motors.run(kOnset_s + 4.0, [](double t) { return kLoad_a * sine(t, 3.0); }).has_value());
  motors.run(kOnset_s + 4.9);
  EXPECT_TRUE(motors.detector.report().slipping);
  motors.run(kOnset_s + 8.0);
  EXPECT_FALSE(motors.detector.report().slipping);
  motors.run(kOnset_s + 12.0, [](double t) { return kLoad_a * sine(t, 3.0); });
  ASSERT_TRUE(motors.detector.report().slipping);
  motors.speed_mps = 0.0;
  motors.run(kOnset_s + 12.03);
  EXPECT_FALSE(motors.detector.report().slipping);
}

TEST(SlipDetector, RefusesARateThatDoesNotShowTheFrequency) {
  try {
    SlipDetector(SlipDetectorParams{}, 6.0);
    FAIL();
  } catch (const FatalError& error) {
    EXPECT_EQ(error.code(), kExitConfiguration);
    EXPECT_STREQ(error.what(),
                 "slip detector: motor currents at 6 Hz do not show 3 Hz; expected more than 6 Hz");
  }
}

}  // namespace
}  // namespace hindsight

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/renderer/auto_exposure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hindsight {
namespace {

/// A scene of so much light, as the sensor would show it.
double mean_of(const AutoExposure& meter, double light) {
  const double exposed = static_cast<double>(meter.exposure_s() * meter.gain()) * light;
  return 255.0 * std::min(1.0, std::pow(exposed, 1.0 / 2.2));
}

void follow(AutoExposure& meter, double light, double for_s) {
  for (double t_s = 0.0; t_s < for_s; t_s += 0.1) meter.meter(mean_of(meter, light), 0.1);
}

TEST(AnAutoExposure, ConvergesAfterAChange) {
  AutoExposure meter;
  follow(meter, 300.0, 20.0);
  const double settled = mean_of(meter, 300.0);
  const double darkened = mean_of(meter, 100.0);
  EXPECT_LT(darkened, 0.7 * settled);
  follow(meter, 100.0, 0.5);
  EXPECT_LT(mean_of(meter, 100.0), 0.95 * settled) << "it lags";
  follow(meter, 100.0, 10.0);
  EXPECT_NEAR(mean_of(meter, 100.0), settled, 2.0);
}

TEST(AnAutoExposure, TakesGainOnlyWhereTimeIsNotEnough) {
  AutoExposure meter;
  follow(meter, 300.0, 20.0);
  EXPECT_EQ(meter.gain(), 1.0F);
  follow(meter, 3.0, 60.0);
  EXPECT_GT(meter.gain(), 2.0F);
  EXPECT_NEAR(meter.exposure_s(), 1.0 / 60.0, 1e-6);
}

}  // namespace
}  // namespace hindsight

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/vehicle/gps_receiver.h"

#include <GeographicLib/LocalCartesian.hpp>
#include <algorithm>
#include <cmath>

namespace hindsight {
namespace {

constexpr double kPeriod_s = 1.0;
constexpr double kOffsetSigma_m = 2.0;
constexpr double kOffsetTime_s = 60.0;
constexpr double kNoise_m = 0.3;
constexpr double kNoiseUnderLeaves_m = 1.0;
constexpr double kAltitudeNoise_m = 1.0;
constexpr double kLossInTheOpen = 0.002;
constexpr double kLossUnderLeaves = 0.08;
constexpr double kShortestLoss_s = 2.0;
constexpr double kLongestLoss_s = 8.0;

}  // namespace

GpsReceiver::GpsReceiver(Random random)
    : random_(random), offset_{kOffsetSigma_m * random_.normal(), kOffsetSigma_m * random_.normal()} {}

std::optional<GpsFix> GpsReceiver::fix(Time stamp, WorldPoint p_W, double z_m, double cover) {
  const double kept = std::exp(-kPeriod_s / kOffsetTime_s);
  const double walk_m = kOffsetSigma_m * std::sqrt(1.0 - kept * kept);
  offset_ = {kept * offset_.x_m + walk_m * random_.normal(), kept * offset_.y_m + walk_m * random_.normal()};
  const double noise_m = kNoise_m + cover * kNoiseUnderLeaves_m;
  const double east_m = p_W.x_m + offset_.x_m + noise_m * random_.normal();
  const double north_m = p_W.y_m + offset_.y_m + noise_m * random_.normal();
  const double up_m = z_m + kAltitudeNoise_m * random_.normal();
  if (random_.chance(kLossInTheOpen + cover * kLossUnderLeaves)) {
    lost_s_ = random_.uniform(kShortestLoss_s, kLongestLoss_s);
  }
  lost_s_ = std::max(0.0, lost_s_ - kPeriod_s);
  if (lost_s_ > 0.0) return std::nullopt;
  const GeographicLib::LocalCartesian earth(kOriginLatitude_deg, kOriginLongitude_deg, kOriginAltitude_m);
  GpsFix fix{.stamp = stamp, .horizontal_sigma_m = std::hypot(kOffsetSigma_m, noise_m)};
  earth.Reverse(east_m, north_m, up_m, fix.latitude_deg, fix.longitude_deg, fix.altitude_m);
  return fix;
}

}  // namespace hindsight

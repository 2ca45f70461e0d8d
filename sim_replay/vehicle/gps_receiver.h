// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>

#include "drivers/samples.h"
#include "sim_replay/world/random.h"
#include "sim_replay/world/world.h"

namespace hindsight {

/// Where the origin of W lies on the earth (WGS84): x leads east, y north from there.
constexpr double kOriginLatitude_deg = 37.4219;
constexpr double kOriginLongitude_deg = -122.1700;
constexpr double kOriginAltitude_m = 60.0;

/// A receiver without corrections: an offset that walks (Gauss-Markov, one standard deviation 2 m, 60 s),
/// white noise, and times without a fix, mostly under crowns.
class GpsReceiver {
 public:
  explicit GpsReceiver(Random random);

  /// The fix of one second, if there is one. `cover`: share of the sky that leaves hide, 0 to 1.
  std::optional<GpsFix> fix(Time stamp, WorldPoint p_W, double z_m, double cover);

 private:
  Random random_;
  WorldPoint offset_;
  double lost_s_ = 0.0;
};

}  // namespace hindsight

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>

#include "drivers/samples.h"
#include "perception/pose.h"

namespace GeographicLib {
class LocalCartesian;
}

namespace hindsight {

/// A local east-north-up frame E that touches the WGS84 ellipsoid's normal at its origin; no flat-earth
/// formulas. Allocates at construction only. One thread at a time.
class GeodeticFrame {
 public:
  GeodeticFrame();
  ~GeodeticFrame();
  GeodeticFrame(GeodeticFrame&&) noexcept;
  GeodeticFrame& operator=(GeodeticFrame&&) noexcept;

  /// Moves the origin to the fix, at its altitude.
  void set_origin(const GpsFix& fix);
  /// p_EP_m: x east, y north, of a point at the origin's altitude. Latitude in [-90, 90]; the result is NaN
  /// outside.
  Point2 east_north(double latitude_deg, double longitude_deg) const;

 private:
  std::unique_ptr<GeographicLib::LocalCartesian> local_;
};

}  // namespace hindsight

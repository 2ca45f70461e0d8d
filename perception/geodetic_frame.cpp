// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/geodetic_frame.h"

#include <GeographicLib/LocalCartesian.hpp>

namespace hindsight {

GeodeticFrame::GeodeticFrame() : local_(std::make_unique<GeographicLib::LocalCartesian>()) {}
GeodeticFrame::~GeodeticFrame() = default;
GeodeticFrame::GeodeticFrame(GeodeticFrame&&) noexcept = default;
GeodeticFrame& GeodeticFrame::operator=(GeodeticFrame&&) noexcept = default;

void GeodeticFrame::set_origin(const GpsFix& fix) {
  local_->Reset(fix.latitude_deg, fix.longitude_deg, fix.altitude_m);
}

Point2 GeodeticFrame::east_north(double latitude_deg, double longitude_deg) const {
  double east_m = 0.0, north_m = 0.0, up_m = 0.0;
  local_->Forward(latitude_deg, longitude_deg, local_->HeightOrigin(), east_m, north_m, up_m);
  return {east_m, north_m};
}

}  // namespace hindsight

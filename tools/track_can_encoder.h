// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

#include "drivers/can_roles.h"
#include "drivers/vehicle_base_codec.h"
#include "sim_replay/importer.h"

namespace hindsight::tools {

/// A track's wheel speeds, currents, ranges and yaw rates as the frames that the vehicle's base would have sent.
class TrackCanEncoder : public TrackEncoder {
 public:
  /// `dbc_text`: the protocol to encode by, `dbc_name` what messages call it; FatalError as parse_dbc() and
  /// map_sensor_messages().
  TrackCanEncoder(std::string dbc_text, const std::string& dbc_name, const CanRolesParams& roles);

  void encode(const TrackRow& row, Time stamp, std::vector<CanFrame>& frames) override;
  std::string dbc() const override { return text_; }

 private:
  std::string text_;
  VehicleBaseCodec codec_;
  VehicleSignals signals_;
};

}  // namespace hindsight::tools

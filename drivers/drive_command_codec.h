// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "drivers/can_codec.h"
#include "drivers/can_roles.h"

namespace hindsight {

struct WheelSetpoints {
  double left_mps = 0.0;
  double right_mps = 0.0;
  bool enable = false;
};

/// The drive command's message, both ways.
class DriveCommandCodec {
 public:
  /// Throws as map_sensor_messages(); the command's signals must be in one message.
  DriveCommandCodec(const Dbc& dbc, const CanRolesParams& roles);

  std::uint32_t id() const { return message_.id(); }
  /// A frame with checksum; `counter` is wrapped to the signal's width. Speeds are held to the signal's
  /// limits; a speed that is not finite makes the command zero and not enabled.
  CanFrame encode(const WheelSetpoints& command, std::uint32_t counter) const;
  /// False for a frame of another id, or with a wrong length or checksum.
  bool decode(const CanFrame& frame, WheelSetpoints& command, std::uint32_t& counter) const;

 private:
  struct Found;
  DriveCommandCodec(const Found& found, const Dbc& dbc, const CanRolesParams& roles);

  ProtectedMessage message_;
  DbcSignal left_;
  DbcSignal right_;
  std::optional<DbcSignal> enable_;  // empty: the vehicle has none
};

}  // namespace hindsight

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "drivers/drive_command_codec.h"

#include <fmt/format.h>

#include <cmath>

#include "config/exit_code.h"
#include "drivers/signal_mapping.h"

namespace hindsight {
namespace {

void require_same_message(const Dbc& dbc, const DbcMessage* first, const DbcMessage* other) {
  if (first == other) return;
  throw FatalError(kExitConfiguration,
                   fmt::format("{}: the drive command's signals must be in one message, but are in {} and {}",
                               dbc.path, first->name, other->name));
}

}  // namespace

struct DriveCommandCodec::Found {
  RoleSignal left;
  RoleSignal right;
  RoleSignal enable;  // empty: the vehicle has none

  Found(const Dbc& dbc, const CanRolesParams& roles)
      : left(find_role(dbc, "command_left_speed", roles.command_left_speed, "m/s")),
        right(find_role(dbc, "command_right_speed", roles.command_right_speed, "m/s")) {
    require_same_message(dbc, left.message, right.message);
    if (left.signal == right.signal) {
      throw FatalError(kExitConfiguration,
                       fmt::format("{}: can roles command_left_speed and command_right_speed are both {}",
                                   dbc.path, roles.command_left_speed));
    }
    if (roles.command_enable.empty()) return;
    enable = find_role(dbc, "command_enable", roles.command_enable, "");
    require_same_message(dbc, left.message, enable.message);
  }
};

DriveCommandCodec::DriveCommandCodec(const Dbc& dbc, const CanRolesParams& roles)
    : DriveCommandCodec(Found(dbc, roles), dbc, roles) {}

DriveCommandCodec::DriveCommandCodec(const Found& found, const Dbc& dbc, const CanRolesParams& roles)
    : message_(dbc, *found.left.message, roles.counter, roles.checksum),
      left_(*found.left.signal),
      right_(*found.right.signal) {
  if (found.enable.signal != nullptr) enable_ = *found.enable.signal;
}

CanFrame DriveCommandCodec::encode(const WheelSetpoints& command, std::uint32_t counter) const {
  const bool finite = std::isfinite(command.left_mps) && std::isfinite(command.right_mps);
  CanFrame frame;
  encode_signal(frame.data, left_, finite ? command.left_mps : 0.0);
  encode_signal(frame.data, right_, finite ? command.right_mps : 0.0);
  if (enable_) encode_signal(frame.data, *enable_, finite && command.enable ? 1.0 : 0.0);
  message_.seal(frame, counter);
  return frame;
}

bool DriveCommandCodec::decode(const CanFrame& frame, WheelSetpoints& command, std::uint32_t& counter) const {
  if (frame.id != message_.id() || message_.check(frame) != FrameFault::none) return false;
  command.left_mps = decode_signal(frame.data, left_);
  command.right_mps = decode_signal(frame.data, right_);
  command.enable = !enable_ || decode_signal(frame.data, *enable_) != 0.0;
  counter = message_.counter(frame);
  return true;
}

}  // namespace hindsight

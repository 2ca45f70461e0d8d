// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "drivers/can_codec.h"
#include "drivers/can_roles.h"
#include "drivers/vehicle_signals.h"

namespace hindsight {

/// A mapped message with the signals that play a role in it.
struct MappedMessage {
  struct Binding {
    DbcSignal signal;
    double VehicleSignals::*value = nullptr;
    SignalGroup group = SignalGroup::wheels;
    std::uint32_t bit = 0;  ///< one per role
  };
  ProtectedMessage message;
  std::vector<Binding> bindings;
};

/// A role's place in a DBC file; both point into the Dbc.
struct RoleSignal {
  const DbcMessage* message = nullptr;
  const DbcSignal* signal = nullptr;
};

/// The longest signal that may play a role: its values are exact in a double.
constexpr int kMostRoleBits = 52;

/// Finds the signal that `source` ("MESSAGE.SIGNAL") names. Throws FatalError(kExitConfiguration) that names
/// role, source and file where there is none, or where it is multiplexed, floating point, or of another unit.
RoleSignal find_role(const Dbc& dbc, const char* role, const std::string& source, const char* unit);

/// The messages that carry the vehicle's signals, from the DBC file and the roles. Throws
/// FatalError(kExitConfiguration) that names role, message.signal and file: a required role that is empty, a
/// signal that the file lacks, is multiplexed, or has another unit; a message without counter or checksum.
std::vector<MappedMessage> map_sensor_messages(const Dbc& dbc, const CanRolesParams& roles);

}  // namespace hindsight

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "drivers/signal_mapping.h"

namespace hindsight {

/// The other end of the protocol: what the vehicle's base sends. For the simulator, the importer and tests.
class VehicleBaseCodec {
 public:
  VehicleBaseCodec(const Dbc& dbc, const CanRolesParams& roles);

  /// Appends the frames of all messages that carry a signal of `group`, stamped `stamp`, with values from
  /// `signals` and the next counters. Appends nothing where the vehicle has no such group.
  void encode(SignalGroup group, const VehicleSignals& signals, Time stamp, std::vector<CanFrame>& frames);

 private:
  std::vector<MappedMessage> messages_;
  std::vector<std::uint32_t> counters_;
};

}  // namespace hindsight

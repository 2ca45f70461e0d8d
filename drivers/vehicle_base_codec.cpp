// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "drivers/vehicle_base_codec.h"

#include <algorithm>

namespace hindsight {

VehicleBaseCodec::VehicleBaseCodec(const Dbc& dbc, const CanRolesParams& roles)
    : messages_(map_sensor_messages(dbc, roles)), counters_(messages_.size(), 0) {}

void VehicleBaseCodec::encode(SignalGroup group, const VehicleSignals& signals, Time stamp,
                              std::vector<CanFrame>& frames) {
  for (std::size_t i = 0; i < messages_.size(); ++i) {
    const auto& [message, bindings] = messages_[i];
    if (std::none_of(bindings.begin(), bindings.end(), [&](const auto& b) { return b.group == group; }))
      continue;
    CanFrame& frame = frames.emplace_back(CanFrame{.stamp = stamp});
    for (const MappedMessage::Binding& binding : bindings) {
      encode_signal(frame.data, binding.signal, signals.*binding.value);
    }
    message.seal(frame, counters_[i]);
    counters_[i] = message.next_counter(counters_[i]);
  }
}

}  // namespace hindsight

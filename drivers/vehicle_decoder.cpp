// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "drivers/vehicle_decoder.h"

#include <linux/can.h>
#include <linux/can/error.h>

#include <algorithm>

namespace hindsight {
namespace {

constexpr std::array<Time VehicleSignals::*, kSignalGroupCount> kStamps{
    &VehicleSignals::wheels_stamp, &VehicleSignals::ticks_stamp,   &VehicleSignals::currents_stamp,
    &VehicleSignals::ir_stamp,     &VehicleSignals::battery_stamp, &VehicleSignals::imu_stamp};

constexpr std::size_t index_of(SignalGroup group) { return static_cast<std::size_t>(group); }

}  // namespace

VehicleDecoder::VehicleDecoder(const Dbc& dbc, const CanRolesParams& roles)
    : messages_(map_sensor_messages(dbc, roles)), last_counters_(messages_.size(), -1) {
  for (const MappedMessage& mapped : messages_) {
    counts_.push_back({.name = mapped.message.name()});
    for (const MappedMessage::Binding& binding : mapped.bindings) {
      group_roles_[index_of(binding.group)] |= binding.bit;
      mapped_.add(binding.group);
    }
  }
}

std::vector<std::uint32_t> VehicleDecoder::received_ids() const {
  std::vector<std::uint32_t> ids;
  for (const MappedMessage& mapped : messages_) ids.push_back(mapped.message.id());
  return ids;
}

SignalGroups VehicleDecoder::decode(const CanFrame& frame) {
  if ((frame.id & CAN_ERR_FLAG) != 0) {
    decode_error_frame(frame);
    return {};
  }
  const auto found = std::find_if(messages_.begin(), messages_.end(), [&](const MappedMessage& mapped) {
    return mapped.message.id() == frame.id;
  });
  if (found == messages_.end()) return {};
  const auto index = static_cast<std::size_t>(found - messages_.begin());
  const bool good = accept(index, frame);
  MessageCounts& counts = counts_[index];
  counts.consecutive_bad = good ? 0 : counts.consecutive_bad + 1;
  signals_.bus.consecutive_bad = 0;
  for (const MessageCounts& each : counts_) {
    signals_.bus.consecutive_bad = std::max(signals_.bus.consecutive_bad, each.consecutive_bad);
  }
  if (!good) return {};
  ++counts.good;
  ++signals_.bus.good_frames;
  return take_values(*found, frame);
}

bool VehicleDecoder::accept(std::size_t index, const CanFrame& frame) {
  const MappedMessage& mapped = messages_[index];
  if (mapped.message.check(frame) != FrameFault::none) {
    ++counts_[index].bad_checksum;
    ++signals_.bus.bad_checksums;
    return false;
  }
  const std::int64_t last = std::exchange(last_counters_[index], mapped.message.counter(frame));
  if (last >= 0 && last_counters_[index] != mapped.message.next_counter(static_cast<std::uint32_t>(last))) {
    ++counts_[index].bad_counter;
    ++signals_.bus.bad_counters;
    return false;
  }
  const bool plausible =
      std::all_of(mapped.bindings.begin(), mapped.bindings.end(), [&](const auto& binding) {
        return within_limits(binding.signal, decode_signal(frame.data, binding.signal));
      });
  if (!plausible) {
    ++counts_[index].bad_value;
    ++signals_.bus.bad_values;
  }
  return plausible;
}

SignalGroups VehicleDecoder::take_values(const MappedMessage& mapped, const CanFrame& frame) {
  SignalGroups fresh;
  for (const MappedMessage::Binding& binding : mapped.bindings) {
    signals_.*binding.value = decode_signal(frame.data, binding.signal);
    std::uint32_t& arrived = arrived_[index_of(binding.group)];
    arrived |= binding.bit;
    if (arrived != group_roles_[index_of(binding.group)]) continue;
    arrived = 0;
    signals_.*kStamps[index_of(binding.group)] = frame.stamp;
    fresh.add(binding.group);
  }
  return fresh;
}

void VehicleDecoder::decode_error_frame(const CanFrame& frame) {
  BusHealth& bus = signals_.bus;
  ++bus.error_frames;
  if ((frame.id & CAN_ERR_BUSOFF) != 0) {
    ++bus.bus_offs;
    bus.bus_off = true;
  }
  if ((frame.id & CAN_ERR_RESTARTED) != 0) bus.bus_off = false;
  if ((frame.id & (CAN_ERR_CRTL | CAN_ERR_CNT)) != 0) {
    bus.transmit_errors = frame.data[6];
    bus.receive_errors = frame.data[7];
  }
}

}  // namespace hindsight

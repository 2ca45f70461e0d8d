// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "drivers/signal_mapping.h"

namespace hindsight {

/// What has happened to one message's frames since start.
struct MessageCounts {
  std::string name;
  std::uint32_t good = 0;
  std::uint32_t bad_checksum = 0;  ///< or of a wrong length
  std::uint32_t bad_counter = 0;
  std::uint32_t bad_value = 0;
  std::uint32_t consecutive_bad = 0;
};

/// Decodes the frames of the vehicle's messages. A pure function of the frames it was given, in order: the
/// core step owns one. A frame with a wrong length, checksum, counter or value changes no signal and is
/// counted; after a skipped counter the next frame is good again. A group is fresh when each of its signals
/// has come since it last was, so that left and right may come in two messages. No allocation after
/// construction.
class VehicleDecoder {
 public:
  VehicleDecoder(const Dbc& dbc, const CanRolesParams& roles);

  /// Takes in one frame, also error frames and frames of others (ignored). Returns the groups that have a new
  /// sample; signals() holds it until the next call.
  SignalGroups decode(const CanFrame& frame);

  const VehicleSignals& signals() const { return signals_; }
  /// The groups that this vehicle has.
  SignalGroups mapped() const { return mapped_; }
  std::span<const MessageCounts> messages() const { return counts_; }
  /// The identifiers to receive, for SocketCanBus.
  std::vector<std::uint32_t> received_ids() const;

 private:
  void decode_error_frame(const CanFrame& frame);
  bool accept(std::size_t index, const CanFrame& frame);
  SignalGroups take_values(const MappedMessage& mapped, const CanFrame& frame);

  std::vector<MappedMessage> messages_;
  std::vector<MessageCounts> counts_;
  std::vector<std::int64_t> last_counters_;                     // -1: none yet
  std::array<std::uint32_t, kSignalGroupCount> group_roles_{};  // bits of each group's roles
  std::array<std::uint32_t, kSignalGroupCount> arrived_{};      // those seen since the group was last fresh
  SignalGroups mapped_;
  VehicleSignals signals_;
};

}  // namespace hindsight

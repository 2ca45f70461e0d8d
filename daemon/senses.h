// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The robot's sense of itself and of its sensors: bus frames decoded, lines followed, sources judged, slip heard.
#pragma once

#include <array>

#include "daemon/robot_config.h"
#include "drivers/tick_input.h"
#include "drivers/vehicle_decoder.h"
#include "perception/slip_watch.h"

namespace hindsight {

/// State at the tick's time.
struct Sensed {
  VehicleSignals vehicle;                          ///< latest good values
  std::array<bool, kLineCount> active{};           ///< level of each line now
  std::array<bool, kLineCount> touched{};          ///< active now or at any time since the last tick
  std::array<bool, kLineCount> seen_released{};    ///< since the lines were opened
  std::array<SourceState, kSourceCount> sources{};
  std::array<std::uint32_t, kSourceCount> dropped{};
  bool wheels_fresh = false;
  bool yaw_rate_fresh = false;
  bool gps_lost = false;  ///< there was a fix, but none for failsafe.gps_timeout_s
  bool ir_fresh = false;
  bool slipping = false;
  bool slip_began = false;  ///< slipping now, but not in the last tick

  bool is_active(Line line) const { return active[static_cast<std::size_t>(line)]; }
  /// Pressed ever since its line was opened: a switch that sticks, or a vehicle that was switched on against something.
  bool is_stuck(Line line) const { return is_active(line) && !seen_released[static_cast<std::size_t>(line)]; }
  bool was_touched(Line line) const { return touched[static_cast<std::size_t>(line)]; }
};

class Senses {
 public:
  Senses(const Configuration& configuration, const Dbc& dbc);

  /// Takes in one tick's samples; what it returns is valid until the next call.
  const Sensed& update(const TickInput& input);
  /// Whether the wheels slip; after update(). `step`: over the ground, where this tick's frame shows one; else null.
  const Sensed& feel_slip(const TickInput& input, const GroundStep* step);
  const SlipWatch& slip() const { return slip_; }
  SignalGroups mapped() const { return decoder_.mapped(); }

 private:
  void decode(const TickInput& input);
  void follow_lines(const TickInput& input);
  void judge_sources(const TickInput& input);

  FailsafeParams params_;
  VehicleDecoder decoder_;
  SlipWatch slip_;
  Sensed sensed_;
  std::array<Time, kSourceCount> last_sample_{};
  std::array<SourceState, kSourceCount> reported_{};
};

}  // namespace hindsight

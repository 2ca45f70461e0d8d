// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <atomic>
#include <thread>

#include "daemon/heartbeats.h"
#include "daemon/reflex.h"
#include "daemon/robot_config.h"
#include "drivers/can_sender.h"
#include "drivers/unique_fd.h"
#include "drivers/drive_command_codec.h"

namespace hindsight {

/// The reflex on its own real-time thread, between board and bus. Its last word to the bus is always zero.
class LiveReflex {
 public:
  /// FatalError(kExitNoDevice) where the bus is absent or down.
  LiveReflex(const Configuration& configuration, const Dbc& dbc, ReflexBoard& board, Heartbeats& heartbeats);
  ~LiveReflex();

  /// Makes the reflex act at once instead of at its next period. Any thread.
  void wake();
  ReflexReport report() const { return report_.read(); }

 private:
  void work();
  void act();
  void send(const WheelSetpoints& set_points, Time now);

  const Configuration& configuration_;
  ReflexBoard& board_;
  Heartbeats& heartbeats_;
  DriveCommandCodec codec_;
  CanSender sender_;
  Reflex reflex_;
  UniqueFd timer_;
  UniqueFd wake_;
  Latest<ReflexReport> report_;
  int refused_in_a_row_ = 0;
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

}  // namespace hindsight

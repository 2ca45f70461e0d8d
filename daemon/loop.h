// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <atomic>
#include <mutex>
#include <optional>
#include <thread>

#include "daemon/heartbeats.h"
#include "daemon/live_reflex.h"
#include "daemon/live_sources.h"
#include "daemon/robot.h"
#include "daemon/saved_state.h"
#include "daemon/tick_consumer.h"
#include "daemon/tick_record.h"

namespace hindsight {

/// What the rest of the process may know of the loop, at any time.
struct LoopStatus {
  std::atomic<std::uint64_t> ticks{0};
  std::atomic<std::uint8_t> reason{0};     ///< StopReason
  std::atomic<std::uint8_t> behaviour{0};  ///< Behaviour
  std::atomic<bool> ready{false};          ///< every required source has given data
};

/// What of a run outlives the process.
struct Memory {
  MixtureSnapshot mixture;
  SavedState state;
};
/// Allocates; not for every tick.
Memory memory_of(const Robot& robot, std::int64_t utime_us);

/// The fixed-rate loop on absolute time: samples in, one step of the core, decision to the reflex, record to publisher
/// and recorder. A late tick is counted, and the periods that it ate are skipped, never chased.
class Loop {
 public:
  /// `recorder` and `flight_recorder` may be null.
  Loop(const Configuration& configuration, Robot& robot, LiveSources& sources, LiveReflex& reflex, ReflexBoard& board,
       TickRecordPool& records, TickConsumer& publisher, TickConsumer* recorder, TickConsumer* flight_recorder,
       Heartbeats& heartbeats);
  ~Loop();
  const LoopStatus& status() const { return status_; }
  /// What the robot knew when an operator asked for it to be saved; once.
  std::optional<Memory> take_memory_to_save();

 private:
  void work();
  void run();
  void stop_the_vehicle();
  void tick(Time due);
  void hand_out(TickRecord* record);
  bool sources_ready() const;

  const Configuration& configuration_;
  Robot& robot_;
  LiveSources& sources_;
  LiveReflex& reflex_;
  ReflexBoard& board_;
  TickRecordPool& records_;
  TickConsumer& publisher_;
  TickConsumer* recorder_;
  TickConsumer* flight_recorder_;
  Heartbeats& heartbeats_;
  LoopStatus status_;
  LoopTiming timing_;
  std::uint64_t index_ = 0;
  std::mutex saving_;  ///< held only around a save that an operator asked for
  std::optional<Memory> to_save_;
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

}  // namespace hindsight

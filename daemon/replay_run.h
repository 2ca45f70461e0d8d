// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "daemon/robot.h"
#include "daemon/virtual_reflex.h"
#include "drivers/frame_pool.h"
#include "sim_replay/sample_faults.h"
#include "sim_replay/replay_source.h"

namespace hindsight {

/// A run log, stepped through: each tick is run by a robot built from the log itself, or with another configuration.
/// The one way in which logs are replayed: by the daemon, by verify, report and bench.
class ReplayRun {
 public:
  /// `configuration`: used instead of the log's own; needed for an imported log, which has none. Throws FatalError 65
  /// or 66 as ReplaySource does.
  /// Faults change the ticks; what the recorded run's reflex and machine did then no longer counts.
  ReplayRun(const std::string& log, std::optional<Configuration> configuration, bool recover,
            std::vector<FaultSpec> faults = {});

  /// Runs the next tick. False at the log's end.
  bool step();

  const TickInput& input() const { return input_; }
  const Outbox& outbox() const { return outbox_; }
  const Decision& decision() const { return decision_; }
  const std::vector<PublishedEvent>& recorded() const { return recorded_; }
  Robot& robot() { return *robot_; }
  const RunHeader& materials() const { return materials_; }
  const Configuration& configuration() const { return configuration_; }
  const CameraModel& camera() const { return camera_; }
  const ReplaySource& source() const { return *source_; }

 private:
  FramePool pool_;
  std::unique_ptr<ReplaySource> source_;
  Configuration configuration_;
  RunHeader materials_;
  CameraModel camera_;
  std::unique_ptr<Robot> robot_;
  std::optional<VirtualReflex> reflex_;
  std::optional<SampleFaults> faults_;
  TickInput input_;
  Outbox outbox_;
  Decision decision_;
  LoopTiming timing_;
  std::vector<PublishedEvent> recorded_;
};

/// `hindsightd --replay`.
struct ReplayJob {
  std::string log;
  std::vector<std::string> configuration_files;
  double pace = 0.0;   ///< times real time; 0: as fast as it goes, without telemetry
  std::string record;  ///< run log to write; empty: none
  bool recover = false;
  std::vector<FaultSpec> faults;
};
/// Returns the exit code. Ends early, in good order, when `stop` says so.
int run_replay(const ReplayJob& job, const std::function<bool()>& stop);

}  // namespace hindsight

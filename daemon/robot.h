// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The core: one pure step. No thread, clock, file, socket or random device inside; the same inputs give the same
// messages, byte for byte. Live runs, replays and simulations differ only in where inputs come from.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "daemon/driven_track.h"
#include "daemon/failsafe.h"
#include "daemon/learner.h"
#include "daemon/mode.h"
#include "daemon/motion_sense.h"
#include "daemon/outbox.h"
#include "daemon/reflex.h"
#include "daemon/road_guide.h"
#include "daemon/robot_config.h"
#include "daemon/senses.h"
#include "daemon/sight.h"
#include "daemon/telemetry.h"
#include "drivers/dbc.h"
#include "drivers/tick_input.h"
#include "perception/camera_model.h"
#include "perception/evidence_grid.h"
#include "perception/localisation.h"
#include "planning/navigator.h"

namespace hindsight {

/// Everything that makes a robot besides samples.
struct RobotSetup {
  Configuration configuration;
  CameraModel camera;
  Dbc dbc;
  MixtureSnapshot mixture;  ///< empty: starts with K-means on the first frame
};

class Robot {
 public:
  /// FatalError(kExitConfiguration) if setup's parts do not fit each other.
  explicit Robot(const RobotSetup& setup);

  /// One tick: all samples up to input.now in; the drive command out, and into `outbox` what is to be published.
  /// Steady state allocates nothing.
  Decision step(const TickInput& input, Outbox& outbox);

  /// True once after an operator asked for the model to be saved.
  bool take_save_request() { return std::exchange(save_requested_, false); }

  const Sensed& sensed() const { return sensed_; }
  const Senses& senses() const { return senses_; }
  const Sight& sight() const { return sight_; }
  const Learner& learner() const { return learner_; }
  /// Null where it is not enabled.
  const MotionSense* motion() const { return motion_ ? &*motion_ : nullptr; }
  const DrivenTrack& driven() const { return driven_; }
  const EvidenceGrid& grid() const { return grid_; }
  const Localisation& localisation() const { return localisation_; }
  const NavigatorOutput& plan() const { return plan_; }
  const std::optional<Point2>& goal_W() const { return goal_W_; }

 private:
  bool see(const TickInput& input);
  void localise(const TickInput& input);
  void obey(const TickInput& input);
  bool permits(double mode) const;
  void learn(const TickInput& input, bool new_frame);
  void update_map(bool new_frame);
  StopReason judge(const TickInput& input);
  StopReason reflex_reason(const TickInput& input) const;
  std::optional<Point2> goal_to_reach();
  void plan(const TickInput& input, bool motion_permitted);
  void publish(const TickInput& input, bool new_frame, const Decision& decision, Outbox& outbox);
  TrainingInput training_input(bool new_frame) const;

  Configuration configuration_;
  Senses senses_;
  Localisation localisation_;
  DrivenTrack driven_;
  Sight sight_;
  Learner learner_;
  std::optional<MotionSense> motion_;
  EvidenceGrid grid_;
  std::vector<CellCost> window_costs_;
  RoadGuide road_guide_;
  Navigator navigator_;
  Failsafe failsafe_;
  Telemetry telemetry_;

  Sensed sensed_;
  NavigatorOutput plan_;
  Mode mode_;
  std::optional<Point2> goal_W_;
  bool window_moved_ = true;
  bool save_requested_ = false;
  std::uint32_t last_overruns_ = 0;
  Time last_now_{};
  StopReason last_reason_ = StopReason::not_armed;
};

}  // namespace hindsight

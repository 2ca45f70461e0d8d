// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>
#include <optional>

#include "daemon/learner.h"
#include "daemon/mode.h"
#include "daemon/motion_sense.h"
#include "daemon/outbox.h"
#include "daemon/reflex.h"
#include "daemon/robot_config.h"
#include "daemon/senses.h"
#include "daemon/sight.h"
#include "daemon/timing_histogram.h"
#include "drivers/tick_input.h"
#include "perception/camera_model.h"
#include "perception/evidence_grid.h"
#include "perception/localisation.h"
#include "planning/navigator.h"

namespace hindsight {

/// Everything about one tick that may be published.
struct TickReport {
  const TickInput& input;
  bool new_frame;
  const Decision& decision;
  Mode mode;
  bool armed;
  const Sensed& sensed;
  const PoseEstimate& pose;
  const SlipWatch& slip;
  const Sight& sight;
  const Learner& learner;
  const MotionSense* motion;  ///< null: not enabled
  const EvidenceGrid& grid;
  const NavigatorOutput& plan;
  const std::optional<Point2>& goal_W;
};

/// Turns a tick into messages (daemon/messages/*.lcm). The messages are kept and filled again, so that publishing
/// allocates nothing once they have reached their size.
class Telemetry {
 public:
  explicit Telemetry(const Configuration& configuration);
  ~Telemetry();
  void publish(const TickReport& tick, Outbox& outbox);

 private:
  struct Messages;

  void publish_state(const TickReport& tick, Outbox& outbox);
  void publish_pose(const TickReport& tick, Outbox& outbox);
  void publish_perception(const TickReport& tick, Outbox& outbox);
  void publish_training(const TickReport& tick, const Lesson& lesson, Outbox& outbox);
  void publish_mixture(const TickReport& tick, Outbox& outbox);
  void publish_grid(const TickReport& tick, Outbox& outbox);
  void publish_plan(const TickReport& tick, Outbox& outbox);
  void publish_road(const TickReport& tick, Outbox& outbox);
  void publish_slip(const TickReport& tick, Outbox& outbox);
  void publish_tracks(const TickReport& tick, Outbox& outbox);
  void publish_activity(const TickReport& tick, Outbox& outbox);
  void publish_timing(const TickReport& tick, Outbox& outbox);
  void publish_histogram(const TickReport& tick, Outbox& outbox);

  TelemetryParams params_;
  double look_ahead_m_;
  std::unique_ptr<Messages> messages_;
  std::uint64_t mixture_version_ = 0;
  std::uint64_t activity_total_ = 0;
  TimingHistogram wake_latency_;
  TimingHistogram step_duration_;
};

}  // namespace hindsight

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/robot.h"

#include <limits>

namespace hindsight {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Mode mode_of(const std::string& name) {
  if (name == "road") return Mode::road;
  return name == "drive" ? Mode::drive : Mode::watch;
}

}  // namespace

Robot::Robot(const RobotSetup& setup)
    : configuration_(setup.configuration),
      senses_(configuration_, setup.dbc),
      localisation_(configuration_.localisation, configuration_.vehicle),
      sight_(configuration_, setup.camera),
      learner_(configuration_, setup.camera, setup.mixture),
      grid_(configuration_.evidence_grid),
      window_costs_(static_cast<std::size_t>(configuration_.evidence_grid.size_cells) *
                    static_cast<std::size_t>(configuration_.evidence_grid.size_cells)),
      road_guide_(configuration_.road.look_ahead_m),
      navigator_(configuration_.planning, configuration_.vehicle, configuration_.evidence_grid.size_cells,
                 configuration_.evidence_grid.resolution_m),
      failsafe_(configuration_.failsafe),
      telemetry_(configuration_),
      mode_(mode_of(configuration_.robot.mode)) {
  if (configuration_.motion.enabled) motion_.emplace(configuration_, setup.camera);
}

Decision Robot::step(const TickInput& input, Outbox& outbox) {
  senses_.update(input);
  const bool new_frame = see(input);
  sensed_ = senses_.feel_slip(input, new_frame ? sight_.ground_step() : nullptr);
  localise(input);
  obey(input);
  learn(input, new_frame);
  update_map(new_frame);
  const StopReason reason = judge(input);
  plan(input, reason == StopReason::none);
  const Decision decision{plan_.command, input.now, reason};
  publish(input, new_frame, decision, outbox);
  last_now_ = input.now;
  last_reason_ = reason;
  return decision;
}

bool Robot::see(const TickInput& input) { return input.frame && sight_.see(*input.frame); }

void Robot::localise(const TickInput& input) {
  const VehicleSignals& vehicle = sensed_.vehicle;
  localisation_.predict({.now = input.now,
                         .left_mps = vehicle.left_mps,
                         .right_mps = vehicle.right_mps,
                         .wheels_valid = sensed_.wheels_fresh,
                         .slipping = sensed_.slipping,
                         .yaw_rate_radps = vehicle.yaw_rate_radps,
                         .gyro_valid = sensed_.yaw_rate_fresh});
  for (const GpsFix& fix : input.fixes) localisation_.correct(fix);
  driven_.add(localisation_.estimate().X_WB);
}

void Robot::obey(const TickInput& input) {
  for (const OperatorCommand& command : input.commands) {
    switch (command.kind) {
      case CommandKind::go_to_local:
        goal_W_ = Point2{command.a, command.b};
        break;
      case CommandKind::go_to_global:
        goal_W_ = localisation_.local_of(command.a, command.b);
        break;
      case CommandKind::set_mode:
        if (permits(command.a)) mode_ = static_cast<Mode>(static_cast<int>(command.a));
        break;
      case CommandKind::save_model:
        save_requested_ = true;
        break;
      case CommandKind::stop:
        goal_W_.reset();
        break;
      case CommandKind::arm:
      case CommandKind::disarm:
      case CommandKind::release_estop:
        break;  // the fail-safe's
    }
  }
}

/// A mode's number; the road can be followed only where it is looked for.
bool Robot::permits(double mode) const {
  return mode == 0.0 || mode == 1.0 || (mode == 2.0 && sight_.road() != nullptr);
}

void Robot::learn(const TickInput& input, bool new_frame) {
  if (new_frame && motion_) motion_->see(sight_.vectors(), localisation_.estimate().X_WB);
  if (new_frame) learner_.start(*input.frame);
  learner_.learn(training_input(new_frame), sight_);
  if (new_frame) sight_.classify(*input.frame, learner_.mixture(), learner_.texture());
}

TrainingInput Robot::training_input(bool new_frame) const {
  return {.X_WB = localisation_.estimate().X_WB,
          .new_frame = new_frame,
          .bumper_left = sensed_.was_touched(Line::bumper_left),
          .bumper_right = sensed_.was_touched(Line::bumper_right),
          .ir_left_m = sensed_.ir_fresh ? sensed_.vehicle.ir_left_m : kNan,
          .ir_right_m = sensed_.ir_fresh ? sensed_.vehicle.ir_right_m : kNan,
          .slip = sensed_.slipping};
}

void Robot::update_map(bool new_frame) {
  const Pose2& X_WB = localisation_.estimate().X_WB;
  window_moved_ = grid_.recentre(X_WB) || last_now_ == Time{};
  if (new_frame) {
    grid_.vote(sight_.votes(), X_WB);
    grid_.settle();
  }
  for (const Lesson& lesson : learner_.lessons()) mark_event(lesson.event, configuration_.training, grid_);
  if (window_moved_) grid_.copy_costs(window_costs_);
}

/// Why the reflex stopped the vehicle though this core permits motion. It repeats the core's own reasons, so only a report
/// made after it had the last tick's decision counts.
StopReason Robot::reflex_reason(const TickInput& input) const {
  const bool knew = input.reflex.stamp > last_now_ + input.timing.step_duration;
  return knew && last_reason_ == StopReason::none ? static_cast<StopReason>(input.reflex.stop_reason) : StopReason::none;
}

StopReason Robot::judge(const TickInput& input) {
  FailsafeInput judged;
  judged.sources = sensed_.sources;
  judged.wheels_fresh = sensed_.wheels_fresh;
  judged.estop_active = sensed_.was_touched(Line::estop);
  judged.gps_lost = sensed_.gps_lost;
  judged.bumper_left_stuck = sensed_.is_stuck(Line::bumper_left);
  judged.bumper_right_stuck = sensed_.is_stuck(Line::bumper_right);
  judged.reflex_reason = reflex_reason(input);
  judged.overrun = input.timing.overruns > std::exchange(last_overruns_, input.timing.overruns);
  judged.commands = input.commands;
  const StopReason reason = failsafe_.step(judged);
  return reason == StopReason::none && mode_ == Mode::watch ? StopReason::watching : reason;
}

std::optional<Point2> Robot::goal_to_reach() {
  if (mode_ != Mode::road) return goal_W_;
  return road_guide_.goal_W(localisation_.estimate().X_WB, sight_.road_on_ground(), goal_W_, plan_.behaviour);
}

void Robot::plan(const TickInput& input, bool motion_permitted) {
  const PoseEstimate& pose = localisation_.estimate();
  const VehicleSignals& vehicle = sensed_.vehicle;
  const double ir_range_m = configuration_.training.ir_threshold_m;
  plan_ = navigator_.step({.now = input.now,
                           .X_WB = pose.X_WB,
                           .v_mps = pose.v_mps,
                           .yaw_rate_radps = pose.yaw_rate_radps,
                           .window = &grid_.window(),
                           .window_moved = window_moved_,
                           .window_costs = window_costs_,
                           .changes = grid_.changes(),
                           .goal_W = goal_to_reach(),
                           .bumper_left = sensed_.was_touched(Line::bumper_left),
                           .bumper_right = sensed_.was_touched(Line::bumper_right),
                           .slip = sensed_.slipping,
                           .ir_left = sensed_.ir_fresh && vehicle.ir_left_m < ir_range_m,
                           .ir_right = sensed_.ir_fresh && vehicle.ir_right_m < ir_range_m,
                           .motion_permitted = motion_permitted,
                           .dt_s = last_now_ == Time{} ? 0.0 : to_seconds(input.now - last_now_)});
  grid_.clear_changes();
}

void Robot::publish(const TickInput& input, bool new_frame, const Decision& decision, Outbox& outbox) {
  telemetry_.publish({.input = input,
                      .new_frame = new_frame,
                      .decision = decision,
                      .mode = mode_,
                      .armed = failsafe_.armed(),
                      .sensed = sensed_,
                      .pose = localisation_.estimate(),
                      .slip = senses_.slip(),
                      .sight = sight_,
                      .learner = learner_,
                      .motion = motion(),
                      .grid = grid_,
                      .plan = plan_,
                      .goal_W = goal_W_},
                     outbox);
}

}  // namespace hindsight

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/sim_run.h"

#include <cmath>

#include "daemon/run_setup.h"
#include "tools/builtin_config.h"

namespace hindsight::tools {
namespace {

/// The first frames settle before the robot is told to go.
constexpr std::uint64_t kOrdersAtTick = 5;
/// A road has been followed to its end that near to the world's goal.
constexpr double kRoadEnd_m = 4.0;

}  // namespace

Point2 in_robots_world(const World& world, WorldPoint p) {
  const double dx = p.x_m - world.start.x_m, dy = p.y_m - world.start.y_m;
  const double c = std::cos(world.start_heading_rad), s = std::sin(world.start_heading_rad);
  return {c * dx + s * dy, -s * dx + c * dy};
}

RunHeader sim_materials(const Configuration& configuration, const std::vector<std::uint8_t>& mixture) {
  RunHeader materials;
  materials.utime_us = SimFeed::kStartUtime_us;
  materials.build_id = build_id();
  materials.configuration = to_text(configuration);
  materials.dbc = builtin_dbc();
  materials.calibration = builtin_calibration();
  materials.mixture = mixture;
  return materials;
}

SimRun::SimRun(const SimSetup& setup)
    : materials_(sim_materials(setup.configuration, setup.mixture)),
      setup_(make_setup(setup.configuration, materials_, "simulation")),
      feed_(setup_, setup.world, setup.seed, false),
      reflex_(setup.configuration),
      robot_(setup_),
      injector_(setup_.dbc, setup.configuration.can_roles),
      disturb_(setup.disturb) {}

void SimRun::step(SimFault fault, const Watch& watch) {
  ReflexReport reflex;
  feed_.advance(input_, [&](TickInput& moment) {
    reflex_.run_up_to(moment);
    reflex = moment.reflex;
    std::optional<WheelCommand> command;
    if (commands(fault)) command = WheelCommand{reflex.left_mps, reflex.right_mps};
    if (watch) watch(moment.now, feed_.vehicle(), command);
    return command;
  });
  input_.reflex = reflex;
  injector_.inject(fault, input_);
  if (input_.index == kOrdersAtTick) give_orders();
  if (disturb_) disturb_(input_);
  outbox_.clear();
  if (!decides(fault)) return;
  decision_ = robot_.step(input_, outbox_);
  reflex_.decide(decision_);
  for (const Lesson& lesson : robot_.learner().lessons()) lessons_ += lesson.report.pixels > 0 ? 1 : 0;
}

void SimRun::give_orders() {
  const Point2 goal_W = in_robots_world(feed_.world(), feed_.world().goal);
  input_.commands.push_back({input_.now, CommandKind::go_to_local, goal_W.x_m, goal_W.y_m, 1});
  input_.commands.push_back({input_.now, CommandKind::arm, 0.0, 0.0, 2});
}

void SimRun::record(RunLogWriter& log) const {
  log.write_tick(input_);
  for (const Outbox::Message& message : outbox_.messages()) {
    log.write_published(message.channel, message.utime_us, message.bytes);
  }
  log.flush();
}

SimSummary SimRun::summary() const {
  const SimVehicle& vehicle = feed_.vehicle();
  const World& world = feed_.world();
  const BodyPose& pose = vehicle.pose();
  const Pose2& believed = robot_.localisation().estimate().X_WB;
  const Point2 true_W = in_robots_world(world, {pose.x_m, pose.y_m});
  SimSummary summary;
  summary.ticks = static_cast<int>(input_.index) + 1;
  summary.seconds = to_seconds(input_.now - SimFeed::kStart);
  summary.to_goal_m = std::hypot(world.goal.x_m - pose.x_m, world.goal.y_m - pose.y_m);
  summary.drift_m = std::hypot(believed.x_m - true_W.x_m, believed.y_m - true_W.y_m);
  summary.distance_m = vehicle.distance_m();
  summary.touches = vehicle.touches();
  summary.ir_touches = vehicle.ir_touches();
  summary.lessons = lessons_;
  summary.behaviour = robot_.plan().behaviour;
  const bool follows_road = setup_.configuration.robot.mode == "road";
  summary.reached = follows_road ? summary.to_goal_m < kRoadEnd_m : robot_.plan().reached;
  return summary;
}

}  // namespace hindsight::tools

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/senses.h"

namespace hindsight {
namespace {

/// Messages that are not critical one by one may be this old.
constexpr Time kGroupTimeout = from_seconds(0.5);
constexpr Time kGpsTimeout = from_seconds(2.0);
constexpr Time kOperatorTimeout = from_seconds(60.0);

constexpr std::size_t index_of(Source source) { return static_cast<std::size_t>(source); }
constexpr std::size_t index_of(Line line) { return static_cast<std::size_t>(line); }

bool is_fresh(Time stamp, Time now, Time timeout) { return stamp != Time{} && now - stamp <= timeout; }

}  // namespace

Senses::Senses(const Configuration& configuration, const Dbc& dbc)
    : params_(configuration.failsafe),
      decoder_(dbc, configuration.can_roles),
      slip_(configuration.slip, configuration.robot.current_rate_hz, configuration.ground_slip,
            configuration.vehicle.track_width_m) {}

void Senses::decode(const TickInput& input) {
  for (const CanFrame& frame : input.can) {
    const SignalGroups groups = decoder_.decode(frame);
    const VehicleSignals& vehicle = decoder_.signals();
    if (groups.has(SignalGroup::currents)) slip_.add_currents(vehicle.currents_stamp, vehicle.left_a, vehicle.right_a);
    if (groups.has(SignalGroup::wheels)) slip_.add_speeds(vehicle.wheels_stamp, vehicle.left_mps, vehicle.right_mps);
    if (!groups.empty()) last_sample_[index_of(Source::can)] = frame.stamp;
  }
  sensed_.vehicle = decoder_.signals();
  const VehicleSignals& vehicle = sensed_.vehicle;
  sensed_.wheels_fresh = is_fresh(vehicle.wheels_stamp, input.now, from_seconds(params_.wheels_timeout_s));
  sensed_.yaw_rate_fresh = is_fresh(vehicle.imu_stamp, input.now, kGroupTimeout);
  sensed_.ir_fresh = is_fresh(vehicle.ir_stamp, input.now, kGroupTimeout);
}

const Sensed& Senses::feel_slip(const TickInput& input, const GroundStep* step) {
  if (step != nullptr) slip_.add_step(*step);
  const VehicleSignals& vehicle = sensed_.vehicle;
  // Where a person drives, nothing is known of what the wheels were told: take what they do.
  const bool ours = input.reflex.stop_reason == 0;
  const bool slipped = sensed_.slipping;
  sensed_.slipping = slip_.update(input.now, {WheelMotion{ours ? input.reflex.left_mps : vehicle.left_mps, vehicle.left_mps},
                                              WheelMotion{ours ? input.reflex.right_mps : vehicle.right_mps, vehicle.right_mps}});
  sensed_.slip_began = sensed_.slipping && !slipped;
  return sensed_;
}

void Senses::follow_lines(const TickInput& input) {
  for (const SourceReport& report : input.reports) {
    if (report.source == Source::gpio && report.state == SourceState::failed) sensed_.seen_released = {};
  }
  sensed_.touched = sensed_.active;
  for (const LineEdge& edge : input.edges) {
    sensed_.active[index_of(edge.line)] = edge.active;
    sensed_.seen_released[index_of(edge.line)] |= !edge.active;
    sensed_.touched[index_of(edge.line)] = sensed_.touched[index_of(edge.line)] || edge.active;
    last_sample_[index_of(Source::gpio)] = edge.stamp;
  }
}

void Senses::judge_sources(const TickInput& input) {
  if (input.frame) last_sample_[index_of(Source::camera)] = input.frame->stamp;
  if (!input.fixes.empty()) last_sample_[index_of(Source::gps)] = input.fixes.back().stamp;
  if (!input.commands.empty()) last_sample_[index_of(Source::operator_link)] = input.commands.back().stamp;
  for (const SourceReport& report : input.reports) {
    reported_[index_of(report.source)] = report.state;
    sensed_.dropped[index_of(report.source)] = report.dropped;
  }
  // Lines speak only when they change, so for them no news is good news; only a report can say otherwise.
  const std::array<Time, kSourceCount> timeouts = {from_seconds(params_.camera_timeout_s), kGroupTimeout, Time::max(),
                                                   kGpsTimeout, kOperatorTimeout};
  for (std::size_t i = 0; i < kSourceCount; ++i) {
    SourceState& state = sensed_.sources[i];
    if (reported_[i] == SourceState::failed || reported_[i] == SourceState::absent) {
      state = reported_[i];
    } else if (last_sample_[i] == Time{}) {
      state = SourceState::never_seen;
    } else {
      state = is_fresh(last_sample_[i], input.now, timeouts[i]) ? SourceState::fresh : SourceState::stale;
    }
  }
  const Time last_fix = last_sample_[index_of(Source::gps)];
  sensed_.gps_lost = last_fix != Time{} && !is_fresh(last_fix, input.now, from_seconds(params_.gps_timeout_s));
  if (sensed_.vehicle.bus.bus_off) sensed_.sources[index_of(Source::can)] = SourceState::failed;
}

const Sensed& Senses::update(const TickInput& input) {
  decode(input);
  follow_lines(input);
  judge_sources(input);
  return sensed_;
}

}  // namespace hindsight

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/vehicle/sim_vehicle.h"

#include <algorithm>
#include <cmath>

#include "sim_replay/vehicle/ir_sensor.h"

namespace hindsight {
namespace {

constexpr double kPeriod_s = to_seconds(SimVehicle::kPeriod);
/// Steps between reports, as lagr.dbc has them.
constexpr std::uint64_t kWheelsEvery = 2;
constexpr std::uint64_t kIrEvery = 5;
constexpr std::uint64_t kBatteryEvery = 100;
constexpr std::uint64_t kGpsEvery = 100;

constexpr double kLookEvery_m = 1.0;
constexpr double kLookAround_m = 4.5;
/// A switch closes when the bumper is pressed in so far, and opens when it has come back so far.
constexpr double kBumperCloses_m = 0.010;
constexpr double kBumperOpens_m = 0.005;
/// What meets the bumper so near to its middle closes both switches.
constexpr double kBumperMiddle_m = 0.08;
constexpr double kSlipRatio = 0.3;
constexpr double kDriven_mps = 0.1;
constexpr double kIrSide_m = 0.25;
constexpr double kGyroBiasSigma_radps = 0.002;
constexpr double kGyroNoise_radps = 0.004;
constexpr double kFull_v = 26.0;
constexpr double kInnerResistance_vpa = 0.02;
constexpr double kDischarge_vps = 2e-4;

/// Purposes of random numbers: each sensor has a stream of its own.
enum Stream : std::uint64_t {
  left_encoder = 1,
  right_encoder,
  left_motor,
  right_motor,
  gps_stream,
  noise_stream
};

PlanarPose start_of(const World& world) {
  return {world.start.x_m, world.start.y_m, world.start_heading_rad};
}

}  // namespace

SimVehicle::SimVehicle(const VehicleParams& params, const World& world, const Dbc& dbc,
                       const CanRolesParams& roles, double ir_touch_m, std::uint64_t seed)
    : params_(params),
      world_(world),
      codec_(dbc, roles),
      obstacles_(obstacles_of(world)),
      chassis_(params, start_of(world)),
      suspension_(world, params.track_width_m, start_of(world)),
      encoders_{WheelEncoder(Random(seed, left_encoder)), WheelEncoder(Random(seed, right_encoder))},
      currents_{MotorCurrent(Random(seed, left_motor)), MotorCurrent(Random(seed, right_motor))},
      gps_(Random(seed, gps_stream)),
      touches_(ir_touch_m),
      noise_(seed, noise_stream),
      gyro_bias_radps_(kGyroBiasSigma_radps * noise_.normal()),
      battery_v_(kFull_v),
      X_WB_(suspension_.pose(start_of(world))) {
  look_around();
}

void SimVehicle::report_lines(Time now, std::vector<LineEdge>& edges) const {
  for (const Line line : {Line::bumper_left, Line::bumper_right, Line::estop})
    edges.push_back({now, line, false});
}

void SimVehicle::step(Time now, const std::optional<WheelCommand>& command, TickInput& samples) {
  obey(now, command);
  const PlanarPose& X_WB = chassis_.pose();
  if (std::hypot(X_WB.x_m - looked_around_at_.x_m, X_WB.y_m - looked_around_at_.y_m) > kLookEvery_m)
    look_around();
  chassis_.step(told_.left_mps, told_.right_mps, world_, nearby_, kPeriod_s);
  suspension_.step(world_, X_WB, chassis_.acceleration_mps2(), kPeriod_s);
  X_WB_ = suspension_.pose(X_WB);
  feel_slip();
  feel_bumper(now, samples.edges);
  ++steps_;
  report_imu(now, samples.can);
  if (steps_ % kWheelsEvery == 0) report_wheels(now, samples.can);
  if (steps_ % kIrEvery == 0) report_ir(now, samples.can);
  if (steps_ % kBatteryEvery == 0) report_battery(now, samples.can);
  if (steps_ % kGpsEvery == 0) report_position(now, samples.fixes);
}

bool SimVehicle::left_world() const {
  const WorldPoint middle{0.5 * (world_.start.x_m + world_.goal.x_m),
                          0.5 * (world_.start.y_m + world_.goal.y_m)};
  return std::max(std::abs(X_WB_.x_m - middle.x_m), std::abs(X_WB_.y_m - middle.y_m)) > world_.half_size_m;
}

void SimVehicle::obey(Time now, const std::optional<WheelCommand>& command) {
  const double most = params_.max_speed_mps;
  if (command) {
    told_ = {std::clamp(command->left_mps, -most, most), std::clamp(command->right_mps, -most, most)};
    told_at_ = now;
  } else if (!told_at_ || now - *told_at_ >= kCommandTimeout) {
    told_ = {};
  }
}

void SimVehicle::look_around() {
  looked_around_at_ = {chassis_.pose().x_m, chassis_.pose().y_m};
  nearby_.clear();
  for (const Obstacle& obstacle : obstacles_) {
    if (hindsight::distance_m(obstacle, looked_around_at_) < kLookAround_m) nearby_.push_back(obstacle);
  }
}

void SimVehicle::feel_bumper(Time now, std::vector<LineEdge>& edges) {
  std::array<double, 2> pressed_m{};
  for (const Obstacle& obstacle : nearby_) {
    if (obstacle.drivable) continue;
    const BodyContact contact = body_contact(params_, chassis_.pose(), obstacle);
    const double by_m = bumper_pressed_m(params_, contact);
    if (contact.at.y_m > -kBumperMiddle_m) pressed_m[0] = std::max(pressed_m[0], by_m);
    if (contact.at.y_m < kBumperMiddle_m) pressed_m[1] = std::max(pressed_m[1], by_m);
  }
  for (std::size_t i = 0; i < bumper_.size(); ++i) {
    const bool pressed = pressed_m[i] > (bumper_[i] ? kBumperOpens_m : kBumperCloses_m);
    if (pressed != bumper_[i])
      edges.push_back({now, i == 0 ? Line::bumper_left : Line::bumper_right, pressed});
    bumper_[i] = pressed;
  }
  touches_.see(bumper_);
}

void SimVehicle::feel_slip() {
  const std::array wheels{&chassis_.left(), &chassis_.right()};
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    slipping_[i] = std::abs(wheels[i]->speed_mps()) > kDriven_mps && wheels[i]->slip_ratio() > kSlipRatio;
    currents_[i].step(*wheels[i], slipping_[i], kPeriod_s);
  }
}

void SimVehicle::report_wheels(Time now, std::vector<CanFrame>& frames) {
  encoders_[0].report(chassis_.left().way_m(), kWheelsEvery * kPeriod_s);
  encoders_[1].report(chassis_.right().way_m(), kWheelsEvery * kPeriod_s);
  signals_.left_mps = encoders_[0].speed_mps();
  signals_.right_mps = encoders_[1].speed_mps();
  signals_.left_ticks = encoders_[0].ticks();
  signals_.right_ticks = encoders_[1].ticks();
  signals_.left_a = currents_[0].current_a();
  signals_.right_a = currents_[1].current_a();
  codec_.encode(SignalGroup::wheels, signals_, now, frames);
  codec_.encode(SignalGroup::currents, signals_, now, frames);
}

void SimVehicle::report_ir(Time now, std::vector<CanFrame>& frames) {
  const auto reading_m = [this](double side_m) {
    const IrMount mount{.x_m = params_.front_m, .y_m = side_m};
    return ir_reading_m(mount, ir_range_m(mount, chassis_.pose(), nearby_), noise_);
  };
  signals_.ir_left_m = reading_m(kIrSide_m);
  signals_.ir_right_m = reading_m(-kIrSide_m);
  touches_.see_ir(signals_.ir_left_m, signals_.ir_right_m);
  codec_.encode(SignalGroup::ir_ranges, signals_, now, frames);
}

void SimVehicle::report_imu(Time now, std::vector<CanFrame>& frames) {
  signals_.yaw_rate_radps = chassis_.yaw_rate_radps() + gyro_bias_radps_ + kGyroNoise_radps * noise_.normal();
  codec_.encode(SignalGroup::imu, signals_, now, frames);
}

void SimVehicle::report_battery(Time now, std::vector<CanFrame>& frames) {
  battery_v_ -= kDischarge_vps * kBatteryEvery * kPeriod_s;
  signals_.battery_v =
      battery_v_ - kInnerResistance_vpa * (currents_[0].current_a() + currents_[1].current_a());
  codec_.encode(SignalGroup::battery, signals_, now, frames);
}

void SimVehicle::report_position(Time now, std::vector<GpsFix>& fixes) {
  const std::optional<GpsFix> fix = gps_.fix(now, {X_WB_.x_m, X_WB_.y_m}, X_WB_.z_m, leaves_overhead());
  if (fix) fixes.push_back(*fix);
}

/// Share of the sky that crowns around hide: all of it under the middle of one.
double SimVehicle::leaves_overhead() const {
  double open = 1.0;
  for (const Tree& tree : world_.trees) {
    const double aside_m = std::hypot(tree.at.x_m - X_WB_.x_m, tree.at.y_m - X_WB_.y_m);
    open *= 1.0 - 0.8 * std::clamp(1.5 - aside_m / tree.crown_radius_m, 0.0, 1.0);
  }
  return 1.0 - open;
}

}  // namespace hindsight

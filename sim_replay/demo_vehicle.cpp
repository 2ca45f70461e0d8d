// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/demo_vehicle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hindsight {
namespace {

/// What the base's own controllers manage; more than the daemon asks for.
constexpr double kWheelAcceleration_mps2 = 3.0;
constexpr int kStepsPerReport = 5;  // 20 Hz
constexpr double kTicksPerMetre = 400.0;
constexpr double kTicksWrap = 4096.0;
/// So near to the bumper, a trunk presses it.
constexpr double kBumperTravel_m = 0.02;
/// A trunk so near to the vehicle's middle line presses both halves of the bumper.
constexpr double kBumperMiddle_m = 0.08;
constexpr double kMudGrip = 0.45;
constexpr double kSlipHz = 3.0;
constexpr double kIrSide_m = 0.25;
constexpr double kIrHalfAngle_rad = 0.10;
constexpr double kIrLongest_m = 1.5;
constexpr double kIrSigma_m = 0.01;
constexpr double kSpeedSigma = 0.01;  // of the speed: a wheel that stands tells no noise
constexpr double kYawRateSigma_radps = 0.004;

constexpr double kPeriod_s = to_seconds(DemoVehicle::kPeriod);

struct InBody {
  double x_m;
  double y_m;
};

InBody in_body(const DemoPose& X_WB, const DemoTree& tree) {
  const double c = std::cos(X_WB.heading_rad), s = std::sin(X_WB.heading_rad);
  const double dx = tree.x_m - X_WB.x_m, dy = tree.y_m - X_WB.y_m;
  return {c * dx + s * dy, -s * dx + c * dy};
}

/// From a point to a disc along a direction; infinite where the ray misses it.
double range_m(InBody from, double heading_rad, InBody middle, double radius_m) {
  const double ux = std::cos(heading_rad), uy = std::sin(heading_rad);
  const double dx = middle.x_m - from.x_m, dy = middle.y_m - from.y_m;
  const double along_m = dx * ux + dy * uy, aside_m = dx * uy - dy * ux;
  if (along_m <= 0.0 || std::abs(aside_m) >= radius_m) return std::numeric_limits<double>::infinity();
  return std::max(0.0, along_m - std::sqrt(radius_m * radius_m - aside_m * aside_m));
}

}  // namespace

DemoVehicle::DemoVehicle(const VehicleParams& params, const DemoWorld& world, const Dbc& dbc,
                         const CanRolesParams& roles, std::uint64_t seed)
    : params_(params), world_(world), codec_(dbc, roles), random_(seed) {}

void DemoVehicle::report_lines(Time now, std::vector<LineEdge>& edges) const {
  for (const Line line : {Line::bumper_left, Line::bumper_right, Line::estop})
    edges.push_back({now, line, false});
}

void DemoVehicle::step(Time now, double left_mps, double right_mps, TickInput& samples) {
  turn_wheel(left_, left_mps);
  turn_wheel(right_, right_mps);
  move();
  feel_bumper(now, samples.edges);
  if (++steps_ % kStepsPerReport == 0) report(now, samples.can);
}

void DemoVehicle::turn_wheel(Wheel& wheel, double wanted_mps) const {
  const double most = kWheelAcceleration_mps2 * kPeriod_s;
  const double change = std::clamp(wanted_mps - wheel.speed_mps, -most, most);
  wheel.speed_mps += change;
  wheel.acceleration_mps2 = change / kPeriod_s;
}

/// Trunks do not yield: a move that would go deeper into one does not happen, and the wheels stand.
void DemoVehicle::move() {
  in_mud_ = std::hypot(X_WB_.x_m - world_.mud.x_m, X_WB_.y_m - world_.mud.y_m) < world_.mud.radius_m;
  const double grip = in_mud_ ? kMudGrip : 1.0;
  const double way_m = grip * 0.5 * (left_.speed_mps + right_.speed_mps) * kPeriod_s;
  const double turn_rad = grip * (right_.speed_mps - left_.speed_mps) / params_.track_width_m * kPeriod_s;
  const double heading_rad = X_WB_.heading_rad + 0.5 * turn_rad;
  const DemoPose to{X_WB_.x_m + way_m * std::cos(heading_rad), X_WB_.y_m + way_m * std::sin(heading_rad),
                    X_WB_.heading_rad + turn_rad};
  const double depth_m = penetration_m(to);
  if (depth_m > 0.0 && depth_m >= penetration_m(X_WB_)) {
    left_.speed_mps = right_.speed_mps = 0.0;
    yaw_rate_radps_ = 0.0;
    return;
  }
  X_WB_ = to;
  yaw_rate_radps_ = turn_rad / kPeriod_s;
  left_.way_m += left_.speed_mps * kPeriod_s;
  right_.way_m += right_.speed_mps * kPeriod_s;
}

/// Of the trunk that is deepest in the body; not above 0 where there is none.
double DemoVehicle::penetration_m(const DemoPose& X_WB) const {
  double deepest_m = -1.0;
  for (const DemoTree& tree : world_.trees) {
    const InBody middle = in_body(X_WB, tree);
    const double dx = middle.x_m - std::clamp(middle.x_m, -params_.rear_m, params_.front_m);
    const double dy = middle.y_m - std::clamp(middle.y_m, -params_.width_m / 2, params_.width_m / 2);
    deepest_m = std::max(deepest_m, tree.radius_m - std::hypot(dx, dy));
  }
  return deepest_m;
}

void DemoVehicle::feel_bumper(Time now, std::vector<LineEdge>& edges) {
  bool left = false;
  bool right = false;
  for (const DemoTree& tree : world_.trees) {
    const InBody middle = in_body(X_WB_, tree);
    const double dx = middle.x_m - params_.front_m;
    const double dy = middle.y_m - std::clamp(middle.y_m, -params_.width_m / 2, params_.width_m / 2);
    if (dx < 0.0 || std::hypot(dx, dy) > tree.radius_m + kBumperTravel_m) continue;
    left = left || middle.y_m > -kBumperMiddle_m;
    right = right || middle.y_m < kBumperMiddle_m;
  }
  if ((left || right) && !bumper_[0] && !bumper_[1]) ++touches_;
  set_bumper(true, left, now, edges);
  set_bumper(false, right, now, edges);
}

void DemoVehicle::set_bumper(bool left, bool pressed, Time now, std::vector<LineEdge>& edges) {
  bool& before = bumper_[left ? 0 : 1];
  if (pressed != before) edges.push_back({now, left ? Line::bumper_left : Line::bumper_right, pressed});
  before = pressed;
}

void DemoVehicle::report(Time now, std::vector<CanFrame>& frames) {
  signals_.left_mps = left_.speed_mps * (1.0 + kSpeedSigma * random_.normal());
  signals_.right_mps = right_.speed_mps * (1.0 + kSpeedSigma * random_.normal());
  const auto wrapped = [](double way_m) {
    const double ticks = std::floor(way_m * kTicksPerMetre);
    return ticks - kTicksWrap * std::floor(ticks / kTicksWrap);
  };
  signals_.left_ticks = wrapped(left_.way_m);
  signals_.right_ticks = wrapped(right_.way_m);
  signals_.left_a = current_a(left_, now);
  signals_.right_a = current_a(right_, now);
  signals_.ir_left_m = ir_range_m(kIrSide_m);
  signals_.ir_right_m = ir_range_m(-kIrSide_m);
  signals_.yaw_rate_radps = yaw_rate_radps_ + kYawRateSigma_radps * random_.normal();
  for (const SignalGroup group :
       {SignalGroup::wheels, SignalGroup::currents, SignalGroup::ir_ranges, SignalGroup::imu}) {
    codec_.encode(group, signals_, now, frames);
  }
}

/// Load and acceleration; where the wheel slips, the current swings at 3 Hz (thesis 5).
double DemoVehicle::current_a(const Wheel& wheel, Time now) {
  if (std::abs(wheel.speed_mps) < 0.02) return 0.2;
  const double load_a = 4.0 + 1.5 * std::abs(wheel.speed_mps) + 0.5 * std::max(0.0, wheel.acceleration_mps2);
  const double swing = in_mud_ ? 0.9 * std::sin(2.0 * std::numbers::pi * kSlipHz * to_seconds(now)) : 0.0;
  return load_a * (1.0 + swing) + 0.4 * random_.normal();
}

/// The nearest trunk in a narrow cone, as the middle and the rims of the beam see it.
double DemoVehicle::ir_range_m(double side_m) {
  double nearest_m = kIrLongest_m;
  for (const DemoTree& tree : world_.trees) {
    const InBody middle = in_body(X_WB_, tree);
    for (const double angle : {-kIrHalfAngle_rad, 0.0, kIrHalfAngle_rad}) {
      nearest_m = std::min(nearest_m, range_m({params_.front_m, side_m}, angle, middle, tree.radius_m));
    }
  }
  if (nearest_m == kIrLongest_m) return nearest_m;
  return std::clamp(nearest_m + kIrSigma_m * random_.normal(), 0.0, kIrLongest_m);
}

}  // namespace hindsight

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <span>

#include "config/vehicle_params.h"
#include "sim_replay/vehicle/body_contact.h"
#include "sim_replay/vehicle/sim_wheel.h"
#include "sim_replay/world/world.h"

namespace hindsight {

/// How the vehicle moves over the map: two driven wheels in front, a caster behind, gravity, resistance, and
/// obstacles that stop, turn or brake it. Never slides sideways but along what it touches.
class Chassis {
 public:
  Chassis(const VehicleParams& vehicle, const PlanarPose& start) : vehicle_(vehicle), X_WB_(start) {}

  /// A period of `dt_s` with the wheels told to run at these speeds; `nearby`: obstacles that it may touch.
  void step(double left_mps, double right_mps, const World& world, std::span<const Obstacle> nearby,
            double dt_s);

  const PlanarPose& pose() const { return X_WB_; }
  double speed_mps() const { return speed_mps_; }
  double yaw_rate_radps() const { return yaw_rate_radps_; }
  double acceleration_mps2() const { return acceleration_mps2_; }
  double distance_m() const { return distance_m_; }
  const SimWheel& left() const { return left_; }
  const SimWheel& right() const { return right_; }
  /// The body itself, not only its bumper, rested against something rigid during the last step.
  bool collided() const { return collided_; }

 private:
  /// What the ground does during a period.
  struct Footing {
    double left_grip_n = 0.0;
    double right_grip_n = 0.0;
    double rolling_n = 0.0;
    double rolling_npmps = 0.0;
    double downhill_n = 0.0;    ///< backwards positive
    double tail_turn_nm = 0.0;  ///< the tail falls downhill: counter-clockwise positive
  };
  /// What obstacles do: backwards, and about the axle's middle.
  struct Push {
    double back_n = 0.0;
    double turn_nm = 0.0;
  };

  Footing footing(const World& world) const;
  bool stands(const Footing& footing, const Push& push) const;
  Push resist(std::span<const Obstacle> nearby) const;
  void accelerate(const Footing& footing, const Push& push, double dt_s);
  void go(double dt_s);
  void collide(std::span<const Obstacle> nearby);
  void stop_at(const BodyContact& contact);

  VehicleParams vehicle_;
  PlanarPose X_WB_;
  SimWheel left_;
  SimWheel right_;
  double speed_mps_ = 0.0;
  double yaw_rate_radps_ = 0.0;
  double acceleration_mps2_ = 0.0;
  double distance_m_ = 0.0;
  bool collided_ = false;
};

}  // namespace hindsight

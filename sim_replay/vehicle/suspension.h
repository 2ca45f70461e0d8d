// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

#include "sim_replay/vehicle/body_contact.h"
#include "sim_replay/world/world.h"

namespace hindsight {

/// Height, pitch and roll of the body over its three points of contact: what lies under the wheels and the
/// caster, bumps included, through tyres and springs that swing.
class Suspension {
 public:
  /// At rest at `start`.
  Suspension(const World& world, double track_width_m, const PlanarPose& start);

  void step(const World& world, const PlanarPose& X_WB, double acceleration_mps2, double dt_s);
  BodyPose pose(const PlanarPose& X_WB) const;

 private:
  /// A damped oscillator that follows a target.
  struct Spring {
    double value = 0.0;
    double rate = 0.0;
    void follow(double target, double dt_s);
  };
  struct Stance {
    double z_m = 0.0;
    double pitch_rad = 0.0;
    double roll_rad = 0.0;
  };

  double height_m(const World& world, WorldPoint p) const;
  double bump(WorldPoint p) const;
  Stance stance(const World& world, const PlanarPose& X_WB) const;

  double track_width_m_;
  std::uint64_t seed_;
  Spring z_;
  Spring pitch_;
  Spring roll_;
};

}  // namespace hindsight

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "sim_replay/world/world.h"

namespace hindsight {

/// What a kind of ground does to tyres.
struct GroundContact {
  double friction = 0.0;         ///< largest traction over load
  double rolling = 0.0;          ///< resistance over load
  double rolling_per_mps = 0.0;  ///< what is added to it for each m/s: deep mud is pushed aside
  double bumps_m = 0.0;          ///< root mean square of unevenness finer than the terrain's waves
};

/// In the order of values that terramechanics gives for pneumatic tyres (Wong 2008: Theory of Ground
/// Vehicles, chapters 2 and 4). Mud is such that wheels told to run at 1 m/s slip on level ground and yet get
/// through.
const GroundContact& contact_of(Ground ground);

}  // namespace hindsight

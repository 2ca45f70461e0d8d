// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "daemon/robot_config.h"
#include "tools/slip_score.h"

namespace hindsight::tools {

/// Renders what the camera saw of a drive between the times given, at every tick, and adds to trace.steps
/// what the daemon's own flow and odometry make of it. `seed`: of the camera's noise. FatalError where the
/// renderer cannot work here.
void look_at_ground(const Configuration& configuration, const World& world, std::uint64_t seed,
                    std::span<const SlipSpan> when, SlipTrace& trace);

/// What is wrong with a step that was measured.
struct StepError {
  bool valid = false;  ///< false: not told
  double forward_m = 0.0;
  double turn_rad = 0.0;
};

/// Of each of trace.steps, in order.
std::vector<StepError> step_errors(const SlipTrace& trace);

/// Where nobody looked: gives trace.steps the true motion with measured errors, which follow each other as
/// they did when they were measured, from one that the seed picks, again and again.
void feed_steps(std::span<const StepError> errors, std::uint64_t seed, SlipTrace& trace);

}  // namespace hindsight::tools

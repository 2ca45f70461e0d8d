// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

#include "daemon/robot_config.h"
#include "sim_replay/world/world.h"
#include "tools/slip_score.h"

namespace hindsight::tools {

/// A guided drive to and fro between start and goal, at a pace that the seed decides, and back out of mud
/// that holds the wheels. What the base says of its motors goes over the bus and through the decoder, as in a
/// run.
SlipTrace drive_for_slip(const Configuration& configuration, const World& world, std::uint64_t seed,
                         double seconds);

}  // namespace hindsight::tools

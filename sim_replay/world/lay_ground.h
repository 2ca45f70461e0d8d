// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

#include "sim_replay/world/course.h"
#include "sim_replay/world/lane.h"
#include "sim_replay/world/world.h"

namespace hindsight {

/// Terrain, trail and mud of a course.
void lay_ground(const Course& course, const Lane& lane, std::uint64_t seed, World& world);

}  // namespace hindsight

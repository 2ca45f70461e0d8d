// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Telemetry's own: its messages, and what both halves of it (telemetry.cpp, telemetry_sight.cpp) use.
#pragma once

#include <bot_core/pose_t.hpp>
#include <cstddef>
#include <hindsight/activity_map_t.hpp>
#include <hindsight/grid_t.hpp>
#include <hindsight/mixture_t.hpp>
#include <hindsight/perception_t.hpp>
#include <hindsight/plan_t.hpp>
#include <hindsight/road_t.hpp>
#include <hindsight/slip_t.hpp>
#include <hindsight/state_t.hpp>
#include <hindsight/timing_histogram_t.hpp>
#include <hindsight/timing_t.hpp>
#include <hindsight/tracks_t.hpp>
#include <hindsight/training_t.hpp>

#include "daemon/telemetry.h"

namespace hindsight {

/// Cells of the activity map that fit into a message.
constexpr std::size_t kMostActivityCells = 2000;

template <typename To, typename From>
To number(From value) {
  return static_cast<To>(value);
}

/// Kept from tick to tick, so that their vectors keep their memory.
struct Telemetry::Messages {
  state_t state{};
  bot_core::pose_t pose{};
  perception_t perception{};
  training_t training{};
  mixture_t mixture{};
  grid_t grid{};
  plan_t plan{};
  road_t road{};
  slip_t slip{};
  timing_t timing{};
  timing_histogram_t histogram{};
  tracks_t tracks{};
  activity_map_t activity{};
};

}  // namespace hindsight

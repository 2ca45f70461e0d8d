// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>

namespace hindsight::log_channel {

// The channels of a run log that are ours (messages/*.lcm). Every other channel of it holds what a tick
// published.
constexpr std::string_view kHeader = "HINDSIGHT_RUN_HEADER";
constexpr std::string_view kCamera = "HINDSIGHT_RAW_CAMERA";
constexpr std::string_view kCan = "HINDSIGHT_RAW_CAN";
constexpr std::string_view kLine = "HINDSIGHT_RAW_LINE";
constexpr std::string_view kFix = "HINDSIGHT_RAW_FIX";
constexpr std::string_view kCommand = "HINDSIGHT_RAW_COMMAND";
constexpr std::string_view kReport = "HINDSIGHT_RAW_REPORT";
constexpr std::string_view kReflex = "HINDSIGHT_RAW_REFLEX";
constexpr std::string_view kTiming = "HINDSIGHT_RAW_TIMING";
constexpr std::string_view kTick = "HINDSIGHT_TICK";
constexpr std::string_view kGap = "HINDSIGHT_GAP";

}  // namespace hindsight::log_channel

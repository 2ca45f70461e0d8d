// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// What outlives the process besides the mixture: the localisation's gyro bias, with which the next run
// begins, and the last trajectory, which tells where the vehicle went before it ended. W is another one in
// each run, so that no pose is taken over.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "perception/pose.h"

namespace hindsight {

struct SavedState {
  std::int64_t utime_us = 0;  ///< when it was saved, UNIX time
  double gyro_bias_radps = 0.0;
  std::vector<Pose2> track;  ///< in the run's W, oldest first, the last one where the vehicle was
};

/// Little-endian: "HSST", u16 version, u16 zero, i64 time, f64 bias, u32 number of poses n, then n poses (x,
/// y, heading, f64), then the CRC-32 (IEEE 802.3) of all bytes before it.
std::vector<std::uint8_t> encode_state(const SavedState& state);

struct StateDecoded {
  SavedState state;
  std::string problem;  ///< empty: whole and sound; else what is wrong, and `state` is empty
};
/// Refuses everything that encode_state cannot have written, and a bias of more than 1 rad/s.
StateDecoded decode_state(std::span<const std::uint8_t> bytes);

}  // namespace hindsight

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// An activity map as bytes, for the file in which it outlives the process. Reading and writing the file is
// done elsewhere.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "perception/activity_map.h"

namespace hindsight {

/// Little-endian: "HSAM", u16 version (2), u16 zero, f64 cell, u32 cells, f64 greatest speed, u32 number of
/// active cells n, then n cells (u32 column, u32 row, u32 number of bins b, b times u16 bin and u32 count),
/// the exposures of all cells, row by row, as runs of equal ones (u32 cells, u32 frames), then the CRC-32
/// (IEEE 802.3) of all bytes before it. Version 1, without exposures, is read: such a map has never looked
/// anywhere, so that motion is known, and its absence is not.
std::vector<std::uint8_t> encode_activity(const ActivityMap& map);

struct ActivityDecoded {
  std::optional<ActivityMap> map;  ///< absent where there is a problem: a refusal costs no map's memory
  std::string problem;             ///< empty: whole and sound; else what is wrong and at which byte
};
ActivityDecoded decode_activity(std::span<const std::uint8_t> bytes);

}  // namespace hindsight

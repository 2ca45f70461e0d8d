// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace hindsight {

/// An event of an LCM event log: sync word u32, event number i64, time [us] i64, length of the channel i32,
/// length of the data i32, all big-endian, then channel and data.
constexpr std::uint32_t kEventSync = 0xEDA1DA01U;
constexpr std::size_t kEventHeaderBytes = 28;

/// What reader and writer take at most.
constexpr std::size_t kMaxChannelLength = 999;  ///< liblcm's own bound
constexpr std::size_t kMaxEventBytes = std::size_t{64} << 20;

}  // namespace hindsight

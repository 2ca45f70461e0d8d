// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace hindsight {

/// Two neighbouring pixels' values in one word, the left one in the lower half.
inline std::int32_t pair_of(std::int32_t left, std::int32_t right) { return left | right << 16; }

/// Adds to sums[x], for x below `places`, the sum over j < pairs of row[x + 2 j] * strip[j], where two pairs
/// multiply as vectors of two. `places` is a multiple of kPlacesAtOnce; row holds places + 2 pairs words.
/// Whole numbers, so the same bits on every machine.
constexpr std::size_t kPlacesAtOnce = 64;
void add_pair_products(const std::int32_t* row, const std::int32_t* strip, std::size_t pairs,
                       std::size_t places, std::uint32_t* sums);

}  // namespace hindsight

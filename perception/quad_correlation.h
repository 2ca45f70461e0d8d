// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Correlation of bytes along a row, four at a time: what x86 has an instruction for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace hindsight {

/// Four neighbouring pixels' values (0 to 255) in one word, the leftmost in the lowest byte.
inline std::uint32_t quad_of(const std::uint8_t* pixel, std::size_t stride) {
  return pixel[0] | std::uint32_t{pixel[stride]} << 8 | std::uint32_t{pixel[2 * stride]} << 16 |
         std::uint32_t{pixel[3 * stride]} << 24;
}

/// Adds to sums[x], for x below `places`, the sum over j < quads of row[x + 4 j] * weights[j], where two
/// quads multiply as vectors of four: the row's bytes without a sign, the weights' with one. `places` is a
/// multiple of kPlacesAtOnce; row holds places + 4 quads words. Whole numbers modulo 2^32, so the same bits
/// on every machine.
constexpr std::size_t kPlacesAtOnce = 64;
using AddQuadProducts = void(const std::uint32_t* row, const std::uint32_t* weights, std::size_t quads,
                             std::size_t places, std::uint32_t* sums);

/// Those that this processor can run, fastest first.
std::span<AddQuadProducts* const> quad_product_kernels();

}  // namespace hindsight

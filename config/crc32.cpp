// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "config/crc32.h"

#include <array>
#include <cstddef>

namespace hindsight {
namespace {

using Tables = std::array<std::array<std::uint32_t, 256>, 8>;

/// kTables[k][b]: what byte b does to the remainder k bytes later. Eight tables take eight bytes a step, so
/// that a raw frame costs less than a millisecond.
constexpr Tables make_tables() {
  Tables tables{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t remainder = byte;
    for (int bit = 0; bit < 8; ++bit) remainder = (remainder >> 1) ^ (0xEDB88320U & (0U - (remainder & 1U)));
    tables[0][byte] = remainder;
  }
  for (std::size_t k = 1; k < tables.size(); ++k) {
    for (std::size_t byte = 0; byte < 256; ++byte) {
      const std::uint32_t before = tables[k - 1][byte];
      tables[k][byte] = (before >> 8) ^ tables[0][before & 0xFFU];
    }
  }
  return tables;
}

constexpr Tables kTables = make_tables();

std::uint32_t take_eight(std::uint32_t remainder, const std::uint8_t* p) {
  remainder ^=
      std::uint32_t{p[0]} | std::uint32_t{p[1]} << 8 | std::uint32_t{p[2]} << 16 | std::uint32_t{p[3]} << 24;
  return kTables[7][remainder & 0xFFU] ^ kTables[6][(remainder >> 8) & 0xFFU] ^
         kTables[5][(remainder >> 16) & 0xFFU] ^ kTables[4][remainder >> 24] ^ kTables[3][p[4]] ^
         kTables[2][p[5]] ^ kTables[1][p[6]] ^ kTables[0][p[7]];
}

}  // namespace

std::uint32_t crc32(std::span<const std::uint8_t> bytes) {
  std::uint32_t remainder = 0xFFFFFFFFU;
  std::size_t i = 0;
  for (; i + 8 <= bytes.size(); i += 8) remainder = take_eight(remainder, bytes.data() + i);
  for (; i < bytes.size(); ++i) remainder = (remainder >> 8) ^ kTables[0][(remainder ^ bytes[i]) & 0xFFU];
  return ~remainder;
}

}  // namespace hindsight

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace hindsight {

/// Numbers as LCM writes them: most significant byte first. Compilers make one load and one byte swap of the
/// loop.
template <class Number>
Number read_big_endian(const std::uint8_t* from) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < sizeof(Number); ++i) value = value << 8 | from[i];
  return static_cast<Number>(value);
}

template <class Number>
void write_big_endian(Number number, std::uint8_t* to) {
  const auto value = static_cast<std::uint64_t>(number);
  for (std::size_t i = 0; i < sizeof(Number); ++i) {
    to[i] = static_cast<std::uint8_t>(value >> (8 * (sizeof(Number) - 1 - i)));
  }
}

}  // namespace hindsight

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Numbers of saved models as bytes: little-endian, the same on every machine.
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hindsight {

inline void put(std::vector<std::uint8_t>& out, std::unsigned_integral auto value) {
  for (std::size_t i = 0; i < sizeof value; ++i) out.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}
inline void put(std::vector<std::uint8_t>& out, double value) {
  put(out, std::bit_cast<std::uint64_t>(value));
}

/// Beyond the end it takes zeros, and is no longer ok().
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  template <std::unsigned_integral Number>
  Number take() {
    Number value = 0;
    ok_ = ok_ && bytes_.size() - at_ >= sizeof value;
    if (!ok_) return value;
    for (std::size_t i = 0; i < sizeof value; ++i) {
      value = static_cast<Number>(value | static_cast<Number>(bytes_[at_ + i]) << (8 * i));
    }
    at_ += sizeof value;
    return value;
  }
  double take_double() { return std::bit_cast<double>(take<std::uint64_t>()); }
  std::size_t at() const { return at_; }
  bool ok() const { return ok_; }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
  bool ok_ = true;
};

}  // namespace hindsight

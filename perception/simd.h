// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Eight numbers at once: GCC's vectors, which it splits where the machine's are narrower. Operands go by
// reference, as passing wide vectors by value depends on the instruction set that a function is compiled for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace hindsight {

constexpr std::size_t kLanes = 8;
using Floats = float __attribute__((vector_size(4 * kLanes)));
using Ints = std::int32_t __attribute__((vector_size(4 * kLanes)));

template <typename Vector, typename Number>
inline void load(Vector& to, const Number* from) {
  std::memcpy(&to, from, sizeof to);
}

template <typename Vector, typename Number>
inline void store(Number* to, const Vector& from) {
  std::memcpy(to, &from, sizeof from);
}

/// Whether a comparison holds in any lane.
inline bool any(const Ints& truth) {
  std::uint64_t words[sizeof truth / 8];
  std::memcpy(words, &truth, sizeof truth);
  std::uint64_t together = 0;
  for (const std::uint64_t word : words) together |= word;
  return together != 0;
}

inline float least(const Floats& x) {
  const Floats halves = __builtin_shuffle(x, Ints{4, 5, 6, 7, 0, 1, 2, 3});
  const Floats a = x < halves ? x : halves;
  const Floats quarters = __builtin_shuffle(a, Ints{2, 3, 0, 1, 6, 7, 4, 5});
  const Floats b = a < quarters ? a : quarters;
  return b[0] < b[1] ? b[0] : b[1];
}

inline void absolute(Floats& x) { x = x < 0.0f ? -x : x; }

inline void smaller_of(Floats& x, const Floats& y) { x = y < x ? y : x; }

inline void larger_of(Floats& x, const Floats& y) { x = y > x ? y : x; }

}  // namespace hindsight

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/pair_correlation.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace hindsight {
namespace {

void add_plain(const std::int32_t* row, const std::int32_t* strip, std::size_t pairs, std::size_t places,
               std::uint32_t* sums) {
  for (std::size_t j = 0; j < pairs; ++j) {
    const std::int32_t left = strip[j] & 0xffff, right = strip[j] >> 16;
    for (std::size_t x = 0; x < places; ++x) {
      const std::int32_t pair = row[x + 2 * j];
      sums[x] += static_cast<std::uint32_t>((pair & 0xffff) * left + (pair >> 16) * right);
    }
  }
}

#if defined(__x86_64__)

/// A compiler cannot be told of the instruction that multiplies pairs and adds them but by its name.
__attribute__((target("avx2"))) void add_avx2(const std::int32_t* row, const std::int32_t* strip,
                                              std::size_t pairs, std::size_t places, std::uint32_t* sums) {
  constexpr std::size_t kVectors = kPlacesAtOnce / 8;
  for (std::size_t x = 0; x < places; x += kPlacesAtOnce) {
    __m256i sum[kVectors];
    for (std::size_t v = 0; v < kVectors; ++v)
      sum[v] = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(sums + x + 8 * v));
    for (std::size_t j = 0; j < pairs; ++j) {
      const __m256i weight = _mm256_set1_epi32(strip[j]);
      const std::int32_t* from = row + x + 2 * j;
      for (std::size_t v = 0; v < kVectors; ++v) {
        const __m256i pixels = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from + 8 * v));
        sum[v] = _mm256_add_epi32(sum[v], _mm256_madd_epi16(pixels, weight));
      }
    }
    for (std::size_t v = 0; v < kVectors; ++v)
      _mm256_storeu_si256(reinterpret_cast<__m256i*>(sums + x + 8 * v), sum[v]);
  }
}

/// Multiplies pairs and adds them to the sums in one instruction. Two sets of sums, so that one need not wait
/// for itself.
__attribute__((target("avx512f,avx512vnni"))) void add_vnni(const std::int32_t* row,
                                                            const std::int32_t* strip, std::size_t pairs,
                                                            std::size_t places, std::uint32_t* sums) {
  constexpr std::size_t kVectors = kPlacesAtOnce / 16;
  for (std::size_t x = 0; x < places; x += kPlacesAtOnce) {
    __m512i even[kVectors], odd[kVectors];
    for (std::size_t v = 0; v < kVectors; ++v) {
      even[v] = _mm512_loadu_si512(sums + x + 16 * v);
      odd[v] = _mm512_setzero_si512();
    }
    const std::int32_t* from = row + x;
    std::size_t j = 0;
    for (; j + 1 < pairs; j += 2, from += 4) {
      const __m512i first = _mm512_set1_epi32(strip[j]), second = _mm512_set1_epi32(strip[j + 1]);
      for (std::size_t v = 0; v < kVectors; ++v) {
        even[v] = _mm512_dpwssd_epi32(even[v], _mm512_loadu_si512(from + 16 * v), first);
        odd[v] = _mm512_dpwssd_epi32(odd[v], _mm512_loadu_si512(from + 2 + 16 * v), second);
      }
    }
    for (std::size_t v = 0; v < kVectors; ++v) {
      if (j < pairs)
        even[v] =
            _mm512_dpwssd_epi32(even[v], _mm512_loadu_si512(from + 16 * v), _mm512_set1_epi32(strip[j]));
      _mm512_storeu_si512(sums + x + 16 * v, _mm512_add_epi32(even[v], odd[v]));
    }
  }
}

#endif

}  // namespace

void add_pair_products(const std::int32_t* row, const std::int32_t* strip, std::size_t pairs,
                       std::size_t places, std::uint32_t* sums) {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512vnni")) return add_vnni(row, strip, pairs, places, sums);
  if (__builtin_cpu_supports("avx2")) return add_avx2(row, strip, pairs, places, sums);
#endif
  add_plain(row, strip, pairs, places, sums);
}

}  // namespace hindsight

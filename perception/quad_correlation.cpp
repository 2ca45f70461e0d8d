// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/quad_correlation.h"

#include <array>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace hindsight {
namespace {

void add_plain(const std::uint32_t* row, const std::uint32_t* weights, std::size_t quads, std::size_t places,
               std::uint32_t* sums) {
  for (std::size_t j = 0; j < quads; ++j) {
    for (unsigned shift = 0; shift < 32; shift += 8) {
      const auto weight = static_cast<std::int8_t>(weights[j] >> shift);
      for (std::size_t x = 0; x < places; ++x)
        sums[x] += (row[x + 4 * j] >> shift & 0xFFU) * static_cast<std::uint32_t>(weight);
    }
  }
}

#if defined(__x86_64__)

// Compilers cannot be told of these instructions but by their names.

/// Even and odd bytes apart, as pairs of 16 bits: the instruction that multiplies bytes would saturate.
__attribute__((target("avx2"))) void add_avx2(const std::uint32_t* row, const std::uint32_t* weights,
                                              std::size_t quads, std::size_t places, std::uint32_t* sums) {
  constexpr std::size_t kVectors = kPlacesAtOnce / 8;
  const __m256i low_bytes = _mm256_set1_epi16(0x00FF);
  for (std::size_t x = 0; x < places; x += kPlacesAtOnce) {
    __m256i sum[kVectors];
    for (std::size_t v = 0; v < kVectors; ++v)
      sum[v] = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(sums + x + 8 * v));
    for (std::size_t j = 0; j < quads; ++j) {
      const __m256i weight = _mm256_set1_epi32(static_cast<std::int32_t>(weights[j]));
      const __m256i even = _mm256_srai_epi16(_mm256_slli_epi16(weight, 8), 8),
                    odd = _mm256_srai_epi16(weight, 8);
      const std::uint32_t* from = row + x + 4 * j;
      for (std::size_t v = 0; v < kVectors; ++v) {
        const __m256i pixels = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from + 8 * v));
        sum[v] = _mm256_add_epi32(sum[v], _mm256_madd_epi16(_mm256_and_si256(pixels, low_bytes), even));
        sum[v] = _mm256_add_epi32(sum[v], _mm256_madd_epi16(_mm256_srli_epi16(pixels, 8), odd));
      }
    }
    for (std::size_t v = 0; v < kVectors; ++v)
      _mm256_storeu_si256(reinterpret_cast<__m256i*>(sums + x + 8 * v), sum[v]);
  }
}

/// Two sets of sums, so that one need not wait for itself.
__attribute__((target("avx512f,avx512vnni"))) void add_vnni(const std::uint32_t* row,
                                                            const std::uint32_t* weights, std::size_t quads,
                                                            std::size_t places, std::uint32_t* sums) {
  constexpr std::size_t kVectors = kPlacesAtOnce / 16;
  for (std::size_t x = 0; x < places; x += kPlacesAtOnce) {
    __m512i even[kVectors], odd[kVectors];
    for (std::size_t v = 0; v < kVectors; ++v) {
      even[v] = _mm512_loadu_si512(sums + x + 16 * v);
      odd[v] = _mm512_setzero_si512();
    }
    const auto add = [&](__m512i * to, std::size_t j) __attribute__((target("avx512f,avx512vnni"))) {
      const __m512i weight = _mm512_set1_epi32(static_cast<std::int32_t>(weights[j]));
      const std::uint32_t* from = row + x + 4 * j;
      for (std::size_t v = 0; v < kVectors; ++v)
        to[v] = _mm512_dpbusd_epi32(to[v], _mm512_loadu_si512(from + 16 * v), weight);
    };
    std::size_t j = 0;
    for (; j + 1 < quads; j += 2) add(even, j), add(odd, j + 1);
    if (j < quads) add(even, j);
    for (std::size_t v = 0; v < kVectors; ++v)
      _mm512_storeu_si512(sums + x + 16 * v, _mm512_add_epi32(even[v], odd[v]));
  }
}

#endif

struct Kernels {
  std::array<AddQuadProducts*, 3> usable{};
  std::size_t count = 0;

  Kernels() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512vnni")) usable[count++] = add_vnni;
    if (__builtin_cpu_supports("avx2")) usable[count++] = add_avx2;
#endif
    usable[count++] = add_plain;
  }
};

}  // namespace

std::span<AddQuadProducts* const> quad_product_kernels() {
  static const Kernels kernels;
  return std::span(kernels.usable).first(kernels.count);
}

}  // namespace hindsight

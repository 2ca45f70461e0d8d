// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/color_classifier.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>

#include "perception/multiversion.h"
#include "perception/simd.h"

namespace hindsight {
namespace {

constexpr int kGroups = FloatMixture::kGroups;
constexpr std::int32_t kUnknown = static_cast<std::int32_t>(TerrainClass::unknown);
/// Ask the doubles: no label, and not one of MixtureLikelihood's.
constexpr std::int32_t kAsk = 4;

/// x becomes e^x, for x <= 0, within 2e-6 relatively; 0 below -80. x = n ln 2 + r with |r| <= ln 2 / 2, and
/// the Taylor series of e^r.
inline void exp_of_negative(Floats& x) {
  const Ints counts = x >= -80.0f;
  const Floats clamped = counts ? x : Floats{} - 80.0f;
  const Ints n = __builtin_convertvector(clamped * 1.44269504f - 0.5f, Ints);
  const Floats nf = __builtin_convertvector(n, Floats);
  const Floats r = (clamped - nf * 0.693359375f) + nf * 2.12194440e-4f;  // ln 2 in two parts, the first exact
  Floats e = r * (1.0f / 720) + 1.0f / 120;
  e = e * r + 1.0f / 24;
  e = e * r + 1.0f / 6;
  e = e * r + 0.5f;
  e = e * r + 1.0f;
  e = e * r + 1.0f;
  const Ints power = (n + 127) << 23;  // the bits of 2^n
  Floats scale;
  std::memcpy(&scale, &power, sizeof scale);
  x = counts ? e * scale : Floats{};
}

/// Labels of a small cube's colours; kAsk where the floats cannot tell.
HINDSIGHT_MULTIVERSION void classify_lanes(const CubeColors& colors, const FloatMixture& terms,
                                           const ComponentSelection& selection, std::int32_t* labels) {
  using Row = FloatMixture;
  Floats score[kMostComponents];
  float log_count[kGroups];
  for (int g = 0; g < kGroups; ++g) {
    const std::size_t count = selection.group_end[g] - (g == 0 ? 0 : selection.group_end[g - 1]);
    log_count[g] = 0.6931472f * static_cast<float>(std::bit_width(count));  // at least its logarithm
  }
  const float surely_out = terms.gate2 + terms.error.d2_near_gate,
              surely_in = terms.gate2 - terms.error.d2_near_gate;
  for (std::size_t i = 0; i < kColorsInSmallCube; i += kLanes) {
    Floats cx, cy, cz;
    load(cx, &colors.channel[0][i]), load(cy, &colors.channel[1][i]), load(cz, &colors.channel[2][i]);
    Floats nearest = Floats{} + std::numeric_limits<float>::max(), best = -nearest, group_best[kGroups];
    for (std::size_t g = 0, j = 0; g < kGroups; ++g) {
      Floats largest = Floats{} + std::numeric_limits<float>::lowest();
      for (; j < selection.group_end[g]; ++j) {
        const std::size_t column = selection.column[j];
        const auto v = [&](Row::Row row) { return terms.value[row][column]; };
        const Floats x = cx - v(Row::mean0), y = cy - v(Row::mean1), z = cz - v(Row::mean2);
        const Floats p = v(Row::w00) * x, q = v(Row::w10) * x + v(Row::w11) * y;
        const Floats r = v(Row::w20) * x + v(Row::w21) * y + v(Row::w22) * z;
        const Floats d2 = p * p + q * q + r * r;  // (5.2)
        score[j] = v(Row::log_factor) - 0.5f * d2;
        nearest = d2 < nearest ? d2 : nearest;
        larger_of(largest, score[j]);
      }
      group_best[g] = largest;
      larger_of(best, largest);
    }

    // A class whose best summand beats all of another class together needs no sums.
    Ints rivals = Ints{}, winner = Ints{};
    const Floats beaten = best - terms.error.score;
    for (int g = 0; g < kGroups; ++g) {
      const Ints leads = group_best[g] == best;
      winner |= leads & g;
      rivals -= (group_best[g] + log_count[g] >= beaten) | leads;  // truth is -1
    }
    if (any((rivals != 1) & (nearest <= surely_out))) {
      Floats sum[kGroups], top = Floats{};  // (5.1), relative to the best summand
      for (std::size_t g = 0, j = 0; g < kGroups; ++g) {
        sum[g] = Floats{};
        for (; j < selection.group_end[g]; ++j) {
          Floats share = score[j] - best;
          if (!any(share >= -FloatMixture::kNegligible)) continue;
          exp_of_negative(share);
          sum[g] += share;
        }
        larger_of(top, sum[g]);
      }
      winner = rivals = Ints{};
      for (int g = 0; g < kGroups; ++g) {
        winner |= (sum[g] == top) & g;
        rivals -= sum[g] >= top * (1.0f - terms.error.likelihood_ratio);
      }
    }
    const Ints inside = ((rivals == 1) & (nearest < surely_in)) ? winner : Ints{} + kAsk;
    store(labels + i, nearest > surely_out ? Ints{} + kUnknown : inside);
  }
}

}  // namespace

ColorClassifier::ColorClassifier()
    : exact_(kMostComponents),
      cubes_(ColorSpace::rgb),
      known_(kLargeCubes, Known::nothing),
      remembered_(kLargeCubes) {}

void ColorClassifier::set(const TerrainMixture& mixture) {
  exact_.set(mixture.components(), mixture.params().gate);
  if (mixture.color_space() != color_space_) cubes_ = ColorCubes(mixture.color_space());
  color_space_ = mixture.color_space();
  mixture_.set(exact_, color_space_);
  std::ranges::fill(known_, Known::nothing);
  part_of_ = kLargeCubes;
}

std::uint8_t ColorClassifier::classify(std::uint32_t small_cube, std::uint8_t* labels) {
  const std::uint32_t large_cube = large_cube_of(small_cube);
  const Known known = look_at_large(large_cube);
  if (known <= Known::unknown) return static_cast<std::uint8_t>(known);
  take_part_for(large_cube);
  const Outlook outlook = survey(part_, cubes_.around_small(small_cube), selection_);
  if (outlook.decided) return static_cast<std::uint8_t>(outlook.label);
  classify_each(small_cube, labels);
  return kMixed;
}

ColorClassifier::Known ColorClassifier::look_at_large(std::uint32_t large_cube) {
  static_assert(kMostComponents <= 256, "columns are remembered as bytes");
  Known& known = known_[large_cube];
  if (known != Known::nothing) return known;
  const Outlook outlook = survey(mixture_, cubes_.around_large(large_cube), selection_);
  if (outlook.decided) return known = static_cast<Known>(outlook.label);
  known = selection_.count() <= Remembered::kMost ? Known::selection : Known::too_many;
  if (known == Known::too_many) return known;
  const auto as_byte = [](std::size_t v) { return static_cast<std::uint8_t>(v); };
  Remembered& memory = remembered_[large_cube];
  memory.count = as_byte(selection_.count());
  std::ranges::transform(selection_.group_end, memory.group_end, as_byte);
  std::transform(selection_.column, selection_.column + memory.count, memory.column, as_byte);
  return known;
}

void ColorClassifier::take_part_for(std::uint32_t large_cube) {
  if (large_cube == part_of_) return;
  part_of_ = large_cube;
  if (known_[large_cube] == Known::selection) {
    const Remembered& memory = remembered_[large_cube];
    std::ranges::copy(memory.group_end, selection_.group_end);
    std::copy_n(memory.column, memory.count, selection_.column);
  } else {
    survey(mixture_, cubes_.around_large(large_cube), selection_);
  }
  take_columns(mixture_, selection_, part_);
}

void ColorClassifier::classify_each(std::uint32_t small_cube, std::uint8_t* labels) {
  CubeColors colors;
  find_colors(color_space_, small_cube, colors);
  std::array<std::int32_t, kColorsInSmallCube> found;
  classify_lanes(colors, part_, selection_, found.data());
  for (std::size_t i = 0; i < kColorsInSmallCube; ++i) {
    labels[i] = static_cast<std::uint8_t>(found[i]);
    if (found[i] != kAsk) continue;
    const auto byte = [key = colors.key[i]](int shift) {
      return static_cast<std::uint8_t>(key >> shift & 255u);
    };
    labels[i] =
        static_cast<std::uint8_t>(exact_.classify(color_of(color_space_, byte(0), byte(8), byte(16))));
  }
}

}  // namespace hindsight

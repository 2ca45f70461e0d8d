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
constexpr std::int32_t kAsk = 4;  ///< ask the doubles

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

/// The lanes of numbers that have no bits in common, in one.
HINDSIGHT_ALWAYS_INLINE std::uint32_t together(const Ints& x) {
  std::uint64_t words[kLanes / 2];
  std::memcpy(words, &x, sizeof words);
  const std::uint64_t both = (words[0] | words[1]) | (words[2] | words[3]);
  return static_cast<std::uint32_t>(both | both >> 32);
}

/// An octant's labels, four bits each: bits 0 and 1 are the label, bit 2 tells that the floats cannot tell.
HINDSIGHT_MULTIVERSION std::uint32_t classify_lanes(const OctantColors& colors, const FloatMixture& terms,
                                                    const ComponentSelection& selection) {
  using Row = FloatMixture;
  Floats score[kMostComponents];
  Floats cx, cy, cz;
  load(cx, colors.channel[0].data()), load(cy, colors.channel[1].data()), load(cz, colors.channel[2].data());
  Floats nearest = Floats{} + std::numeric_limits<float>::max(), best = -nearest;
  Floats group_best[kGroups] = {best, best, best, best};
  for (std::size_t j = 0; j < selection.count; ++j) {
    const std::size_t column = selection.column[j];
    const auto v = [&](Row::Row row) { return terms.value[row][column]; };
    const Floats x = cx - v(Row::mean0), y = cy - v(Row::mean1), z = cz - v(Row::mean2);
    const Floats p = v(Row::w00) * x, q = v(Row::w10) * x + v(Row::w11) * y;
    const Floats r = v(Row::w20) * x + v(Row::w21) * y + v(Row::w22) * z;
    const Floats d2 = p * p + q * q + r * r;  // (5.2)
    score[j] = v(Row::log_factor) - 0.5f * d2;
    smaller_of(nearest, d2);
    larger_of(best, score[j]);
    larger_of(group_best[terms.group[column]], score[j]);
  }

  // A class whose best summand beats all of another class together needs no sums.
  Ints rivals = Ints{}, winner = Ints{};
  const float log_count = 0.6931472f * static_cast<float>(std::bit_width(selection.count));  // at least it
  const Floats beaten = best - (terms.error.score + log_count);
  for (int g = 0; g < kGroups; ++g) {
    winner |= (group_best[g] == best) & g;
    rivals -= group_best[g] >= beaten;  // truth is -1
  }
  const float surely_out = terms.gate2 + terms.error.d2_near_gate,
              surely_in = terms.gate2 - terms.error.d2_near_gate;
  if (any((rivals != 1) & (nearest <= surely_out))) {
    Floats sum[kGroups] = {}, top = Floats{};  // (5.1), relative to the best summand
    for (std::size_t j = 0; j < selection.count; ++j) {
      Floats share = score[j] - best;
      exp_of_negative(share);
      sum[terms.group[selection.column[j]]] += share;
    }
    for (const Floats& of_group : sum) larger_of(top, of_group);
    winner = rivals = Ints{};
    for (int g = 0; g < kGroups; ++g) {
      winner |= (sum[g] == top) & g;
      rivals -= sum[g] >= top * (1.0f - terms.error.likelihood_ratio);
    }
  }
  constexpr Ints kPlaces{0, 1, 2, 3, 4, 5, 6, 7};
  const Ints outside = nearest > surely_out;
  const Ints label = outside ? Ints{} + kUnknown : winner & kUnknown;
  const Ints sure = outside | ((rivals == 1) & (nearest < surely_in));
  return together((label | (~sure & kAsk)) << 4 * kPlaces);
}

/// Not any set of components: they were too many to be remembered.
constexpr std::uint64_t kTooMany = ~std::uint64_t{0};

/// The components that matter of those remembered.
template <typename Remembered>
void narrow(const Remembered& memory, std::uint64_t matters, ComponentSelection& selection) {
  selection.count = 0;
  const std::size_t per_bit = components_per_bit(memory.count);
  for (; matters != 0; matters &= matters - 1) {
    const std::size_t first = static_cast<std::size_t>(std::countr_zero(matters)) * per_bit;
    selection.column[selection.count++] = memory.column[first];
    if (per_bit == 2 && first + 1 < memory.count)
      selection.column[selection.count++] = memory.column[first + 1];
  }
}

}  // namespace

ColorClassifier::ColorClassifier()
    : exact_(kMostComponents), cubes_(ColorSpace::rgb), huge_(kHugeCubes), remembered_(kLargeCubes) {}

void ColorClassifier::set(const TerrainMixture& mixture) {
  exact_.set(mixture);
  if (mixture.color_space() != color_space_) cubes_ = ColorCubes(mixture.color_space());
  color_space_ = mixture.color_space();
  mixture_.set(exact_, color_space_);
  for (Huge& huge : huge_) huge.known = false;
}

const ColorClassifier::Family& ColorClassifier::judge(std::uint32_t large_cube) {
  const Huge& huge = look_at_huge(large_cube / kFamily);
  const std::size_t i = large_cube % kFamily;
  std::uint8_t state = huge.large_ones.state[i];
  if (state == kMixed && huge.large_ones.matters[i] == kTooMany) {
    const Outlook outlook = survey(mixture_, cubes_.large_ones_in(large_cube / kFamily).one(i), selection_);
    if (outlook.decided) state = static_cast<std::uint8_t>(outlook.label);
  } else if (state == kMixed) {
    narrow(huge.selection, huge.large_ones.matters[i], selection_);
  }
  if (state == kMixed) {
    survey_inside(cubes_.small_ones_in(large_cube), remembered_[large_cube], family_);
  } else {
    family_.state.fill(state);
  }
  return family_;
}

const ColorClassifier::Huge& ColorClassifier::look_at_huge(std::uint32_t huge_cube) {
  Huge& huge = huge_[huge_cube];
  if (huge.known) return huge;
  huge.known = true;
  const Outlook outlook = survey(mixture_, cubes_.around_huge(huge_cube), selection_);
  if (outlook.decided) {
    huge.large_ones.state.fill(static_cast<std::uint8_t>(outlook.label));
  } else {
    survey_inside(cubes_.large_ones_in(huge_cube), huge.selection, huge.large_ones);
  }
  return huge;
}

/// By the components of selection_, which it remembers.
void ColorClassifier::survey_inside(const ColorBoxes& boxes, Remembered& memory, Family& family) {
  if (selection_.count > Remembered::kMost) {
    family.state.fill(kMixed);
    family.matters.fill(kTooMany);
    return;
  }
  memory.count = static_cast<std::uint8_t>(selection_.count);
  std::ranges::copy_n(selection_.column, memory.count, memory.column);
  Outlooks outlooks;
  survey_family(mixture_, selection_, boxes, outlooks);
  std::ranges::copy(outlooks.matters, family.matters.begin());
  std::ranges::transform(outlooks.label, family.state.begin(), [](std::int32_t label) {
    return label < 0 ? kMixed : static_cast<std::uint8_t>(label);
  });
}

std::uint32_t ColorClassifier::classify(std::uint32_t small_cube, std::uint32_t octant,
                                        std::uint64_t matters) {
  const std::uint32_t large_cube = small_cube / kFamily;
  if (matters == kTooMany) {
    const ColorBox box = cubes_.small_ones_in(large_cube).one(small_cube % kFamily);
    const Outlook outlook = survey(mixture_, box, selection_);
    if (outlook.decided) return 0x11111111u * static_cast<std::uint32_t>(outlook.label);
  } else {
    narrow(remembered_[large_cube], matters, selection_);
  }
  OctantColors colors;
  find_colors(color_space_, small_cube, octant, colors);
  std::uint32_t labels = classify_lanes(colors, mixture_, selection_);
  constexpr std::uint32_t kAskAny = 0x11111111u * kAsk;
  for (std::uint32_t ask = labels & kAskAny; ask != 0; ask &= ask - 1) {
    const auto i = static_cast<unsigned>(std::countr_zero(ask)) / 4;
    const auto byte = [key = colors.key[i]](int shift) {
      return static_cast<std::uint8_t>(key >> shift & 255u);
    };
    const auto label = exact_.classify(color_of(color_space_, byte(0), byte(8), byte(16)));
    labels = (labels & ~(15u << 4 * i)) | static_cast<std::uint32_t>(label) << 4 * i;
  }
  return labels;
}

}  // namespace hindsight

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include <limits>

#include "perception/likelihood_bounds.h"
#include "perception/mixture_survey.h"
#include "perception/multiversion.h"

namespace hindsight {
namespace {

constexpr std::int32_t kUnknown = static_cast<std::int32_t>(TerrainClass::unknown);
static_assert(kFamily == kLanes, "the lanes are boxes");

/// In each lane the component of the best score in the middle.
struct Winner {
  Floats score = Floats{} + std::numeric_limits<float>::lowest(), slope[3] = {}, spread = {};
  Ints group = {};
};

HINDSIGHT_ALWAYS_INLINE void compete(const Lanes& lanes, int group, Winner& winner) {
  const Ints leads = lanes.score > winner.score;
  winner.score = leads ? lanes.score : winner.score;
  for (int k = 0; k < 3; ++k) winner.slope[k] = leads ? lanes.slope[k] : winner.slope[k];
  winner.spread = leads ? lanes.spread : winner.spread;
  winner.group = leads ? Ints{} + group : winner.group;
}

/// At least the logarithm of a count; anything where it is 0.
HINDSIGHT_ALWAYS_INLINE void log_of_count(const Ints& count, Floats& log) {
  const Floats number = __builtin_convertvector(count, Floats);
  Ints bits;
  std::memcpy(&bits, &number, sizeof bits);
  log = 0.6931472f * __builtin_convertvector((bits >> 23) - 126, Floats);
}

/// The components that matter in each box, and how far the winner leads those of other groups at least. Two
/// quadratics are compared by their difference, whose slope is small where both fall alike.
struct Rivals {
  Ints mask[2] = {};  ///< low and high bits of Outlooks::matters
  Ints count = {};    ///< of other groups
  Floats least_lead = Floats{} + std::numeric_limits<float>::max();
};

HINDSIGHT_ALWAYS_INLINE void look_for_rivals(const Lanes* lanes, const FloatMixture& mixture,
                                             const ComponentSelection& selection, const Winner& winner,
                                             const Reach<Floats>& reach, Rivals& rivals) {
  const std::size_t per_bit = components_per_bit(selection.count);
  for (std::size_t j = 0; j < selection.count; ++j) {
    const Lanes& o = lanes[j];
    const std::size_t bit = per_bit == 1 ? j : j / 2;
    Ints wanted;
    matters(o, reach, wanted);
    rivals.mask[bit / 32] |= wanted & static_cast<std::int32_t>(1u << bit % 32);
    const Ints rival = wanted & (winner.group != mixture.group[selection.column[j]]);
    Floats a = o.slope[0] - winner.slope[0], b = o.slope[1] - winner.slope[1],
           c = o.slope[2] - winner.slope[2];
    absolute(a), absolute(b), absolute(c);
    const Floats lead = (winner.score - o.score) - (a + b + c);
    rivals.least_lead = rival & (lead < rivals.least_lead) ? lead : rivals.least_lead;
    rivals.count -= rival;  // truth is -1
  }
}

}  // namespace

HINDSIGHT_MULTIVERSION void survey_family(const FloatMixture& mixture, const ComponentSelection& selection,
                                          const ColorBoxes& boxes, Outlooks& outlooks) {
  const float surely_out = mixture.gate2 + mixture.error.d2_near_gate;
  Floats middle[3], half[3];
  for (int k = 0; k < 3; ++k) load(middle[k], boxes.middle[k]), load(half[k], boxes.half[k]);
  Lanes lanes[Outlooks::kMostComponents];
  Extremes extremes;
  Winner winner;
  for (std::size_t j = 0; j < selection.count; ++j) {
    const std::size_t column = selection.column[j];
    Component v;
    for (int row = 0; row < FloatMixture::kRows; ++row) v[row] = Floats{} + mixture.value[row][column];
    bound(v, middle, half, surely_out, lanes[j], extremes);
    compete(lanes[j], mixture.group[column], winner);
  }
  // Inside the gate means inside that of a component that reaches into the box.
  larger_of(extremes.best_low, extremes.least_factor - 0.5f * surely_out - kBoundMargin);
  const Ints all_inside = extremes.nearest_high < mixture.gate2 - mixture.error.d2_near_gate;
  const Reach<Floats> reach{extremes.best_low - FloatMixture::kNegligible,
                            all_inside ? Floats{} - std::numeric_limits<float>::max() : Floats{} + surely_out,
                            extremes.nearest_high};
  Rivals rivals;
  look_for_rivals(lanes, mixture, selection, winner, reach, rivals);

  // The likelihood of the others together is at most the largest summand times the number of summands.
  Floats log_count;
  log_of_count(rivals.count, log_count);
  const Ints beats_all =
      rivals.least_lead > log_count + 0.5f * winner.spread + kBoundMargin + mixture.error.score;
  const Ints decided = (all_inside | (winner.group == kUnknown)) & beats_all;
  const Ints label = decided ? winner.group : Ints{} - 1;
  store(outlooks.label, extremes.nearest_low > surely_out ? Ints{} + kUnknown : label);
  for (std::size_t i = 0; i < kFamily; ++i) {
    const auto half_of = [&](int h) { return static_cast<std::uint32_t>(rivals.mask[h][i]); };
    outlooks.matters[i] = half_of(0) | static_cast<std::uint64_t>(half_of(1)) << 32;
  }
}

}  // namespace hindsight

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/mixture_survey.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "perception/likelihood_bounds.h"
#include "perception/multiversion.h"

namespace hindsight {
namespace {

constexpr std::int32_t kUnknown = static_cast<std::int32_t>(TerrainClass::unknown);

/// Of one box, the lanes are components.
struct Bounds {
  Lanes lanes[kMostComponents / kLanes];
  float nearest_low, nearest_high;
  float best;      ///< largest score in the middle
  float best_low;  ///< what the largest score is at least wherever a colour of the box is inside the gate
};

inline void bound_all(const FloatMixture& t, const ColorBox& box, float surely_out, Bounds& out) {
  Floats middle[3], half[3];
  for (int k = 0; k < 3; ++k) middle[k] = Floats{} + box.middle[k], half[k] = Floats{} + box.half[k];
  Extremes extremes;
  for (std::size_t j = 0; j < t.count; j += kLanes) {
    Component v;
    for (int row = 0; row < FloatMixture::kRows; ++row) load(v[row], &t.value[row][j]);
    bound(v, middle, half, surely_out, out.lanes[j / kLanes], extremes);
  }
  out.nearest_high = least(extremes.nearest_high);
  out.nearest_low = least(extremes.nearest_low);
  out.best = -least(-extremes.best);
  // Inside the gate means inside that of a component that reaches into the box.
  out.best_low =
      std::max(-least(-extremes.best_low), least(extremes.least_factor) - 0.5f * surely_out - kBoundMargin);
}

inline std::size_t best_in_the_middle(const Bounds& bounds) {
  std::size_t j = 0;
  while (!any(bounds.lanes[j / kLanes].score == bounds.best)) j += kLanes;
  while (bounds.lanes[j / kLanes].score[j % kLanes] != bounds.best) ++j;
  return j;
}

/// Whether one component beats all those of other groups together, whose likelihood is at most the largest
/// summand times the number of summands. Two quadratics are compared by their difference, whose slope is
/// small where both fall alike.
inline bool beats_all(const FloatMixture& mixture, const Bounds& bounds, std::size_t winner,
                      const Reach<float>& reach) {
  const Lanes& w = bounds.lanes[winner / kLanes];
  const std::size_t l = winner % kLanes;
  Floats least_lead = Floats{} + std::numeric_limits<float>::max();
  Ints rivals = Ints{};
  for (std::size_t block = 0; block < mixture.count / kLanes; ++block) {
    const Lanes& o = bounds.lanes[block];
    Ints group, rival;
    load(group, &mixture.group[block * kLanes]);
    matters(o, reach, rival);
    rival &= group != mixture.group[winner];
    Floats a = o.slope[0] - w.slope[0][l], b = o.slope[1] - w.slope[1][l], c = o.slope[2] - w.slope[2][l];
    absolute(a), absolute(b), absolute(c);
    const Floats lead = (w.score[l] - o.score) - (a + b + c);
    least_lead = rival & (lead < least_lead) ? lead : least_lead;
    rivals -= rival;  // truth is -1
  }
  unsigned count = 0;
  for (std::size_t k = 0; k < kLanes; ++k) count += static_cast<unsigned>(rivals[k]);
  return least(least_lead) > 0.6931472f * static_cast<float>(std::bit_width(count)) + 0.5f * w.spread[l] +
                                 kBoundMargin + mixture.error.score;
}

inline void select(const FloatMixture& mixture, const Bounds& bounds, const Reach<float>& reach,
                   ComponentSelection& selection) {
  selection.count = 0;
  for (std::size_t block = 0; block < mixture.count / kLanes; ++block) {
    Ints wanted;
    matters(bounds.lanes[block], reach, wanted);
    if (!any(wanted)) continue;
    for (std::size_t l = 0; l < kLanes; ++l) {
      if (wanted[l] != 0) selection.column[selection.count++] = static_cast<std::uint8_t>(block * kLanes + l);
    }
  }
}

}  // namespace

HINDSIGHT_MULTIVERSION Outlook survey(const FloatMixture& mixture, const ColorBox& box,
                                      ComponentSelection& selection) {
  const float surely_out = mixture.gate2 + mixture.error.d2_near_gate;
  Bounds bounds;
  bound_all(mixture, box, surely_out, bounds);
  if (bounds.nearest_low > surely_out) return {true, kUnknown};
  const bool all_inside = bounds.nearest_high < mixture.gate2 - mixture.error.d2_near_gate;
  const Reach<float> reach{bounds.best_low - FloatMixture::kNegligible,
                           all_inside ? -std::numeric_limits<float>::max() : surely_out, bounds.nearest_high};
  const std::size_t best = best_in_the_middle(bounds);
  const std::int32_t label = mixture.group[best];
  if ((all_inside || label == kUnknown) && beats_all(mixture, bounds, best, reach)) return {true, label};
  select(mixture, bounds, reach, selection);
  return {false, -1};
}

}  // namespace hindsight

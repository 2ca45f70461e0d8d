// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/mixture_survey.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "perception/multiversion.h"

namespace hindsight {
namespace {

constexpr int kGroups = FloatMixture::kGroups;
constexpr std::int32_t kUnknown = static_cast<std::int32_t>(TerrainClass::unknown);
/// More than what floats may be off in a bound, in log-likelihood.
constexpr float kMargin = 0.05f;

/// Over a box, a component's squared distance d2 is convex: it lies above its tangent in the box's middle and
/// below that plus `spread`, its curvature's share. Scores are log-likelihoods.
struct Bounds {
  struct Lanes {
    Floats d2_low, score, score_high;  ///< `score` in the middle
    Floats slope[3];                   ///< half the gradient of d2 times the box's half side
    Floats spread;                     ///< most that |W (c - middle)|^2 can be
  };
  Lanes lanes[kMostComponents / kLanes];
  float nearest_low, nearest_high;
  float best;      ///< largest score in the middle
  float best_low;  ///< what the largest score is at least wherever a colour of the box is inside the gate
};

inline void bound(const FloatMixture& t, const ColorBox& box, float surely_out, Bounds& out) {
  using Row = FloatMixture;
  Floats nearest_low = Floats{} + std::numeric_limits<float>::max(), nearest_high = nearest_low,
         best = -nearest_low, best_low = best, least_factor = nearest_low;
  for (std::size_t j = 0; j < t.count; j += kLanes) {
    Bounds::Lanes& lanes = out.lanes[j / kLanes];
    Floats v[Row::kRows];
    for (int row = 0; row < Row::kRows; ++row) load(v[row], &t.value[row][j]);
    const Floats x = box.middle[0] - v[Row::mean0], y = box.middle[1] - v[Row::mean1],
                 z = box.middle[2] - v[Row::mean2];
    const Floats p = v[Row::w00] * x, q = v[Row::w10] * x + v[Row::w11] * y;
    const Floats r = v[Row::w20] * x + v[Row::w21] * y + v[Row::w22] * z;
    const Floats d2 = p * p + q * q + r * r;  // (5.2)
    lanes.slope[0] = (v[Row::w00] * p + v[Row::w10] * q + v[Row::w20] * r) * box.half[0];
    lanes.slope[1] = (v[Row::w11] * q + v[Row::w21] * r) * box.half[1];
    lanes.slope[2] = v[Row::w22] * r * box.half[2];
    Floats a = lanes.slope[0], b = lanes.slope[1], c = lanes.slope[2];
    absolute(a), absolute(b), absolute(c);
    const Floats reach = 2.0f * (a + b + c);
    absolute(v[Row::w10]), absolute(v[Row::w20]), absolute(v[Row::w21]);
    const Floats most_p = v[Row::w00] * box.half[0],
                 most_q = v[Row::w10] * box.half[0] + v[Row::w11] * box.half[1];
    const Floats most_r = v[Row::w20] * box.half[0] + v[Row::w21] * box.half[1] + v[Row::w22] * box.half[2];
    lanes.spread = most_p * most_p + most_q * most_q + most_r * most_r;

    lanes.d2_low = d2 - reach;
    const Floats d2_high = d2 + reach + lanes.spread;
    lanes.score = v[Row::log_factor] - 0.5f * d2;
    lanes.score_high = lanes.score + 0.5f * reach;
    const Floats score_low = lanes.score - 0.5f * (reach + lanes.spread);
    nearest_high = d2_high < nearest_high ? d2_high : nearest_high;
    nearest_low = lanes.d2_low < nearest_low ? lanes.d2_low : nearest_low;
    larger_of(best, lanes.score);
    larger_of(best_low, score_low);
    const Floats factor = lanes.d2_low <= surely_out ? v[Row::log_factor] : least_factor;
    least_factor = factor < least_factor ? factor : least_factor;
  }
  out.nearest_high = least(nearest_high);
  out.nearest_low = least(nearest_low);
  out.best = -least(-best);
  // Inside the gate means inside that of a component that reaches into the box.
  out.best_low = std::max(-least(-best_low), least(least_factor) - 0.5f * surely_out - kMargin);
}

/// The components that matter somewhere in the box: for the class by their likelihood, for (5.2) by distance.
inline void matters(const Bounds& bounds, std::size_t block, float gate_reach, Ints& truth) {
  const Bounds::Lanes& lanes = bounds.lanes[block];
  truth = (lanes.score_high >= bounds.best_low - FloatMixture::kNegligible) | (lanes.d2_low <= gate_reach);
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
                      float gate_reach) {
  const Bounds::Lanes& w = bounds.lanes[winner / kLanes];
  const std::size_t l = winner % kLanes;
  Floats least_lead = Floats{} + std::numeric_limits<float>::max();
  Ints rivals = Ints{};
  for (std::size_t block = 0; block < mixture.count / kLanes; ++block) {
    const Bounds::Lanes& o = bounds.lanes[block];
    Ints group, rival;
    load(group, &mixture.group[block * kLanes]);
    matters(bounds, block, gate_reach, rival);
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
                                 kMargin + mixture.error.score;
}

/// The components that matter, by group.
inline void select(const FloatMixture& mixture, const Bounds& bounds, float gate_reach,
                   ComponentSelection& selection) {
  std::uint16_t kept[kGroups][kMostComponents];
  int count[kGroups] = {};
  for (std::size_t block = 0; block < mixture.count / kLanes; ++block) {
    Ints wanted;
    matters(bounds, block, gate_reach, wanted);
    if (!any(wanted)) continue;
    for (std::size_t l = 0; l < kLanes; ++l) {
      const std::size_t j = block * kLanes + l;
      if (wanted[l] != 0) kept[mixture.group[j]][count[mixture.group[j]]++] = static_cast<std::uint16_t>(j);
    }
  }
  std::uint16_t* end = selection.column;
  for (int g = 0; g < kGroups; ++g) {
    end = std::copy_n(kept[g], count[g], end);
    selection.group_end[g] = static_cast<std::size_t>(end - selection.column);
  }
}

}  // namespace

HINDSIGHT_MULTIVERSION Outlook survey(const FloatMixture& mixture, const ColorBox& box,
                                      ComponentSelection& selection) {
  const float surely_out = mixture.gate2 + mixture.error.d2_near_gate;
  Bounds bounds;
  bound(mixture, box, surely_out, bounds);
  if (bounds.nearest_low > surely_out) return {true, kUnknown};
  const bool all_inside = bounds.nearest_high < mixture.gate2 - mixture.error.d2_near_gate;
  const float gate_reach = all_inside ? -std::numeric_limits<float>::max() : surely_out;
  const std::size_t best = best_in_the_middle(bounds);
  const std::int32_t label = mixture.group[best];
  if ((all_inside || label == kUnknown) && beats_all(mixture, bounds, best, gate_reach)) return {true, label};
  select(mixture, bounds, gate_reach, selection);
  return {false, -1};
}

}  // namespace hindsight

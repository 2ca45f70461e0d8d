// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Bounds of one component over one box in each lane: for the functions that survey boxes.
#pragma once

#include <limits>

#include "perception/float_mixture.h"
#include "perception/multiversion.h"
#include "perception/simd.h"

namespace hindsight {

/// More than what floats may be off in a bound, in log-likelihood.
constexpr float kBoundMargin = 0.05f;

/// Over a box, a component's squared distance d2 is convex: it lies above its tangent in the box's middle and
/// below that plus `spread`, its curvature's share. Scores are log-likelihoods. The lanes are components, or
/// boxes.
struct Lanes {
  Floats d2_low, d2_high;
  Floats score, score_high;  ///< `score` in the middle
  Floats slope[3];           ///< half the gradient of d2 times the box's half side
  Floats spread;             ///< most that |W (c - middle)|^2 can be
};
/// What a box's components, lane by lane, come to together.
struct Extremes {
  Floats nearest_low = Floats{} + std::numeric_limits<float>::max(), nearest_high = nearest_low;
  Floats best = -nearest_low;         ///< largest score in the middle
  Floats best_low = best;             ///< what the largest score is at least, from the scores' bounds
  Floats least_factor = nearest_low;  ///< of the components whose gate reaches into the box
};

using Component = Floats[FloatMixture::kRows];

HINDSIGHT_ALWAYS_INLINE void bound(const Component& v, const Floats (&middle)[3], const Floats (&half)[3],
                                   float surely_out, Lanes& lanes, Extremes& extremes) {
  using Row = FloatMixture;
  const Floats x = middle[0] - v[Row::mean0], y = middle[1] - v[Row::mean1], z = middle[2] - v[Row::mean2];
  const Floats p = v[Row::w00] * x, q = v[Row::w10] * x + v[Row::w11] * y;
  const Floats r = v[Row::w20] * x + v[Row::w21] * y + v[Row::w22] * z;
  const Floats d2 = p * p + q * q + r * r;  // (5.2)
  lanes.slope[0] = (v[Row::w00] * p + v[Row::w10] * q + v[Row::w20] * r) * half[0];
  lanes.slope[1] = (v[Row::w11] * q + v[Row::w21] * r) * half[1];
  lanes.slope[2] = v[Row::w22] * r * half[2];
  Floats a = lanes.slope[0], b = lanes.slope[1], c = lanes.slope[2];
  absolute(a), absolute(b), absolute(c);
  const Floats reach = 2.0f * (a + b + c);
  Floats w10 = v[Row::w10], w20 = v[Row::w20], w21 = v[Row::w21];
  absolute(w10), absolute(w20), absolute(w21);
  const Floats most_p = v[Row::w00] * half[0], most_q = w10 * half[0] + v[Row::w11] * half[1];
  const Floats most_r = w20 * half[0] + w21 * half[1] + v[Row::w22] * half[2];
  lanes.spread = most_p * most_p + most_q * most_q + most_r * most_r;

  lanes.d2_low = d2 - reach;
  lanes.d2_high = d2 + reach + lanes.spread;
  lanes.score = v[Row::log_factor] - 0.5f * d2;
  lanes.score_high = lanes.score + 0.5f * reach;
  const Floats score_low = lanes.score - 0.5f * (reach + lanes.spread);
  smaller_of(extremes.nearest_high, lanes.d2_high);
  smaller_of(extremes.nearest_low, lanes.d2_low);
  larger_of(extremes.best, lanes.score);
  larger_of(extremes.best_low, score_low);
  smaller_of(extremes.least_factor, lanes.d2_low <= surely_out ? v[Row::log_factor] : extremes.least_factor);
}

/// What a component must reach to matter in a box: one number, or one a lane.
template <typename Number>
struct Reach {
  Number score;  ///< so much less than the best that it is negligible
  Number gate2;  ///< squared distance where it may be the one inside whose gate a colour is
  Number nearest_high;
};

/// The components that matter somewhere in the box: for the class by their likelihood, for (5.2) by distance.
/// Where the whole box is inside the gate, the nearest proves it, however unlikely.
template <typename Number>
HINDSIGHT_ALWAYS_INLINE void matters(const Lanes& lanes, const Reach<Number>& reach, Ints& truth) {
  truth = (lanes.score_high >= reach.score) | (lanes.d2_low <= reach.gate2) |
          (lanes.d2_high <= reach.nearest_high);
}

}  // namespace hindsight

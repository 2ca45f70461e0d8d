// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "perception/color_space.h"
#include "perception/mixture_likelihood.h"
#include "perception/simd.h"

namespace hindsight {

/// Components in single precision, a column each, with how far that may be off: what cannot be told by it is
/// left to MixtureLikelihood.
struct FloatMixture {
  /// The classes and the group of components without one.
  static constexpr int kGroups = kLabelCount + 1;
  /// Components whose log-likelihood is this far below the best are left out (e^-12 = 6.2e-6).
  static constexpr float kNegligible = 12.0f;

  /// mean, W as in WhitenedGaussian, logarithm of LikelihoodTerm's factor.
  enum Row { mean0, mean1, mean2, w00, w10, w11, w20, w21, w22, log_factor, kRows };
  /// How far the floats may be off, over all components.
  struct ErrorBound {
    float d2_near_gate;      ///< of a squared distance that is about the gate's
    float score;             ///< of the difference of two log-likelihoods where it can matter
    float likelihood_ratio;  ///< relative, of the ratio of two classes' likelihoods where it can matter
  };

  alignas(64) float value[kRows][kMostComponents];
  int group[kMostComponents];  ///< TerrainClass as a number
  std::size_t count = 0;       ///< a multiple of kLanes: behind the last one come a few that are nowhere
  float gate2 = 0.0f;
  ErrorBound error{};

  void set(const MixtureLikelihood& exact, ColorSpace color_space);
};

/// Columns of a FloatMixture.
struct ComponentSelection {
  std::uint8_t column[kMostComponents];
  std::size_t count;
};
static_assert(kMostComponents <= 256, "columns are bytes");

}  // namespace hindsight

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Many like colours at once: single precision where its error cannot matter, double precision where it could.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "perception/mixture_likelihood.h"
#include "perception/terrain_mixture.h"

namespace hindsight {

/// Classes of colours by (5.1) and (5.2), always equal to MixtureLikelihood's. For a group of like colours it
/// first bounds the distance to each component over the group, which leaves a few components, often of one
/// class; then it evaluates those in vectors of floats, and asks MixtureLikelihood wherever the two largest
/// likelihoods, or distance and gate, are closer than the floats' error bound. No allocation after
/// construction.
class ColorClassifier {
 public:
  explicit ColorClassifier(std::size_t most_colors);

  void set(const TerrainMixture& mixture);

  /// The colours, b | g << 8 | r << 16 each, that classify() is about; at most most_colors. They must stay
  /// until then.
  void load(std::span<const std::uint32_t> keys);

  /// Labels of the loaded colours begin..end, to labels[0] and on. Fastest for colours near each other.
  void classify(std::size_t begin, std::size_t end, std::uint8_t* labels);

  /// Components in floats, a column each; W as in WhitenedGaussian. Behind the last one come a few that are
  /// nowhere.
  struct Table {
    enum Row { mean0, mean1, mean2, w00, w10, w11, w20, w21, w22, log_factor, kRows };
    alignas(64) float value[kRows][kMostComponents];
    int group[kMostComponents];  ///< TerrainClass as a number
    std::size_t count = 0;
  };
  /// The columns that matter to a group of colours, in the order of their groups, and where each group ends.
  struct Selection {
    std::uint16_t column[kMostComponents];
    std::size_t group_end[kLabelCount + 1];
  };
  /// How far the floats may be off, over all components.
  struct ErrorBound {
    float d2_near_gate;      ///< of a squared distance that is about the gate's
    float score;             ///< of the difference of two log-likelihoods where it can matter
    float likelihood_ratio;  ///< relative, of the ratio of two classes' likelihoods where it can matter
  };
  /// A class for a whole group of colours, or the components that matter to it.
  struct Outlook {
    bool decided;
    std::int32_t label;
  };

 private:
  MixtureLikelihood exact_;
  ColorSpace color_space_ = ColorSpace::rgb;
  float gate2_ = 0.0f;
  ErrorBound error_{};
  Table terms_{};
  Selection selection_{};
  std::span<const std::uint32_t> keys_;
  std::array<std::vector<float>, 3> channels_;
  std::vector<std::int32_t> found_;
};

}  // namespace hindsight

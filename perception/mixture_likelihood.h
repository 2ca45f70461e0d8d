// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "perception/terrain_class.h"
#include "perception/terrain_mixture.h"
#include "perception/whitened_gaussian.h"

namespace hindsight {

/// One summand of (5.1).
struct LikelihoodTerm {
  WhitenedGaussian gaussian;
  double factor;       ///< 1 / M(l) and the Gaussian's own factor
  TerrainClass label;  ///< unknown: the group of components without a class
};

/// Equations (5.1) and (5.2) in double precision, prepared for many colours.
class MixtureLikelihood {
 public:
  explicit MixtureLikelihood(std::size_t capacity) { terms_.reserve(capacity); }

  /// Allocates only beyond the capacity given at construction.
  void set(std::span<const MixtureComponent> components, double gate);
  TerrainClass classify(const Eigen::Vector3d& color) const;

  std::span<const LikelihoodTerm> terms() const { return terms_; }
  double gate() const { return gate_; }

 private:
  std::vector<LikelihoodTerm> terms_;
  double gate_ = 0.0;
};

}  // namespace hindsight

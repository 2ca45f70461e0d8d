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

/// As if there had been so many more events, about none of the colours that are known.
constexpr double kDoubtVotes = 1.0;

/// One summand of (5.1).
struct LikelihoodTerm {
  WhitenedGaussian gaussian;
  double factor;       ///< the Gaussian's own factor times 1 / M(l), or times its share of the class
  TerrainClass label;  ///< unknown: the group of components without a class
};

/// Equations (5.1) and (5.2) in double precision, prepared for many colours.
///
/// (5.1) gives all components that bear a class' label equal parts in it, f(c|l) = 1/M(l) sum G_j(c). With
/// class_density = "shares", good ground has its parts in all components, and obstacles have theirs,
/// f(c|l) = sum v_jl / (V_l + kDoubtVotes) G_j(c): v_jl the component's votes for one or the other, V_l all
/// such votes. So a colour that bark and ground share counts for both, many looks at the ground do not
/// outvote a few touches, and the first touch is not believed like the tenth. What a component means by an
/// obstacle, bad or lethal, is what most of its votes say. Components without enough votes are left out, and
/// do not make a colour known by (5.2).
class MixtureLikelihood {
 public:
  explicit MixtureLikelihood(std::size_t capacity) { terms_.reserve(capacity); }

  /// Allocates only where there are more terms than the capacity given at construction; there are never more
  /// than kMostComponents.
  void set(const TerrainMixture& mixture);
  TerrainClass classify(const Eigen::Vector3d& color) const;

  std::span<const LikelihoodTerm> terms() const { return terms_; }
  double gate() const { return gate_; }

 private:
  void add_labels(std::span<const MixtureComponent> components);
  void add_shares(std::span<const MixtureComponent> components);

  std::vector<LikelihoodTerm> terms_;
  double gate_ = 0.0;
};

}  // namespace hindsight

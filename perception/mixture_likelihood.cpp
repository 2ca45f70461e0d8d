// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/mixture_likelihood.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace hindsight {
namespace {

using PerClass = std::array<double, kLabelCount + 1>;

std::size_t index_of(TerrainClass label) { return static_cast<std::size_t>(label); }

/// The class of the largest likelihood; of equal ones the most severe.
TerrainClass most_likely(const PerClass& likelihood) {
  TerrainClass best = TerrainClass::lethal;
  for (const TerrainClass next : {TerrainClass::bad, TerrainClass::good, TerrainClass::unknown}) {
    if (likelihood[index_of(next)] > likelihood[index_of(best)]) best = next;
  }
  return best;
}

}  // namespace

void MixtureLikelihood::set(std::span<const MixtureComponent> components, double gate) {
  gate_ = gate;
  terms_.clear();
  PerClass count{};  // M(l)
  for (const MixtureComponent& c : components) count[index_of(c.label)] += 1.0;
  const double unit = std::pow(2.0 * std::numbers::pi, -1.5);
  for (const MixtureComponent& c : components) {
    const WhitenedGaussian g = whiten(c.mean, c.covariance);
    terms_.push_back({g, unit * g.inverse_root_determinant() / count[index_of(c.label)], c.label});
  }
}

TerrainClass MixtureLikelihood::classify(const Eigen::Vector3d& color) const {
  PerClass likelihood{};
  double nearest = std::numeric_limits<double>::infinity();
  for (const LikelihoodTerm& term : terms_) {
    const double d2 = term.gaussian.squared_distance(color);  // (5.2)
    nearest = std::min(nearest, d2);
    likelihood[index_of(term.label)] += term.factor * std::exp(-0.5 * d2);  // (5.1)
  }
  return nearest > gate_ * gate_ ? TerrainClass::unknown : most_likely(likelihood);
}

}  // namespace hindsight

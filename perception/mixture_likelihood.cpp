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

/// Of a Gaussian in three dimensions, without its covariance's part.
const double kUnit = std::pow(2.0 * std::numbers::pi, -1.5);
/// Smaller shares are left out: they tell nothing, and cost time.
constexpr double kLeastShare = 1e-4;

using PerClass = std::array<double, kLabelCount + 1>;

std::size_t index_of(TerrainClass label) { return static_cast<std::size_t>(label); }

double obstacle_votes(const MixtureComponent& c) {
  return c.votes[index_of(TerrainClass::bad)] + c.votes[index_of(TerrainClass::lethal)];
}

/// The class of the largest likelihood; of equal ones the most severe.
TerrainClass most_likely(const PerClass& likelihood) {
  TerrainClass best = TerrainClass::lethal;
  for (const TerrainClass next : {TerrainClass::bad, TerrainClass::good, TerrainClass::unknown}) {
    if (likelihood[index_of(next)] > likelihood[index_of(best)]) best = next;
  }
  return best;
}

}  // namespace

void MixtureLikelihood::set(const TerrainMixture& mixture) {
  gate_ = mixture.params().gate;
  terms_.clear();
  if (mixture.params().class_density == "shares") {
    add_shares(mixture.components());
  } else {
    add_labels(mixture.components());
  }
}

void MixtureLikelihood::add_labels(std::span<const MixtureComponent> components) {
  PerClass count{};  // M(l)
  for (const MixtureComponent& c : components) count[index_of(c.label)] += 1.0;
  for (const MixtureComponent& c : components) {
    const WhitenedGaussian g = whiten(c.mean, c.covariance);
    terms_.push_back({g, kUnit * g.inverse_root_determinant() / count[index_of(c.label)], c.label});
  }
}

void MixtureLikelihood::add_shares(std::span<const MixtureComponent> components) {
  double all_good = kDoubtVotes, all_obstacle = kDoubtVotes;
  for (const MixtureComponent& c : components) {
    all_good += c.votes[index_of(TerrainClass::good)];
    all_obstacle += obstacle_votes(c);
  }
  for (const MixtureComponent& c : components) {
    if (c.label == TerrainClass::unknown) continue;
    const WhitenedGaussian g = whiten(c.mean, c.covariance);
    const auto add = [&](double share, TerrainClass label) {
      if (share >= kLeastShare) terms_.push_back({g, kUnit * g.inverse_root_determinant() * share, label});
    };
    const bool lethal = c.votes[index_of(TerrainClass::lethal)] >= c.votes[index_of(TerrainClass::bad)];
    add(c.votes[index_of(TerrainClass::good)] / all_good, TerrainClass::good);
    add(obstacle_votes(c) / all_obstacle, lethal ? TerrainClass::lethal : TerrainClass::bad);
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

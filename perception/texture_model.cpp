// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/texture_model.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hindsight {
namespace {

/// Votes for a class beyond which the oldest fade: what the ground looks like changes with the light.
constexpr double kMemoryVotes = 200.0;
/// As if there had been so many more events, of no texture that is known.
constexpr double kDoubtVotes = 1.0;
/// What is added to each class as if every texture had been seen, in shares: no ratio without evidence.
constexpr double kPriorShare = 0.1 / kTextureCodes;

double total(std::span<const double> votes) { return std::accumulate(votes.begin(), votes.end(), 0.0); }

}  // namespace

void TextureModel::train(std::span<const std::uint8_t> codes, TerrainClass label) {
  if (codes.empty() || label == TerrainClass::unknown) return;
  auto& votes = votes_[static_cast<std::size_t>(label)];
  for (const std::uint8_t code : codes) votes[code] += 1.0 / static_cast<double>(codes.size());
  const double all = total(votes);
  if (all > kMemoryVotes) {
    for (double& v : votes) v *= kMemoryVotes / all;
  }
}

TextureLogRatios TextureModel::log_ratios(double limit) const {
  const auto& [good, bad, lethal] = votes_;
  const double good_votes = total(good), obstacle_votes = total(bad) + total(lethal);
  TextureLogRatios ratios{};
  if (good_votes <= 0.0 || obstacle_votes <= 0.0) return ratios;
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    const double obstacle_share = (bad[i] + lethal[i]) / (obstacle_votes + kDoubtVotes) + kPriorShare,
                 good_share = good[i] / (good_votes + kDoubtVotes) + kPriorShare;
    ratios[i] = static_cast<float>(std::clamp(std::log(obstacle_share / good_share), -limit, limit));
  }
  return ratios;
}

}  // namespace hindsight

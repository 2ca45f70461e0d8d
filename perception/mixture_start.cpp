// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/mixture_start.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace hindsight {
namespace {

constexpr int kMaxRounds = 20;

using Colors = std::vector<Eigen::Vector3d>;

/// Every `step`-th pixel of every `step`-th row.
Colors sample(std::span<const std::uint8_t> bgr, int width_px, int height_px, int step, ColorSpace space) {
  Colors colors;
  for (int y = 0; y < height_px; y += step) {
    for (int x = 0; x < width_px; x += step) {
      const std::uint8_t* p = &bgr[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px) +
                                        static_cast<std::size_t>(x))];
      colors.push_back(color_of(space, p[0], p[1], p[2]));
    }
  }
  return colors;
}

/// k-means++: each further centre is a sample drawn with the probability of its squared distance to the
/// centres so far. Fewer than k where the samples have fewer colours.
Colors spread_centers(const Colors& samples, int k, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Colors centers{samples[random() % samples.size()]};
  std::vector<double> d2(samples.size(), std::numeric_limits<double>::infinity());
  while (static_cast<int>(centers.size()) < k) {
    double total = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      d2[i] = std::min(d2[i], (samples[i] - centers.back()).squaredNorm());
      total += d2[i];
    }
    if (total <= 0.0) break;
    double left = total * (static_cast<double>(random() >> 11) * 0x1p-53);
    std::size_t pick = 0;
    for (std::size_t i = 0; i < samples.size() && left >= 0.0; left -= d2[i++]) {
      if (d2[i] > 0.0) pick = i;
    }
    centers.push_back(samples[pick]);
  }
  return centers;
}

std::size_t nearest(const Colors& centers, const Eigen::Vector3d& color) {
  std::size_t best = 0;
  double best_d2 = std::numeric_limits<double>::infinity();
  for (std::size_t j = 0; j < centers.size(); ++j) {
    const double d2 = (color - centers[j]).squaredNorm();
    if (d2 < best_d2) best_d2 = d2, best = j;
  }
  return best;
}

/// Lloyd's rounds until nothing moves. Returns each sample's cluster.
std::vector<std::size_t> cluster(const Colors& samples, Colors& centers) {
  std::vector<std::size_t> member(samples.size(), 0);
  for (int round = 0; round < kMaxRounds; ++round) {
    Colors sum(centers.size(), Eigen::Vector3d::Zero());
    std::vector<double> count(centers.size(), 0.0);
    bool moved = round == 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const std::size_t j = nearest(centers, samples[i]);
      moved |= j != member[i];
      member[i] = j;
      sum[j] += samples[i];
      count[j] += 1.0;
    }
    if (!moved) break;
    for (std::size_t j = 0; j < centers.size(); ++j) {
      if (count[j] > 0.0) centers[j] = sum[j] / count[j];
    }
  }
  return member;
}

std::vector<MixtureComponent> gaussians(const Colors& samples, const std::vector<std::size_t>& member,
                                        std::size_t k) {
  std::vector<MixtureComponent> parts(k);
  for (MixtureComponent& c : parts) c.covariance.setZero();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    parts[member[i]].mean += samples[i];
    parts[member[i]].weight_px += 1.0;
  }
  for (MixtureComponent& c : parts) c.mean /= std::max(c.weight_px, 1.0);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Eigen::Vector3d offset = samples[i] - parts[member[i]].mean;
    parts[member[i]].covariance += offset * offset.transpose() / parts[member[i]].weight_px;
  }
  std::erase_if(parts, [](const MixtureComponent& c) { return c.weight_px == 0.0; });
  return parts;
}

}  // namespace

std::vector<MixtureComponent> start_components(std::span<const std::uint8_t> bgr, int width_px, int height_px,
                                               const MixtureParams& params) {
  if (bgr.empty()) return {};
  const double pixels = static_cast<double>(width_px) * static_cast<double>(height_px);
  const int step = std::max(1, static_cast<int>(std::sqrt(pixels / kStartSamples)));
  const Colors samples = sample(bgr, width_px, height_px, step, parse_color_space(params.color_space));
  const int k = std::min(params.start_components, params.max_components);
  Colors centers = spread_centers(samples, k, static_cast<std::uint64_t>(params.seed));
  const std::vector<std::size_t> member = cluster(samples, centers);

  std::vector<MixtureComponent> parts = gaussians(samples, member, centers.size());
  for (MixtureComponent& c : parts) {
    c.weight_px = std::min(c.weight_px * step * step, params.memory_px);
    c.covariance = floor_eigenvalues(c.covariance, params.eigenvalue_floor);
  }
  std::ranges::stable_sort(parts, {}, [](const MixtureComponent& c) { return c.mean[0]; });
  return parts;
}

}  // namespace hindsight

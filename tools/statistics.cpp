// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/statistics.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim_replay/world/random.h"

namespace hindsight::tools {
namespace {

constexpr int kDraws = 100'000;
constexpr double kChiSquare95 = 5.991;  ///< two degrees of freedom

double covariance(std::span<const double> a, std::span<const double> b) {
  const double mean_a = mean_of(a), mean_b = mean_of(b);
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - mean_a) * (b[i] - mean_b);
  return a.size() > 1 ? sum / static_cast<double>(a.size() - 1) : 0.0;
}

}  // namespace

double mean_of(std::span<const double> values) {
  return values.empty()
             ? 0.0
             : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double quantile_of(std::vector<double> values, double part) {
  if (values.empty()) return 0.0;
  const auto rank = static_cast<std::ptrdiff_t>(std::ceil(part * static_cast<double>(values.size()))) - 1;
  const auto at =
      values.begin() + std::clamp<std::ptrdiff_t>(rank, 0, static_cast<std::ptrdiff_t>(values.size()) - 1);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

double sign_flip_p_value(std::span<const double> differences, std::uint64_t seed) {
  Random random(seed);
  const double seen = std::abs(std::accumulate(differences.begin(), differences.end(), 0.0));
  int as_far = 0;
  for (int draw = 0; draw < kDraws; ++draw) {
    double sum = 0.0;
    for (const double d : differences) sum += random.uniform(0.0, 1.0) < 0.5 ? d : -d;
    as_far += std::abs(sum) >= seen - 1e-9;
  }
  return (as_far + 1.0) / (kDraws + 1.0);
}

Ellipse ellipse_95(std::span<const double> x, std::span<const double> y) {
  Eigen::Matrix2d c;
  c << covariance(x, x), covariance(x, y), covariance(x, y), covariance(y, y);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(c);
  const Eigen::Vector2d axis = solver.eigenvectors().col(1);
  const auto half = [&](int i) { return std::sqrt(kChiSquare95 * std::max(0.0, solver.eigenvalues()(i))); };
  return {mean_of(x), mean_of(y), half(1), half(0), std::atan2(axis.y(), axis.x())};
}

}  // namespace hindsight::tools

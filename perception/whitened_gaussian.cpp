// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/whitened_gaussian.h"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace hindsight {

WhitenedGaussian whiten(const Eigen::Vector3d& mean, const Eigen::Matrix3d& s) {
  const double l00 = std::sqrt(s(0, 0)), l10 = s(1, 0) / l00, l20 = s(2, 0) / l00;
  const double l11 = std::sqrt(s(1, 1) - l10 * l10), l21 = (s(2, 1) - l20 * l10) / l11;
  const double l22 = std::sqrt(s(2, 2) - l20 * l20 - l21 * l21);
  WhitenedGaussian g{mean, 1.0 / l00, 0.0, 1.0 / l11, 0.0, 0.0, 1.0 / l22};
  g.w10 = -l10 * g.w00 * g.w11;
  g.w21 = -l21 * g.w11 * g.w22;
  g.w20 = -(l20 * g.w00 + l21 * g.w10) * g.w22;
  return g;
}

Eigen::Matrix3d floor_eigenvalues(const Eigen::Matrix3d& symmetric, double floor) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(symmetric);
  if (solver.eigenvalues()[0] >= floor) return symmetric;
  const Eigen::Matrix3d& axes = solver.eigenvectors();
  const Eigen::Matrix3d floored = axes * solver.eigenvalues().cwiseMax(floor).asDiagonal() * axes.transpose();
  return 0.5 * (floored + floored.transpose());
}

}  // namespace hindsight

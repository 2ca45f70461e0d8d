// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <Eigen/Core>

namespace hindsight {

/// A Gaussian prepared for distances: W = L^-1 with S = L L^T, so that (5.2) is the length of W (c - mean).
struct WhitenedGaussian {
  Eigen::Vector3d mean;
  double w00, w10, w11, w20, w21, w22;  ///< W's lower triangle

  double squared_distance(const Eigen::Vector3d& c) const {
    const double x = c[0] - mean[0], y = c[1] - mean[1], z = c[2] - mean[2];
    const double p = w00 * x, q = w10 * x + w11 * y, r = w20 * x + w21 * y + w22 * z;
    return p * p + q * q + r * r;
  }
  /// 1 / sqrt(|S|)
  double inverse_root_determinant() const { return w00 * w11 * w22; }
};

/// `covariance`: symmetric and positive definite, which every component's is.
WhitenedGaussian whiten(const Eigen::Vector3d& mean, const Eigen::Matrix3d& covariance);

/// The symmetric matrix with the same eigenvectors and no eigenvalue below `floor`.
Eigen::Matrix3d floor_eigenvalues(const Eigen::Matrix3d& symmetric, double floor);

}  // namespace hindsight

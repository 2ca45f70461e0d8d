// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/track_alignment.h"

#include <algorithm>
#include <limits>

namespace hindsight {

void TrackAlignment::add(const Point2& p_WP_m, const Point2& p_EP_m, double sigma_m) {
  const double w = 1.0 / (sigma_m * sigma_m);
  const Point2 dW{p_WP_m.x_m - mean_W_.x_m, p_WP_m.y_m - mean_W_.y_m};
  const Point2 dE{p_EP_m.x_m - mean_E_.x_m, p_EP_m.y_m - mean_E_.y_m};
  const double gain = w / (weight_ + w);
  const double centred = w * (1.0 - gain);
  spread_W_ += centred * (dW.x_m * dW.x_m + dW.y_m * dW.y_m);
  spread_E_ += centred * (dE.x_m * dE.x_m + dE.y_m * dE.y_m);
  dot_ += centred * (dE.x_m * dW.x_m + dE.y_m * dW.y_m);
  cross_ += centred * (dE.x_m * dW.y_m - dE.y_m * dW.x_m);
  mean_W_ = {mean_W_.x_m + gain * dW.x_m, mean_W_.y_m + gain * dW.y_m};
  mean_E_ = {mean_E_.x_m + gain * dE.x_m, mean_E_.y_m + gain * dE.y_m};
  weight_ += w;
  ++count_;
}

Pose2 TrackAlignment::X_WE() const {
  Pose2 X{0.0, 0.0, std::atan2(cross_, dot_)};
  const Point2 rotated = X * mean_E_;
  X.x_m = mean_W_.x_m - rotated.x_m;
  X.y_m = mean_W_.y_m - rotated.y_m;
  return X;
}

double TrackAlignment::heading_sigma_rad() const {
  return spread_W_ > 0.0 ? 1.0 / std::sqrt(spread_W_) : std::numeric_limits<double>::infinity();
}

double TrackAlignment::centre_sigma_m() const { return 1.0 / std::sqrt(weight_); }

Point2 TrackAlignment::centre_W_m() const { return mean_W_; }

double TrackAlignment::reduced_chi_square() const {
  if (count_ < 2) return 0.0;
  const double squares = spread_W_ + spread_E_ - 2.0 * std::hypot(dot_, cross_);
  return std::max(0.0, squares) / (2.0 * count_ - 3.0);
}

}  // namespace hindsight

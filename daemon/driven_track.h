// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "perception/pose.h"

namespace hindsight {

/// The last poses that were driven through, in W, oldest first; those in between closer ones are left out.
/// Takes no memory after construction.
class DrivenTrack {
 public:
  static constexpr std::size_t kMostPoses = 512;
  static constexpr double kSpacing_m = 0.25;

  void add(const Pose2& X_WB) {
    const Pose2& last = poses_[(count_ + kMostPoses - 1) % kMostPoses];
    if (count_ > 0 && std::hypot(X_WB.x_m - last.x_m, X_WB.y_m - last.y_m) < kSpacing_m) return;
    poses_[count_++ % kMostPoses] = X_WB;
  }
  std::vector<Pose2> poses() const {
    std::vector<Pose2> list;
    for (std::size_t i = count_ - std::min(count_, kMostPoses); i < count_; ++i)
      list.push_back(poses_[i % kMostPoses]);
    return list;
  }

 private:
  std::array<Pose2, kMostPoses> poses_{};
  std::size_t count_ = 0;  ///< of all that were added
};

}  // namespace hindsight

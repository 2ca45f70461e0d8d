// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// What a learned activity map says of an object seen now (thesis 3.2.1).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "perception/activity_map.h"
#include "perception/particle_filter.h"

namespace hindsight {

/// p(v, theta | x, y) of a learned map, made smooth once: neighbouring cells and bins lend each other what
/// they know, as a map of few objects needs it. The whole distribution is kept, so that cells in which
/// several directions or speeds are usual have several peaks, where a main mode or mean would lie between
/// them.
class ActivityPrior final : public MotionPrior {
 public:
  explicit ActivityPrior(const ActivityMap& map);

  /// Where the newest image lies: H_G_image takes its points to the map's frame.
  void look(const Eigen::Matrix3d& H_G_image);

  double probability(Point2f at_px, Point2f v_px) const override;
  bool sample(Point2f at_px, double uniform, Point2f& v_px) const override;
  double log_ratio(Point2f at_px, Point2f v_px) const override;

 private:
  struct Cell {
    double count = 0.0;  ///< motion here and beside [frames]
    std::vector<float> cumulative;
  };
  const Cell* cell_at(const Eigen::Vector2d& p_G) const;
  double expected_at(const Eigen::Vector2d& p_G) const;
  void smooth(int column, int row);

  const ActivityMap map_;
  double per_frame_ = 0.0;  ///< motion in a cell in view, over the whole map
  std::vector<int> slot_;
  std::vector<Cell> cells_;
  Eigen::Matrix3d H_G_image_ = Eigen::Matrix3d::Identity();
};

/// How small steps at `p` are mapped by H.
Eigen::Matrix2d jacobian_of(const Eigen::Matrix3d& H, const Eigen::Vector2d& p);

}  // namespace hindsight

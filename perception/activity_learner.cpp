// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/activity_learner.h"

#include <Eigen/Geometry>
#include <cmath>

#include "perception/activity_prior.h"

namespace hindsight {

void ActivityLearner::learn(std::span<const Track> tracks, std::span<const Eigen::Vector2d> view_G,
                            const Eigen::Matrix3d& H_G_image, ActivityMap& map) {
  map.look(view_G);
  for (const Track& track : tracks) {
    if (track.unseen_frames > 0) continue;
    const Eigen::Vector2d p(track.at_px.x_px, track.at_px.y_px), v(track.v_px.x_px, track.v_px.y_px);
    const Motion now{(H_G_image * p.homogeneous()).hnormalized(), jacobian_of(H_G_image, p) * v};
    Way& way = ways_[track.id];
    way.pending.push_back(now);
    way.proven = way.proven || (now.p_G - way.pending.front().p_G).norm() >= kProven_cells * map.cell();
    if (!way.proven) continue;
    for (const Motion& motion : way.pending) map.add(motion.p_G, motion.v_G);
    way.pending.clear();
  }
}

}  // namespace hindsight

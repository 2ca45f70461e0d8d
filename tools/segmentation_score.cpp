// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/segmentation_score.h"

#include <cmath>

#include "tools/pose_in_world.h"

namespace hindsight::tools {
namespace {

bool is_hazard(TerrainClass label) { return label == TerrainClass::bad || label == TerrainClass::lethal; }

bool is_ground_label(TruthLabel label) { return label == TruthLabel::ground || label == TruthLabel::road; }

/// Of the ground that a pixel shows: the parallelogram to the pixels beside and above it; 0 where there is
/// none.
float area_m2(const GroundPlane& ground, int column, int row) {
  const int other_column = column + 1 < ground.width_px() ? column + 1 : column - 1,
            other_row = row > 0 ? row - 1 : 1;
  const GroundPoint here = ground.at(column, row), beside = ground.at(other_column, row),
                    above = ground.at(column, other_row);
  const float area = std::abs((beside.x_m - here.x_m) * (above.y_m - here.y_m) -
                              (beside.y_m - here.y_m) * (above.x_m - here.x_m));
  return std::isfinite(area) ? area : 0.0F;
}

}  // namespace

SegmentationJudge::SegmentationJudge(const CameraModel& camera, double max_range_m) : p_BC_m_(camera.p_BC_m) {
  const GroundPlane ground(camera, max_range_m);
  for (int row = 0; row < camera.height_px; ++row) {
    for (int column = 0; column < camera.width_px; ++column) {
      area_m2_.push_back(area_m2(ground, column, row));
      rays_B_.push_back(camera.ray_B({static_cast<double>(column), static_cast<double>(row)}).cast<float>());
    }
  }
}

SegmentationTruth SegmentationJudge::truth_of(const RenderedFrame& frame, const BodyPose& pose,
                                              const World& world) const {
  const Eigen::Isometry3d X_WB = pose_in_world(pose);
  SegmentationTruth truth{std::vector<std::uint16_t>(area_m2_.size()), std::vector<bool>(area_m2_.size())};
  for (std::size_t i = 0; i < area_m2_.size(); ++i) {
    truth.is_ground[i] = is_ground_label(frame.labels[i]);
    if (frame.objects[i] == 0) continue;
    const Eigen::Vector3d p_W = X_WB * (p_BC_m_ + frame.depth_m[i] * rays_B_[i].cast<double>());
    if (p_W.z() - world.terrain.height_m({p_W.x(), p_W.y()}) <= kTop_m) truth.obstacle[i] = frame.objects[i];
  }
  return truth;
}

SegmentationScore SegmentationJudge::judge(const SegmentationTruth& truth,
                                           std::span<const TerrainClass> labels) const {
  struct Count {
    int all_px = 0, found_px = 0;
  };
  std::vector<Count> counts;
  SegmentationScore score;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const bool hazard = is_hazard(labels[i]);
    if (truth.is_ground[i]) {
      score.ground_m2 += area_m2_[i];
      score.wrong_m2 += hazard ? area_m2_[i] : 0.0;
    }
    if (truth.obstacle[i] == 0) continue;
    if (counts.size() <= truth.obstacle[i]) counts.resize(truth.obstacle[i] + std::size_t{1});
    ++counts[truth.obstacle[i]].all_px;
    counts[truth.obstacle[i]].found_px += hazard;
  }
  for (const Count& count : counts) {
    if (count.all_px < kFewest_px) continue;
    ++score.obstacles;
    score.coverage_sum += static_cast<double>(count.found_px) / count.all_px;
  }
  return score;
}

}  // namespace hindsight::tools

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/ground_patches.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hindsight {
namespace {

constexpr int kLargestBand_px = 24;  // at most 255, so that a band's counts of one column fit into a byte

GroundPoint between(GroundPoint a, GroundPoint b, float t) {
  return {a.x_m + t * (b.x_m - a.x_m), a.y_m + t * (b.y_m - a.y_m)};
}

bool is_ground(GroundPoint p) { return !std::isnan(p.x_m); }

float distance(GroundPoint a, GroundPoint b) { return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m); }

/// The ground line between a pixel and the one above it. Past the table's end, as far away as the edge below.
GroundPoint upper_edge(const GroundPlane& ground, int column, int row) {
  const GroundPoint here = ground.at(column, row);
  if (row > 0 && is_ground(ground.at(column, row - 1)))
    return between(here, ground.at(column, row - 1), 0.5F);
  if (row + 1 < ground.height_px()) return between(ground.at(column, row + 1), here, 1.5F);
  return here;
}

GroundPoint lower_edge(const GroundPlane& ground, int column, int row) {
  if (row + 1 < ground.height_px()) return upper_edge(ground, column, row + 1);
  return row > 0 ? between(ground.at(column, row), upper_edge(ground, column, row), -1.0F)
                 : ground.at(column, row);
}

/// From one column's ground to that of the next.
GroundPoint column_step(const GroundPlane& ground, int column, int row) {
  const int other =
      column + 1 < ground.width_px() && is_ground(ground.at(column + 1, row)) ? column + 1 : column - 1;
  if (other < 0 || !is_ground(ground.at(other, row))) return {0.0F, 0.0F};
  const GroundPoint a = ground.at(column, row), b = ground.at(other, row);
  return {b.x_m - a.x_m, b.y_m - a.y_m};
}

float parallelogram_m2(GroundPoint a, GroundPoint b) { return std::abs(a.x_m * b.y_m - a.y_m * b.x_m); }

class Builder {
 public:
  Builder(const BottomFinderParams& params, const CameraModel& camera, const GroundPlane& ground,
          double cell_m)
      : params_(params), camera_(camera), ground_(ground), cell_m_(cell_m), strip_px_(params.strip_px) {}

  GroundPatches build() {
    result_.strips = (ground_.width_px() + strip_px_ - 1) / strip_px_;
    for (int end = ground_.height_px(); end > 0;) {
      PatchBand band{band_begin(end), end, 1};
      band.strips_together = strips_together(band);
      result_.bands.push_back(band);
      for (int strip = 0; strip < result_.strips; ++strip) add_patch(strip, band);
      end = band.begin;
    }
    for (const GroundPatch& patch : result_.patches) result_.is_ground.push_back(patch.sample_count > 0);
    return std::move(result_);
  }

 private:
  /// A band ends where any strip would see more than step_m of ground in it.
  int band_begin(int end) const {
    int begin = end - 1;
    while (begin > 0 && end - begin < kLargestBand_px && !ground_ends_at(begin) &&
           longest_m(begin - 1, end) <= static_cast<float>(params_.step_m))
      --begin;
    return begin;
  }

  bool ground_ends_at(int row) const {
    for (int column = 0; column < ground_.width_px(); column += strip_px_) {
      if (is_ground(ground_.at(column, row)) != is_ground(ground_.at(column, row - 1))) return true;
    }
    return false;
  }

  float longest_m(int begin, int end) const {
    float longest = 0.0F;
    for (int column = 0; column < ground_.width_px(); column += strip_px_) {
      if (!is_ground(ground_.at(column, begin))) continue;
      longest = std::max(longest,
                         distance(lower_edge(ground_, column, end - 1), upper_edge(ground_, column, begin)));
    }
    return longest;
  }

  /// Neighbouring strips that see less than step_m of ground together; 1 where some see none.
  int strips_together(const PatchBand& band) const {
    float widest_m = 0.0F;
    for (int column = 0; column < ground_.width_px(); column += strip_px_) {
      if (!is_ground(ground_.at(column, band.begin))) return 1;
      const GroundPoint step = column_step(ground_, column, band.begin);
      widest_m = std::max(widest_m, std::hypot(step.x_m, step.y_m) * static_cast<float>(strip_px_));
    }
    return std::clamp(static_cast<int>(params_.step_m / std::max(widest_m, 1e-6F)), 1, result_.strips);
  }

  void add_patch(int strip, const PatchBand& band) {
    GroundPatch& patch = result_.patches.emplace_back();
    const int first = strip * strip_px_, columns = std::min(strip_px_, ground_.width_px() - first);
    const int left = first + (columns - 1) / 2, right = first + columns / 2;  // of the strip's middle
    for (const int column : {left, right}) {
      if (!is_ground(ground_.at(column, band.begin)) || !is_ground(ground_.at(column, band.end - 1))) return;
    }
    const GroundPoint near =
        between(lower_edge(ground_, left, band.end - 1), lower_edge(ground_, right, band.end - 1), 0.5F);
    const GroundPoint far =
        between(upper_edge(ground_, left, band.begin), upper_edge(ground_, right, band.begin), 0.5F);
    place_samples(patch, near, far);
    patch.contact = near;
    patch.min_lead_px = static_cast<float>(params_.min_height_m * camera_.fy_px / depth_m(near) * columns);
    if (params_.weighting == "pixels") {
      weigh_pixels(patch, columns);
    } else {
      const GroundPoint next_column = column_step(ground_, left, (band.begin + band.end) / 2);
      const GroundPoint whole{far.x_m - near.x_m, far.y_m - near.y_m};
      weigh_area(patch, parallelogram_m2(whole, next_column) / static_cast<float>(band.end - band.begin),
                 columns);
    }
  }

  void place_samples(GroundPatch& patch, GroundPoint near, GroundPoint far) {
    patch.first_sample = static_cast<std::uint32_t>(result_.samples.size());
    patch.sample_count =
        std::max(1U, static_cast<std::uint32_t>(std::ceil(distance(near, far) / params_.step_m - 0.01)));
    for (std::uint32_t k = 0; k < patch.sample_count; ++k)
      result_.samples.push_back(
          between(near, far, (static_cast<float>(k) + 0.5F) / static_cast<float>(patch.sample_count)));
  }

  double depth_m(GroundPoint p) const {
    return camera_.R_BC.col(2).dot(Eigen::Vector3d(p.x_m, p.y_m, 0.0) - camera_.p_BC_m);
  }

  void weigh_pixels(GroundPatch& patch, int columns) const {
    patch.ground_weight = 1.0F / static_cast<float>(patch.sample_count);
    patch.obstacle_weight = 1.0F;
    patch.max_obstacle_px = static_cast<float>(columns * ground_.height_px());
  }

  /// pixel_m2: ground that one pixel shows.
  void weigh_area(GroundPatch& patch, float pixel_m2, int columns) const {
    const Eigen::Vector3d p_BP_m(patch.contact.x_m, patch.contact.y_m, 0.0);
    const double depth = depth_m(patch.contact);
    const double face_m2 =
        depth * depth / (camera_.fx_px * camera_.fy_px);  // of a pixel, upright at the contact
    const double per_m2 = std::min(1.0, params_.sure_range_m / p_BP_m.norm()) / (cell_m_ * cell_m_);
    patch.ground_weight = static_cast<float>(pixel_m2 * per_m2 / patch.sample_count);
    patch.obstacle_weight = static_cast<float>(face_m2 * per_m2);
    patch.max_obstacle_px = static_cast<float>(params_.max_obstacle_m * camera_.fy_px / depth * columns);
  }

  const BottomFinderParams& params_;
  const CameraModel& camera_;
  const GroundPlane& ground_;
  double cell_m_;
  int strip_px_;
  GroundPatches result_;
};

}  // namespace

GroundPatches make_ground_patches(const BottomFinderParams& params, const CameraModel& camera,
                                  const GroundPlane& ground, double cell_m) {
  return Builder(params, camera, ground, cell_m).build();
}

}  // namespace hindsight

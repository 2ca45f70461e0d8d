// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Label pictures of scenes on flat ground, and what a bottom finder makes of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "mounted_camera.h"
#include "perception/bottom_finder.h"

namespace hindsight {

constexpr double kCell_m = 0.2;
constexpr auto kGood = TerrainClass::good, kBad = TerrainClass::bad, kLethal = TerrainClass::lethal,
               kUnknown = TerrainClass::unknown;

struct Scene {
  CameraModel camera = mounted_camera();
  std::vector<TerrainClass> labels = std::vector<TerrainClass>(720 * 480, kGood);

  TerrainClass& at(int x, int y) { return labels[static_cast<std::size_t>(y * camera.width_px + x)]; }
  void fill(int x0, int x1, int y0, int y1, TerrainClass label) {
    x0 = std::max(x0, 0), x1 = std::min(x1, camera.width_px);
    for (int y = y0; y < y1; ++y) std::fill(&at(x0, y), &at(x1 - 1, y) + 1, label);
  }
  void sky(TerrainClass label) { fill(0, 720, 0, 87, label); }
  /// A board that stands on the ground at (x, y), square to the vehicle.
  void stand(double x_m, double y_m, double width_m, double height_m, TerrainClass label) {
    const auto foot = camera.project({x_m, y_m, 0}), top = camera.project({x_m, y_m, height_m});
    const double left = camera.project({x_m, y_m + width_m / 2, 0})->x_px,
                 right = camera.project({x_m, y_m - width_m / 2, 0})->x_px;
    fill(int(std::lround(left)), int(std::lround(right)), std::max(0, int(std::lround(top->y_px))),
         int(std::lround(foot->y_px)), label);
  }
};

struct Sum {
  double weight = 0, x_m = 0, y_m = 0;
};

inline Sum sum_of(std::span<const GroundVote> votes, TerrainClass label) {
  Sum sum;
  for (const GroundVote& v : votes) {
    if (v.label != label) continue;
    sum.weight += v.weight;
    sum.x_m += v.weight * v.x_B_m;
    sum.y_m += v.weight * v.y_B_m;
  }
  sum.x_m /= sum.weight;
  sum.y_m /= sum.weight;
  return sum;
}

inline BottomFinder finder(const Scene& scene, const BottomFinderParams& params = {}) {
  return {params, scene.camera, GroundPlane(scene.camera, params.max_range_m), kCell_m};
}

inline BottomFinderParams thesis_finder() {
  BottomFinderParams params;
  params.strip_px = 1;
  params.min_run_px = 1;
  params.min_height_m = 0.0;
  params.ground_resumes_px = 0;
  params.weighting = "pixels";
  return params;
}

}  // namespace hindsight

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The picture cut into patches of equal ground: what the bottom finder looks up instead of single pixels.
//
// Weight of a vote. A 20 cm cell fills thousands of pixels at 1 m and less than one at 20 m. With weighting
// "area", a pixel weighs the surface that it shows, in cells: on the ground the ground's area, on an obstacle
// that of its upright face. So one frame's full look at one cell weighs 1 wherever the cell is, an obstacle's
// face of one cell's width weighs 1 for each cell's side of its height (up to max_obstacle_m: a tree is not a
// stronger reason than a fence), and the grid's thresholds mean "looks". Far rows, deeper than a cell, share
// their weight among the cells behind one another. Beyond sure_range_m the weight falls as 1 / range, since
// aim and labels get worse. With "pixels", every pixel weighs 1, as in the thesis.
#pragma once

#include <cstdint>
#include <vector>

#include "perception/bottom_finder_params.h"
#include "perception/camera_model.h"
#include "perception/ground_plane.h"

namespace hindsight {

/// Rows [begin, end) that are judged together.
struct PatchBand {
  int begin = 0;
  int end = 0;
  int strips_together = 1;  ///< neighbouring strips whose good pixels vote at one place
};

/// The pixels of one strip of columns in one band.
struct GroundPatch {
  std::uint32_t first_sample = 0;  ///< of GroundPatches::samples, where its good pixels vote
  std::uint32_t sample_count = 0;  ///< 0: no ground here
  float ground_weight = 0.0F;      ///< of one good pixel, for each sample
  float obstacle_weight = 0.0F;    ///< of one obstacle pixel of an obstacle that stands here
  float max_obstacle_px = 0.0F;    ///< obstacle pixels that count, of such an obstacle
  float min_lead_px = 0.0F;        ///< by how many there must be more of them than good ones
  /// Of such an obstacle: the near edge, since its lowest row is the first whose middle it covers.
  GroundPoint contact;
};

/// Strips of strip_px columns from left to right, the last one maybe narrower; bands from the bottom of the
/// picture to its top. Const once made.
struct GroundPatches {
  int strips = 0;
  std::vector<PatchBand> bands;
  std::vector<GroundPatch> patches;  ///< band by band
  std::vector<GroundPoint> samples;
  std::vector<std::uint8_t> is_ground;  ///< by patch: sample_count > 0, small enough to walk through

  const GroundPatch& at(int strip, int band) const {
    return patches[static_cast<std::size_t>(band) * static_cast<std::size_t>(strips) +
                   static_cast<std::size_t>(strip)];
  }
};

/// cell_m: side of the grid's cells, the unit of area votes.
GroundPatches make_ground_patches(const BottomFinderParams& params, const CameraModel& camera,
                                  const GroundPlane& ground, double cell_m);

}  // namespace hindsight

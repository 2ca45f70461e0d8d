// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// From a label picture to votes on the ground (thesis 5.1, "bottom finder").
//
// Pixels up to the first obstacle of a column lie on the ground and vote where they are. An obstacle stands
// up, so its upper pixels would project too far away: their weight goes to where its lowest pixels meet the
// ground. What is called lethal but looks lower than min_height_m, seen upright, lies flat: a shadow, or
// specks. It is judged by a cumulative sum up the column, obstacle pixels for, good ones against: where that
// falls to nothing, what began there is given up.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "perception/bottom_finder_params.h"
#include "perception/camera_model.h"
#include "perception/ground_patches.h"
#include "perception/ground_plane.h"
#include "perception/ground_vote.h"
#include "perception/terrain_class.h"

namespace hindsight {

/// Holds the tables of one camera and the buffers of one frame. One thread.
class BottomFinder {
 public:
  /// cell_m: side of the grid's cells, the unit of area votes.
  BottomFinder(const BottomFinderParams& params, const CameraModel& camera, const GroundPlane& ground,
               double cell_m);

  /// labels: row-major, width x height of the camera. The votes stay valid until the next call. No
  /// allocation.
  std::span<const GroundVote> find(std::span<const TerrainClass> labels);

  /// One row a strip of strip_px columns: the lowest row of its nearest obstacle as found last; -1 where
  /// none. For drawing.
  std::span<const float> contact_row_px() const { return contact_row_px_; }
  int strip_px() const { return strip_px_; }

 private:
  struct Counts {
    int good = 0;
    int bad = 0;
    int lethal = 0;
  };
  /// One strip's walk from the bottom to the top.
  struct Walk {
    bool in_obstacle = false;
    int contact_band = 0;
    int bad_px = 0;
    int lethal_px = 0;
    int lead_px = 0;      ///< obstacle pixels less good ones, since the contact
    int good_run_px = 0;  ///< since the last band of obstacle
  };

  void count(std::span<const TerrainClass> labels, const PatchBand& band);
  Counts counts_of(int strip) const;
  int next_strip_seen(int strip) const;
  void walk_band(int band);
  bool is_obstacle(const Walk& walk, const GroundPatch& contact) const;
  int step(int strip, int band, bool is_ground, const Counts& counts);
  void vote_good(const GroundPatch& patch, int pixels);
  void finish_obstacle(int strip);

  BottomFinderParams params_;
  int width_px_;
  int strip_px_;
  GroundPatches patches_;
  std::vector<std::uint8_t> column_good_, column_bad_, column_lethal_;  ///< of one band
  std::vector<std::uint8_t> column_seen_;                               ///< not 0 where one of these is not
  std::vector<Walk> walks_;                                             ///< by strip
  std::vector<float> contact_row_px_;
  std::vector<GroundVote> votes_;
};

}  // namespace hindsight

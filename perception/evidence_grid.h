// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// What is known of the ground around the robot, in cells of 20 x 20 cm with three costs (thesis 5.1, 5.2.4).
//
// A cell holds votes for good, bad and lethal, max_evidence in all. Each frame's votes are first limited to
// max_frame_weight; where there is no room for them, the older votes are scaled down. So old evidence fades
// only as new comes in: a cell out of view keeps its cost, and a cell in view forgets what it was within a
// few times max_evidence / (weight of a frame) frames. The cost follows the shares of the votes with
// hysteresis. Touch and slip are marked beside the votes, and outweigh them until enough good votes wear a
// mark off (never, where its strength is infinite).
//
// Storage is a torus: world cell (i, j) lives in slot (i mod N, j mod N), so that moving the window moves
// nothing.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "config/params.h"
#include "perception/evidence_grid_geometry.h"
#include "perception/ground_vote.h"
#include "perception/pose.h"
#include "perception/terrain_class.h"

namespace hindsight {

struct EvidenceGridParams {
  int size_cells = 500;
  double resolution_m = 0.2;
  double margin_m = 30.0;
  double max_evidence = 8.0;
  double max_frame_weight = 2.0;
  double min_evidence = 0.5;
  double enter_share = 0.5;
  double leave_share = 0.35;

  void visit(auto&& param) {
    param("size_cells", size_cells, Range{16, 4000}, "side of the rolling window [cells]");
    param("resolution_m", resolution_m, Range{0.02, 5.0}, "side of a cell [m]");
    param("margin_m", margin_m, Range{0.0, 1000.0},
          "the window moves when the robot comes this close to its border [m]");
    param("max_evidence", max_evidence, Range{0.1, 1e9},
          "votes that a cell holds at most; more votes push out older ones");
    param("max_frame_weight", max_frame_weight, Range{0.01, 1e9}, "votes that one frame may add to a cell");
    param("min_evidence", min_evidence, Range{0.0, 1e9}, "votes that a cell needs to have a cost at all");
    param("enter_share", enter_share, Range{0.0, 1.0},
          "share of obstacle votes from which a cell costs more");
    param("leave_share", leave_share, Range{0.0, 1.0},
          "share of obstacle votes below which a cell costs less again");
  }
};

/// The votes and the mark of one cell, for pictures and telemetry.
struct CellEvidence {
  std::array<float, kLabelCount> votes{};  ///< good, bad, lethal
  CellCost mark = CellCost::none;
  float mark_strength = 0.0F;
};

/// One thread. Nothing allocates after construction.
class EvidenceGrid {
 public:
  static constexpr float kForever = std::numeric_limits<float>::infinity();

  /// Throws FatalError(78) where margin_m leaves no room or limits contradict each other.
  explicit EvidenceGrid(const EvidenceGridParams& params);

  const GridWindow& window() const { return window_; }
  /// X_WB: finite. Centres the window on the robot if the robot is within the margin of its border. True if
  /// it moved: cells that came in are empty, changes() is empty, and consumers start afresh from
  /// copy_costs().
  bool recentre(const Pose2& X_WB);

  /// Adds to the votes of the present frame; settle() makes them count. Outside of the window, and for
  /// `unknown`: ignored.
  void vote(Cell cell, TerrainClass label, float weight);
  /// The same for votes in B, seen from X_WB.
  void vote(std::span<const GroundVote> votes, const Pose2& X_WB);
  /// Ends a frame: its votes become evidence, costs follow.
  void settle();

  /// What another sensor says, at once. high or lethal: the cell costs at least that until good votes of
  /// `strength` in all have come (kForever: as long as it is in the window). none: that many good votes, for
  /// driven-over ground.
  void mark(Cell cell, CellCost cost, float strength);

  /// none outside of the window.
  CellCost cost(Cell cell) const;
  CellEvidence evidence(Cell cell) const;
  /// Every cell whose cost changed since clear_changes(), once, with its present cost, in order of first
  /// change.
  std::span<const CellChange> changes() const { return changes_; }
  void clear_changes();
  /// All costs, row-major as GridWindow::index. The span has size_cells * size_cells elements.
  void copy_costs(std::span<CellCost> row_major_of_window) const;

 private:
  static constexpr std::int32_t kUnchanged = -1;
  struct Slot {
    std::array<float, kLabelCount> votes{};  ///< evidence so far
    std::array<float, kLabelCount> frame{};  ///< votes of the present frame
    float mark_strength = 0.0F;
    std::int32_t change = kUnchanged;  ///< index in changes_
    CellCost mark = CellCost::none;
    bool touched = false;  ///< in touched_
  };

  std::size_t slot_of(Cell inside) const {
    return slot_at(inside.i - window_.origin.i, inside.j - window_.origin.j);
  }
  std::size_t slot_at(int column, int row) const;
  void add_to_frame(std::size_t slot, TerrainClass label, float weight);
  void settle_slot(std::size_t slot);
  void add_votes(Slot& slot, const std::array<float, kLabelCount>& votes) const;
  void update_cost(std::size_t slot);
  CellCost cost_from_votes(const Slot& slot, CellCost present) const;
  Cell cell_of(std::size_t slot) const;
  void move_to(Cell origin);

  EvidenceGridParams params_;
  GridWindow window_;
  int torus_i_ = 0;  ///< window_.origin.i mod N
  int torus_j_ = 0;
  std::vector<Slot> slots_;
  std::vector<CellCost> costs_;  ///< by slot
  std::vector<std::uint32_t> touched_;
  std::vector<CellChange> changes_;
};

}  // namespace hindsight

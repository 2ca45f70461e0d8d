// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Coarse grids of reverse optical flow, one per pair of consecutive frames, and the traceback through them
// (thesis 2.3).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "config/params.h"
#include "perception/flow_vector.h"

namespace hindsight {

/// The thesis: 12 x 8 cells, depth 200, vectors up to 60 px, mean, zero, cell. A finer grid is better only
/// with empty cells filled: without, most of them would be empty.
struct FlowHistoryParams {
  int columns = 40;
  int rows = 26;
  int depth = 200;
  double max_vector_px = 100.0;
  std::string statistic = "median";
  std::string fill = "neighbours";
  std::string lookup = "bilinear";

  void visit(auto&& param) {
    param("columns", columns, Range{1, 128}, "cells of the flow grid across the image");
    param("rows", rows, Range{1, 128}, "cells of the flow grid down the image");
    param("depth", depth, Range{1, 2000}, "frame pairs kept");
    param("max_vector_px", max_vector_px, Range{1.0, 1000.0}, "longer vectors are dropped as outliers [px]");
    param("statistic", statistic, Choices{"mean", "median"}, "what a cell makes of its vectors");
    param("fill", fill, Choices{"zero", "neighbours"}, "what a cell without vectors holds");
    param("lookup", lookup, Choices{"cell", "bilinear"}, "how the flow at a point is read from the grid");
  }
};

/// What one cell of the flow grid holds.
struct FlowCell {
  float dx_px = 0.0F;  ///< add to a point of frame t to get its place in frame t-1
  float dy_px = 0.0F;
  int count = 0;  ///< vectors that it was made from; 0: filled as FlowHistoryParams::fill says
};

/// The flow grid of one frame pair, row-major, cells of equal size over the whole image.
struct FlowGrid {
  int columns = 0;
  int rows = 0;
  float cell_width_px = 0.0F;
  float cell_height_px = 0.0F;
  std::vector<FlowCell> cells;

  const FlowCell& at(int column, int row) const {
    return cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                 static_cast<std::size_t>(column)];
  }
};

/// Ring buffer of flow grids. No allocation after construction. Not thread-safe.
class FlowHistory {
 public:
  /// `max_vectors`: the most that one push brings.
  FlowHistory(const FlowHistoryParams& params, int width_px, int height_px, int max_vectors = 20000);

  /// Takes the flow from the newest frame t to t-1; call it once for each consecutive pair of frames. An
  /// empty span is a frame pair without flow (every cell is filled).
  void push(std::span<const FlowVector> flow_t_to_t_minus_1);

  /// Forgets everything: the stream of images was interrupted.
  void clear();

  /// Frame pairs held, 0 to depth.
  int size() const { return size_; }

  /// Where a traced point came from.
  struct Trace {
    Point2f point_px;  ///< in the frame `frames_back` before the newest
    int frames_back = 0;
    bool entered_here = false;  ///< one step further back it would lie outside the image
  };

  /// Follows a point of the frame `from_frames_back` before the newest back over up to `max_frames` frames;
  /// stops early where the point entered the view, or at the oldest frame held. A start outside the image, or
  /// older than what is held, comes back as it is.
  Trace trace_back(Point2f from_px, int max_frames, int from_frames_back = 0) const;

  /// The grid of the last push (all zero before the first).
  const FlowGrid& newest() const { return newest_; }

 private:
  void average_cells(std::span<const FlowVector> flow);
  void fill_from_neighbours();
  void store_newest();
  Point2f flow_at(Point2f at_px, int frames_back) const;
  bool inside(Point2f p) const;

  FlowHistoryParams params_;
  int width_px_;
  int height_px_;
  bool use_median_;
  bool fill_neighbours_;
  bool interpolate_;
  FlowGrid newest_;
  std::size_t cell_count_;
  std::vector<int>
      first_in_cell_;  ///< where each cell's vectors begin in dx_ and dy_, and where the last ends
  std::vector<int> cell_of_vector_;   ///< -1: dropped
  std::vector<float> dx_px_, dy_px_;  ///< vectors, sorted by cell
  std::vector<std::uint8_t> filled_, filled_next_;
  std::vector<Point2f> ring_;  ///< grids of vectors, `cell_count_` each
  int newest_slot_ = 0;
  int size_ = 0;
};

}  // namespace hindsight

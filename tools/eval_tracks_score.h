// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// How well tracks follow what moves: the thesis' counts (3.3.2), and MOTA and IDF1 as they are used today.
#pragma once

#include <map>
#include <opencv2/core/types.hpp>
#include <optional>
#include <span>
#include <vector>

#include "perception/object_tracker.h"
#include "tools/eval_tracks_truth.h"

namespace hindsight::tools {

struct TrackFigures {
  int frames = 0;
  // From the second second on, of all labelled objects: they must have been in view for a while to be found.
  std::optional<double> recall;  ///< none: nothing was labelled
  int id_switches = 0;           ///< an object's track has another number than when it was last found
  double false_tracks_per_100_frames = 0.0;  ///< numbers that were never over an object
  std::optional<double> mean_error_px;       ///< from the box's middle
  // Complete truth only. All frames count.
  int tp = 0;  ///< objects found, over all frames
  int tn = 0;  ///< frames in which nothing moved and nothing was told
  int fp = 0;  ///< tracks over no object, or over one that has a track already
  int fn = 0;  ///< objects not found
  double accuracy() const { return objects() == 0 ? 0.0 : static_cast<double>(tp - fp) / objects(); }
  double mota() const {
    return objects() == 0 ? 0.0 : 1.0 - static_cast<double>(fn + fp + id_switches) / objects();
  }
  double idf1 = 0.0;
  int objects() const { return tp + fn; }
};

/// Bernardin and Stiefelhagen 2008 (MOTA); Ristani et al. 2016 (IDF1). A track is over an object where a
/// circle of 5 px about it, as the thesis drew it, touches the box. An object keeps the track that it had;
/// others go to the nearest.
class TrackScore {
 public:
  /// `settle_frames`: recall counts from there on.
  TrackScore(const TrackTruth& truth, int settle_frames);

  /// The next frame's tracks. Frames beyond the truth are not judged.
  void add(std::span<const Track> tracks);
  TrackFigures figures() const;

 private:
  void match(std::span<const Track> tracks, std::span<const TrueBox> boxes);

  const TrackTruth& truth_;
  int settle_frames_;
  TrackFigures sums_;
  int judged_ = 0, found_ = 0;
  double error_px_ = 0.0;
  int told_ = 0;                      ///< tracks over all frames, those over boxes that do not count left out
  std::map<int, int> last_track_of_;  ///< by the object's id
  std::map<int, bool> over_something_;           ///< by the track's number
  std::map<std::pair<int, int>, int> together_;  ///< frames of an object and a track
};

/// The largest sum of `values` (rows by columns) that takes each row and each column at most once.
double best_assignment(const std::vector<std::vector<double>>& values);

}  // namespace hindsight::tools

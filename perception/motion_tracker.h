// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// From flow to tracks, a frame at a time (thesis 3.1).
#pragma once

#include <array>
#include <span>
#include <vector>

#include "perception/ego_motion.h"
#include "perception/flow_vector.h"
#include "perception/motion_chains.h"
#include "perception/motion_clusters.h"
#include "perception/motion_parallax.h"
#include "perception/object_tracker.h"

namespace hindsight {

struct MotionParams {
  bool enabled = false;
  EgoMotionParams ego;
  ParallaxParams parallax;
  int gap_frames = 0;
  int longest_gap_frames = 3;
  double chain_reach_px = 2.0;
  double kernel_part = 0.05;
  ObjectTrackerParams tracker;
  ParticleFilterParams filter;
  int seed = 1;

  void visit(auto&& param) {
    param("enabled", enabled, YesNo{}, "find and track what moves by itself");
    ego.visit(param);
    parallax.visit(param);
    param("gap_frames", gap_frames, Range{0, 6},
          "compare frames so far apart; 0: as residuals and parallax allow");
    param("longest_gap_frames", longest_gap_frames, Range{1, 6}, "largest gap that 0 chooses");
    param("chain_reach_px", chain_reach_px, Range{0.0, 8.0},
          "a vector is continued by that of a corner so near to its end [px]");
    param("kernel_part", kernel_part, Range{0.005, 1.0},
          "mean-shift kernel, in parts of the frame's width and height");
    tracker.visit(param);
    filter.visit(param);
    param("seed", seed, Range{0, 2147483647}, "of the particles' noise");
  }
};

/// What one frame showed of motion.
struct MotionReport {
  EgoMotion ego;                            ///< over one frame
  EgoMotion compared;                       ///< over the gap
  std::size_t parallax_features = 0;        ///< that would seem to move but for parallax
  int gap_frames = 0;                       ///< 0: nothing could be compared
  std::span<const MovingFeature> features;  ///< those that rather move than not
  std::span<const MotionCluster> clusters;
  std::span<const Track> tracks;
};

/// Deterministic, no allocation in the steady state, one thread at a time.
class MotionTracker {
 public:
  MotionTracker(const MotionParams& params, int width_px, int height_px, std::size_t max_vectors);

  /// The flow from the newest frame to the one before. A frame without flow, or one whose motion cannot be
  /// told, ends all tracks: nothing is known to be where it was.
  const MotionReport& update(std::span<const FlowVector> flow, const MotionPrior* prior = nullptr);
  /// Forgets the last frame: the stream of images was interrupted.
  void reset();

  const MotionReport& report() const { return report_; }
  const ObjectTracker& objects() const { return objects_; }

 private:
  void compare();
  EgoMotion compare_over(int gap);
  int survey_gaps();
  int choose_gap(int longest) const;
  void collect_features(int gap);
  void return_to_one_frame();
  bool stands_out(const PointPair& pair, const EgoMotion& motion) const;
  void add_features(const EgoMotion& motion, int gap);

  MotionParams params_;
  int width_px_;
  FlowChains chains_;
  EgoMotionEstimator estimator_;
  ParallaxLayer parallax_;
  MotionClusters clusters_;
  ObjectTracker objects_;
  std::span<const PointPair> pairs_;  ///< of the gap last compared over
  std::vector<float> p_moving_;       ///< and what came of it
  std::vector<float> p_moving_over_one_;
  std::vector<bool> followed_;  ///< over the gap, by chain
  std::vector<MovingFeature> features_;
  std::vector<int> cluster_of_;
  std::array<double, FlowChains::kLongest + 1>
      residual_px_{};  ///< of each gap, smoothed over time; 0: not known
  MotionReport report_;
};

}  // namespace hindsight

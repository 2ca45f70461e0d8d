// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Many particle filters, one for each moving object: spawned, confirmed, merged, found again and killed.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "config/params.h"
#include "perception/motion_clusters.h"
#include "perception/motion_feature.h"
#include "perception/particle_filter.h"

namespace hindsight {

struct ObjectTrackerParams {
  int max_tracks = 32;
  double spawn_distance_px = 20.0;
  double spawn_mass = 2.5;
  int confirm_frames = 3;
  double confirm_travel_px = 4.0;
  double merge_distance_px = 8.0;
  double kill_weight = 40.0;
  int dwell_frames = 15;
  int coast_frames = 8;
  int forget_frames = 30;

  void visit(auto&& param) {
    param("max_tracks", max_tracks, Range{1, 200}, "objects tracked at a time");
    param("spawn_distance_px", spawn_distance_px, Range{0.0, 500.0},
          "a peak of motion with a filter so near gets none of its own [px]");
    param("spawn_mass", spawn_mass, Range{0.0, 1000.0}, "sum of p(c = 1) that a peak needs for a filter");
    param("confirm_frames", confirm_frames, Range{0, 100},
          "frames that a new object must be seen in before it is told");
    param("confirm_travel_px", confirm_travel_px, Range{0.0, 100.0},
          "way over the ground that it must have made by then [px]");
    param("merge_distance_px", merge_distance_px, Range{0.0, 500.0},
          "filters that move alike so near one another are one [px]");
    param("kill_weight", kill_weight, Range{0.0, 1e6},
          "an object whose particles' weights sum to less is not seen in this frame");
    param("dwell_frames", dwell_frames, Range{1, 1000},
          "an object that has not got off its place for so long is not told; a new one is given up");
    param("coast_frames", coast_frames, Range{0, 1000}, "an unseen object is told for so long");
    param("forget_frames", forget_frames, Range{0, 1000}, "and found again under its old number for so long");
  }
};

/// A tracked object, in the newest frame.
struct Track {
  std::int32_t id = 0;  ///< from 1, never used twice
  Point2f at_px;
  Point2f v_px;          ///< over the ground [px/frame]
  Point2f half_size_px;  ///< of what moves with it
  int age_frames = 0;
  int unseen_frames = 0;
  double support = 0.0;  ///< sum of the particles' weights

  bool covers(Point2f p) const {
    return std::abs(p.x_px - at_px.x_px) <= half_size_px.x_px &&
           std::abs(p.y_px - at_px.y_px) <= half_size_px.y_px;
  }
};

/// Deterministic for its seed, no allocation in the steady state, one thread at a time.
class ObjectTracker {
 public:
  ObjectTracker(const ObjectTrackerParams& params, const ParticleFilterParams& filter, std::uint64_t seed,
                int width_px, int height_px);

  /// One frame on. H_now_then takes points of the frame before to this one; `prior` may be null. Returns the
  /// confirmed objects in the order of their numbers, valid until the next call.
  std::span<const Track> update(const Eigen::Matrix3d& H_now_then, std::span<const MovingFeature> features,
                                std::span<const MotionCluster> clusters, std::span<const int> cluster_of,
                                const MotionPrior* prior);
  /// The view was interrupted: nothing is where it was.
  void clear();

  std::span<const Track> tracks() const { return told_; }
  /// Every particle of the confirmed objects, for drawing.
  std::span<const ParticleFilter::Particle> particles(std::size_t i) const {
    return objects_[shown_[i]].filter.particles();
  }

 private:
  struct Object {
    explicit Object(const ParticleFilterParams& params) : filter(params, 0) {}
    ParticleFilter filter;
    Track track;
    Point2f place_px;          ///< where it was when it last got off its place, carried along with the ground
    int dwell_frames = 0;      ///< frames since then
    Point2f flown_px;          ///< and the way that its features' motion since then sums up to
    Point2f home_px;           ///< where it was when it last got away from home, carried along likewise
    int home_frames = 0;       ///< frames since then
    Point2f mean_v_px;         ///< of what its features showed of late,
    float mean_v2_px2 = 0.0F;  ///< and of its square
    Point2f last_seen_px;
    int seen_frames = 0;
    bool alive = false;
    bool confirmed = false;
    int cluster = -1;
    /// Of its motion, 0 to 1: mean velocity over root mean square.
    float steadiness() const;
  };

  void predict(const Eigen::Matrix3d& H_now_then, const MotionPrior* prior);
  void assign(std::span<const MovingFeature> features, std::span<const int> cluster_of);
  void weigh(std::span<const MovingFeature> features, const MotionPrior* prior);
  void look_at_own(Object& object);
  static void remember(Object& object, Point2f v_px);
  void judge(Object& object, double demand);
  void merge();
  bool one_thing(const Object& a, const Object& b) const;
  static bool keep_together(const Object& a, const Object& b);
  bool may_be_other_end(const Object& object) const;
  void spawn(std::span<const MotionCluster> clusters, const MotionPrior* prior);
  bool claimed(std::size_t cluster, const MotionCluster& peak) const;
  Object* lost_near(const MotionCluster& peak);
  void tell();
  bool inside(Point2f p) const;

  ObjectTrackerParams params_;
  cv::RNG random_;
  int width_px_, height_px_;
  std::vector<Object> objects_;
  std::vector<int> owner_;  ///< of each feature; -1: none
  std::vector<MovingFeature> owned_;
  std::vector<Track> told_;
  std::vector<std::size_t> shown_;
  std::int32_t next_id_ = 1;
};

}  // namespace hindsight

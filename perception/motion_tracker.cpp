// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/motion_tracker.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace hindsight {
namespace {

constexpr double kSmoothing = 0.1;
/// A larger gap must pay by so much: it follows fewer features, and what they show is older.
constexpr double kGain = 1.25;
constexpr double kFewestShare = 0.3;  ///< of the features that one frame back has
constexpr float kStandsOut = 6.0F;    ///< deviations of a static feature

}  // namespace

MotionTracker::MotionTracker(const MotionParams& params, int width_px, int height_px, std::size_t max_vectors)
    : params_(params),
      width_px_(width_px),
      chains_(width_px, height_px, params.chain_reach_px, max_vectors),
      estimator_(params.ego, max_vectors),
      parallax_(params.parallax),
      clusters_(params.kernel_part * width_px, params.kernel_part * height_px, max_vectors),
      objects_(params.tracker, params.filter, static_cast<std::uint64_t>(params.seed), width_px, height_px) {
  p_moving_.reserve(max_vectors), features_.reserve(max_vectors), cluster_of_.reserve(max_vectors);
  p_moving_over_one_.reserve(max_vectors), followed_.reserve(max_vectors);
}

void MotionTracker::reset() {
  chains_.clear();
  objects_.clear();
  residual_px_.fill(0.0);
  report_ = {};
}

const MotionReport& MotionTracker::update(std::span<const FlowVector> flow, const MotionPrior* prior) {
  chains_.push(flow);
  compare();
  if (!report_.ego.valid) {
    reset();
    return report_;
  }
  report_.clusters = clusters_.find(features_);
  cluster_of_.clear();
  for (std::size_t i = 0; i < features_.size(); ++i) cluster_of_.push_back(clusters_.cluster_of(i));
  report_.features = features_;
  report_.tracks =
      objects_.update(report_.ego.H_then_now.inverse(), features_, report_.clusters, cluster_of_, prior);
  return report_;
}

/// Ego-motion over one frame carries what is known along; over the gap chosen it says what moves.
void MotionTracker::compare() {
  features_.clear();
  report_.gap_frames = 0;
  report_.ego = compare_over(1);
  if (!report_.ego.valid) return;
  p_moving_over_one_ = p_moving_;
  const int gap = params_.gap_frames > 0 ? params_.gap_frames : choose_gap(survey_gaps());
  report_.compared = gap > 1 ? compare_over(gap) : report_.ego;
  if (!report_.compared.valid) return;
  report_.gap_frames = gap;
  collect_features(gap);
}

EgoMotion MotionTracker::compare_over(int gap) {
  pairs_ = chains_.pairs(gap);
  p_moving_.resize(pairs_.size());
  return estimator_.estimate(pairs_, p_moving_);
}

/// Learns the residuals of all gaps that enough features can be followed over; returns the longest of these.
int MotionTracker::survey_gaps() {
  const double fewest = kFewestShare * static_cast<double>(pairs_.size());
  EgoMotion motion = report_.ego;
  for (int gap = 1;; ++gap) {
    double& known = residual_px_[static_cast<std::size_t>(gap)];
    known = known == 0.0 ? motion.residual_px : known + kSmoothing * (motion.residual_px - known);
    if (gap == params_.longest_gap_frames) return gap;
    motion = compare_over(gap + 1);
    if (!motion.valid || static_cast<double>(pairs_.size()) < fewest) return gap;
  }
}

/// What moves shows g times as far over g frames. Noise of the tracking stays as it is, so that a larger gap
/// is better; parallax grows as fast, so that it is not.
int MotionTracker::choose_gap(int longest) const {
  const double least_px = params_.ego.min_noise_px / params_.ego.noise_factor;
  const auto worth = [&](int gap) {
    return gap / std::max(least_px, residual_px_[static_cast<std::size_t>(gap)]);
  };
  int best = 1;
  for (int gap = 2; gap <= longest; ++gap) {
    if (worth(gap) > std::pow(kGain, gap - best) * worth(best)) best = gap;
  }
  return best;
}

/// The survey of gaps has overwritten it.
void MotionTracker::return_to_one_frame() {
  pairs_ = chains_.pairs(1);
  p_moving_ = p_moving_over_one_;
}

/// What has come into view within the gap, as fast things have all the time, is compared over one frame.
void MotionTracker::collect_features(int gap) {
  if (gap == 1) return_to_one_frame();
  report_.parallax_features = parallax_.excuse(pairs_, report_.compared, width_px_, p_moving_);
  add_features(report_.compared, gap);
  if (gap == 1) return;
  followed_.assign(chains_.size(), false);
  for (std::size_t i = 0; i < pairs_.size(); ++i) followed_[chains_.index_of(i)] = true;
  return_to_one_frame();
  parallax_.excuse(pairs_, report_.ego, width_px_, p_moving_);
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (followed_[chains_.index_of(i)] || !stands_out(pairs_[i], report_.ego)) p_moving_[i] = 0.0F;
  }
  add_features(report_.ego, 1);
}

/// One frame's flow of a corner that was not seen before is easily wrong: its motion must be beyond errors of
/// the flow, and beyond what parallax could be.
bool MotionTracker::stands_out(const PointPair& pair, const EgoMotion& motion) const {
  const Point2f on_plane = transformed(motion.H_then_now, pair.now_px);
  const auto parallax_px =
      static_cast<float>(params_.parallax.parallax_part) * distance_px(on_plane, pair.now_px);
  return distance_px(on_plane, pair.then_px) > parallax_px + kStandsOut * static_cast<float>(motion.noise_px);
}

void MotionTracker::add_features(const EgoMotion& motion, int gap) {
  const Eigen::Matrix3d H_now_then = motion.H_then_now.inverse();
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (p_moving_[i] < 0.5F) continue;
    const Point2f expected = transformed(H_now_then, pairs_[i].then_px), now = pairs_[i].now_px;
    const auto frames = static_cast<float>(gap);
    features_.push_back(
        {now, {(now.x_px - expected.x_px) / frames, (now.y_px - expected.y_px) / frames}, p_moving_[i]});
  }
}

}  // namespace hindsight

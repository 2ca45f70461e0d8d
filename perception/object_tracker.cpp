// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/object_tracker.h"

#include <algorithm>
#include <cmath>

#include "perception/ego_motion.h"
#include "perception/motion_demand.h"
#include "perception/motion_likeness.h"

namespace hindsight {
namespace {

constexpr float kSizeSmoothing = 0.2F;
/// Half the side of a uniform square over its mean absolute deviation.
constexpr float kSizeFromDeviation = 2.0F;
constexpr float kSmallestHalf_px = 4.0F;
constexpr double kOffItsPlace = 0.4;  ///< way that takes an object off its own place, in parts of its size
constexpr float kSteadyFrames = 15.0F;
constexpr float kSteadyNew = 0.85F, kSteady = 0.4F;  ///< see Object::steadiness()
constexpr int kUnseenNew = 2;  ///< frames that an object not yet confirmed may be unseen for
/// What has not got so far, or its own size, away from home in so many frames sways there.
constexpr int kHomeFrames = 30;
constexpr double kTravelsFromHome = 3.0;  ///< in ways that an object makes before it is told
constexpr double kStraightness = 0.4;     ///< way made over way that its speed promises

}  // namespace

ObjectTracker::ObjectTracker(const ObjectTrackerParams& params, const ParticleFilterParams& filter,
                             std::uint64_t seed, int width_px, int height_px)
    : params_(params), random_(seed), width_px_(width_px), height_px_(height_px) {
  objects_.reserve(static_cast<std::size_t>(params.max_tracks));
  for (int i = 0; i < params.max_tracks; ++i) objects_.emplace_back(filter);
  told_.reserve(objects_.size()), shown_.reserve(objects_.size());
}

void ObjectTracker::clear() {
  for (Object& object : objects_) object.alive = false;
  told_.clear(), shown_.clear();
}

std::span<const Track> ObjectTracker::update(const Eigen::Matrix3d& H_now_then,
                                             std::span<const MovingFeature> features,
                                             std::span<const MotionCluster> clusters,
                                             std::span<const int> cluster_of, const MotionPrior* prior) {
  predict(H_now_then, prior);
  assign(features, cluster_of);
  weigh(features, prior);
  merge();
  spawn(clusters, prior);
  tell();
  return told_;
}

bool ObjectTracker::inside(Point2f p) const {
  return p.x_px >= 0.0F && p.y_px >= 0.0F && p.x_px < static_cast<float>(width_px_) &&
         p.y_px < static_cast<float>(height_px_);
}

void ObjectTracker::predict(const Eigen::Matrix3d& H_now_then, const MotionPrior* prior) {
  for (Object& object : objects_) {
    if (!object.alive) continue;
    object.filter.predict(H_now_then, prior);
    object.place_px = transformed(H_now_then, object.place_px);
    object.home_px = transformed(H_now_then, object.home_px);
    object.last_seen_px = transformed(H_now_then, object.last_seen_px);
    object.track.at_px = object.filter.at_px(), object.track.v_px = object.filter.v_px();
    object.alive = inside(object.track.at_px);
  }
}

/// Each feature belongs to one object at most: the nearest of those that it may belong to. So two people side
/// by side do not pull each other's particles over.
void ObjectTracker::assign(std::span<const MovingFeature> features, std::span<const int> cluster_of) {
  const auto near_px = static_cast<float>(params_.spawn_distance_px);
  for (Object& object : objects_) {
    object.cluster = -1;
    if (!object.alive) continue;
    float nearest_px = link_reach_px(near_px, object.track.v_px);

    for (std::size_t i = 0; i < features.size(); ++i) {
      const float d = distance_px(features[i].at_px, object.track.at_px);
      if (d >= nearest_px || !roughly_alike(features[i].v_px, object.track.v_px)) continue;
      nearest_px = d, object.cluster = cluster_of[i];
    }
  }
  owner_.assign(features.size(), -1);
  for (std::size_t i = 0; i < features.size(); ++i) {
    float nearest_px = INFINITY;
    for (std::size_t k = 0; k < objects_.size(); ++k) {
      const Object& object = objects_[k];
      if (!object.alive) continue;
      const float d = distance_px(features[i].at_px, object.track.at_px);
      if (d >= nearest_px) continue;
      if (d > link_reach_px(near_px, object.track.v_px) && object.cluster != cluster_of[i]) continue;
      nearest_px = d, owner_[i] = static_cast<int>(k);
    }
  }
}

/// Some particles go to the middle of what the object owns and move as that does: it may have turned.
void ObjectTracker::look_at_own(Object& object) {
  Point2f at{}, v{};
  float mass = 0.0F;
  for (const MovingFeature& f : owned_) {
    at.x_px += f.probability * f.at_px.x_px, at.y_px += f.probability * f.at_px.y_px;
    v.x_px += f.probability * f.v_px.x_px, v.y_px += f.probability * f.v_px.y_px;
    mass += f.probability;
  }
  if (mass <= 0.0F) return;
  v = {v.x_px / mass, v.y_px / mass};
  object.filter.look_at({at.x_px / mass, at.y_px / mass}, v);
  remember(object, v);
}

void ObjectTracker::remember(Object& object, Point2f v_px) {
  const float share = std::max(1.0F / kSteadyFrames, 1.0F / static_cast<float>(object.seen_frames + 1));
  object.mean_v_px.x_px += share * (v_px.x_px - object.mean_v_px.x_px);
  object.mean_v_px.y_px += share * (v_px.y_px - object.mean_v_px.y_px);
  object.mean_v2_px2 += share * (v_px.x_px * v_px.x_px + v_px.y_px * v_px.y_px - object.mean_v2_px2);
  object.flown_px.x_px += v_px.x_px, object.flown_px.y_px += v_px.y_px;
}

void ObjectTracker::weigh(std::span<const MovingFeature> features, const MotionPrior* prior) {
  for (std::size_t k = 0; k < objects_.size(); ++k) {
    Object& object = objects_[k];
    if (!object.alive) continue;
    owned_.clear();
    for (std::size_t i = 0; i < features.size(); ++i) {
      if (owner_[i] == static_cast<int>(k)) owned_.push_back(features[i]);
    }
    Track& track = object.track;
    ++track.age_frames;
    const double half_px = 0.25F * (track.half_size_px.x_px + track.half_size_px.y_px);
    look_at_own(object);
    track.support =
        object.filter.weigh(owned_, half_px, prior) * static_cast<double>(object.filter.particles().size());
    const bool seen = !owned_.empty() && track.support >= params_.kill_weight;
    track.unseen_frames = seen ? 0 : track.unseen_frames + 1;
    if (seen) {
      object.filter.resample();
      ++object.seen_frames;
      track.at_px = object.last_seen_px = object.filter.at_px();
      track.v_px = object.filter.v_px();
      Point2f deviation{};
      for (const MovingFeature& f : owned_) {
        deviation.x_px += std::abs(f.at_px.x_px - track.at_px.x_px) / static_cast<float>(owned_.size());
        deviation.y_px += std::abs(f.at_px.y_px - track.at_px.y_px) / static_cast<float>(owned_.size());
      }
      const auto smooth = [](float& half, float value) {
        half += kSizeSmoothing * (std::max(kSmallestHalf_px, kSizeFromDeviation * value) - half);
      };
      smooth(track.half_size_px.x_px, deviation.x_px), smooth(track.half_size_px.y_px, deviation.y_px);
    }
    judge(object, motion_demand(prior, track.at_px, track.v_px));
  }
}

float ObjectTracker::Object::steadiness() const {
  return mean_v2_px2 > 0.0F ? std::hypot(mean_v_px.x_px, mean_v_px.y_px) / std::sqrt(mean_v2_px2) : 0.0F;
}

/// Errors of the flow point anywhere, and are gone in the next frame. What covers and uncovers the ground, or
/// stands above it, seems to move, to and fro with the camera, but stays: on its place or, if its swings take
/// it off that, about its home. What moves keeps on, and gets off its place, by both measures of its way:
/// features that are found now at one end of a roof and now at the other make the place jump, but do not fly
/// there.
void ObjectTracker::judge(Object& object, double demand) {
  const Track& track = object.track;
  const double way_px = std::min(distance_px(track.at_px, object.place_px),
                                 std::hypot(object.flown_px.x_px, object.flown_px.y_px));
  const double size_px = track.half_size_px.x_px + track.half_size_px.y_px;
  const bool off_its_place =
      track.unseen_frames == 0 && way_px >= (object.confirmed ? 1.0 : demand) *
                                                std::max(params_.confirm_travel_px, kOffItsPlace * size_px);
  ++object.dwell_frames;
  if (!object.confirmed) {
    const long frames =
        may_be_other_end(object) ? kFramesToTellApart : std::lround(demand * params_.confirm_frames);
    const double promised_px =
        std::hypot(track.v_px.x_px, track.v_px.y_px) * static_cast<float>(track.age_frames);
    object.confirmed = off_its_place && object.seen_frames >= frames &&
                       way_px >= kStraightness * promised_px && object.steadiness() >= kSteadyNew;
    object.alive = object.confirmed ||
                   (track.unseen_frames <= kUnseenNew && object.dwell_frames <= params_.dwell_frames);
  }
  if (object.confirmed && off_its_place && object.steadiness() >= kSteady) {
    object.place_px = track.at_px, object.dwell_frames = 0, object.flown_px = {};
  }
  ++object.home_frames;
  if (distance_px(track.at_px, object.home_px) >=
      std::max(kTravelsFromHome * params_.confirm_travel_px, size_px))
    object.home_px = track.at_px, object.home_frames = 0;
  if (track.unseen_frames > params_.forget_frames) object.alive = false;
}

void ObjectTracker::spawn(std::span<const MotionCluster> clusters, const MotionPrior* prior) {
  for (std::size_t c = 0; c < clusters.size(); ++c) {
    const MotionCluster& peak = clusters[c];
    if (peak.mass < params_.spawn_mass * motion_demand(prior, peak.at_px, peak.v_px) || claimed(c, peak))
      continue;
    Object* object = lost_near(peak);
    const bool is_new = object == nullptr;
    if (is_new) {
      const auto free =
          std::find_if(objects_.begin(), objects_.end(), [](const Object& o) { return !o.alive; });
      if (free == objects_.end()) return;
      object = &*free;
      object->alive = true, object->confirmed = false;
      object->seen_frames = object->dwell_frames = 0;
      object->mean_v_px = {}, object->mean_v2_px2 = 0.0F;
      object->track = {};
      object->track.id = next_id_++;
      object->track.half_size_px = {kSmallestHalf_px, kSmallestHalf_px};
    }
    object->filter.start(peak.at_px, peak.v_px, cv::RNG(random_.next()));
    object->cluster = static_cast<int>(c);
    object->place_px = peak.at_px;  // having been found again elsewhere is no way made
    object->flown_px = {};
    object->track.at_px = object->last_seen_px = object->filter.at_px();
    object->track.v_px = object->filter.v_px();
    object->track.unseen_frames = 0;
    if (!is_new) continue;
    // The flow followed it here: it was there, and seen, a frame before.
    object->place_px = {peak.at_px.x_px - peak.v_px.x_px, peak.at_px.y_px - peak.v_px.y_px};
    object->home_px = object->place_px, object->home_frames = 0;
    remember(*object, peak.v_px);
    object->seen_frames = object->track.age_frames = 1;
  }
}

void ObjectTracker::tell() {
  told_.clear(), shown_.clear();
  for (std::size_t k = 0; k < objects_.size(); ++k) {
    const Object& object = objects_[k];
    if (!object.alive || !object.confirmed || object.track.unseen_frames > params_.coast_frames) continue;
    // Where it is by now can be foretold only of what moved steadily.
    const bool foretold = object.track.unseen_frames == 0 || object.steadiness() >= kSteadyNew;
    const bool stays = object.dwell_frames > params_.dwell_frames || object.home_frames > kHomeFrames;
    if (foretold && !stays) shown_.push_back(k);
  }
  std::sort(shown_.begin(), shown_.end(),
            [this](std::size_t a, std::size_t b) { return objects_[a].track.id < objects_[b].track.id; });
  for (const std::size_t k : shown_) told_.push_back(objects_[k].track);
}

}  // namespace hindsight

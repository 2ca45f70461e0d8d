// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Who is who: which objects are one, which peak is one of them, or one that was lost.
#include <algorithm>
#include <cmath>

#include "perception/motion_likeness.h"
#include "perception/object_tracker.h"

namespace hindsight {
namespace {

/// A track may turn round while unseen, but not be anywhere.
constexpr float kReachOfLost = 1.5F;

}  // namespace

/// The younger of two that coincide ends.
void ObjectTracker::merge() {
  for (Object& a : objects_) {
    for (Object& b : objects_) {
      if (&a == &b || !a.alive || !b.alive || a.track.id > b.track.id || a.track.unseen_frames > 0) continue;
      if (one_thing(a, b)) b.alive = false;
    }
  }
}

bool ObjectTracker::one_thing(const Object& a, const Object& b) const {
  const Track &one = a.track, &other = b.track;
  if (!roughly_alike(one.v_px, other.v_px)) return false;
  const float apart_px = distance_px(one.at_px, other.at_px);
  const float reach_px = link_reach_px(static_cast<float>(params_.merge_distance_px), one.v_px);
  const bool linked = a.cluster >= 0 && a.cluster == b.cluster;
  return apart_px < (linked ? 2.0F : 1.0F) * reach_px || one.covers(other.at_px) ||
         (rigidly_alike(one.v_px, other.v_px) && apart_px < longest_px(one.v_px)) || keep_together(a, b);
}

/// Two ends of a slow vehicle lie farther apart, but over many frames their velocities are more alike than
/// those of two that follow one another.
bool ObjectTracker::keep_together(const Object& a, const Object& b) {
  const Point2f from = a.track.at_px, to = b.track.at_px;
  const float speed_px = std::sqrt(a.mean_v2_px2);
  return std::min(a.seen_frames, b.seen_frames) >= kFramesToTellApart &&
         distance_px(from, to) < longest_slow_px({speed_px, 0.0F}) &&
         (alike_on_average(a.mean_v_px, b.mean_v_px) ||
          turn_together(a.mean_v_px, b.mean_v_px, speed_px, std::sqrt(b.mean_v2_px2),
                        {to.x_px - from.x_px, to.y_px - from.y_px}));
}

/// Of something told, seen too short to be told apart from it?
bool ObjectTracker::may_be_other_end(const Object& object) const {
  const Track& track = object.track;
  const float reach_px = longest_slow_px(track.v_px);
  return std::any_of(objects_.begin(), objects_.end(), [&](const Object& other) {
    return &other != &object && other.alive && other.confirmed && other.track.unseen_frames == 0 &&
           roughly_alike(other.track.v_px, track.v_px) &&
           distance_px(other.track.at_px, track.at_px) < reach_px;
  });
}

/// Has this peak an object that is seen: one that it is linked to, or near, or the other end of?
bool ObjectTracker::claimed(std::size_t cluster, const MotionCluster& peak) const {
  return std::any_of(objects_.begin(), objects_.end(), [&](const Object& object) {
    const Track& track = object.track;
    if (!object.alive || track.unseen_frames > 0) return false;
    const float apart_px = distance_px(track.at_px, peak.at_px);
    return object.cluster == static_cast<int>(cluster) ||
           apart_px < static_cast<float>(params_.spawn_distance_px) ||
           (object.confirmed && roughly_alike(track.v_px, peak.v_px) && apart_px < longest_px(peak.v_px));
  });
}

/// A confirmed object that was lost where this peak is, or where it would be by now.
ObjectTracker::Object* ObjectTracker::lost_near(const MotionCluster& peak) {
  Object* best = nullptr;
  float nearest_px = kReachOfLost * static_cast<float>(params_.spawn_distance_px);
  for (Object& object : objects_) {
    if (!object.alive || object.track.unseen_frames == 0) continue;
    const float d =
        std::min(distance_px(object.track.at_px, peak.at_px), distance_px(object.last_seen_px, peak.at_px));
    if (d < nearest_px) best = &object, nearest_px = d;
  }
  return best;
}

}  // namespace hindsight

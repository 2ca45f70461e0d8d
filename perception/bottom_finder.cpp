// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/bottom_finder.h"

#include <algorithm>
#include <cstring>

#include "perception/multiversion.h"

namespace hindsight {
namespace {

constexpr float kNoContact = -1.0F;

/// Adds one to a column's counter where its label is `label` or `also`.
HINDSIGHT_MULTIVERSION
void count_row(const TerrainClass* labels, std::size_t width, TerrainClass label, TerrainClass also,
               std::uint8_t* __restrict counters) {
  for (std::size_t x = 0; x < width; ++x)
    counters[x] = static_cast<std::uint8_t>(counters[x] + ((labels[x] == label) | (labels[x] == also)));
}

/// out[x] is not 0 where any of the counters is not.
HINDSIGHT_MULTIVERSION
void join_counters(const std::uint8_t* a, const std::uint8_t* b, const std::uint8_t* c, std::size_t width,
                   std::uint8_t* __restrict out) {
  for (std::size_t x = 0; x < width; ++x) out[x] = a[x] | b[x] | c[x];
}

}  // namespace

BottomFinder::BottomFinder(const BottomFinderParams& params, const CameraModel& camera,
                           const GroundPlane& ground, double cell_m)
    : params_(params),
      width_px_(camera.width_px),
      strip_px_(params.strip_px),
      patches_(make_ground_patches(params, camera, ground, cell_m)) {
  const auto strips = static_cast<std::size_t>(patches_.strips);
  for (auto* counter : {&column_good_, &column_bad_, &column_lethal_, &column_seen_})
    counter->resize(strips * static_cast<std::size_t>(strip_px_), 0);
  walks_.resize(strips);
  contact_row_px_.resize(strips, kNoContact);
  votes_.reserve(patches_.samples.size() + 2 * patches_.patches.size());
}

std::span<const GroundVote> BottomFinder::find(std::span<const TerrainClass> labels) {
  votes_.clear();
  std::fill(walks_.begin(), walks_.end(), Walk{});
  std::fill(contact_row_px_.begin(), contact_row_px_.end(), kNoContact);
  for (int band = 0; band < static_cast<int>(patches_.bands.size()); ++band) {
    count(labels, patches_.bands[static_cast<std::size_t>(band)]);
    walk_band(band);
  }
  for (int strip = 0; strip < patches_.strips; ++strip) finish_obstacle(strip);
  return votes_;
}

/// How many pixels of each class each column has in a band.
void BottomFinder::count(std::span<const TerrainClass> labels, const PatchBand& band) {
  const auto width = static_cast<std::size_t>(width_px_);
  for (auto* counter : {&column_good_, &column_bad_, &column_lethal_})
    std::fill(counter->begin(), counter->end(), std::uint8_t{0});
  const auto good_also = params_.unknown == "good" ? TerrainClass::unknown : TerrainClass::good;
  const auto bad_also = params_.unknown == "bad" ? TerrainClass::unknown : TerrainClass::bad;
  for (int row = band.begin; row < band.end; ++row) {
    const TerrainClass* const label = labels.data() + static_cast<std::size_t>(row) * width;
    count_row(label, width, TerrainClass::good, good_also, column_good_.data());
    count_row(label, width, TerrainClass::bad, bad_also, column_bad_.data());
    count_row(label, width, TerrainClass::lethal, TerrainClass::lethal, column_lethal_.data());
  }
  join_counters(column_good_.data(), column_bad_.data(), column_lethal_.data(), width, column_seen_.data());
}

/// Pixels of each class that a strip has in the band counted last.
inline BottomFinder::Counts BottomFinder::counts_of(int strip) const {
  Counts counts;
  const std::size_t begin = static_cast<std::size_t>(strip * strip_px_);
  for (std::size_t x = begin; x < begin + static_cast<std::size_t>(strip_px_); ++x)
    counts.good += column_good_[x], counts.bad += column_bad_[x], counts.lethal += column_lethal_[x];
  return counts;
}

/// The first strip from `strip` on that has pixels of a class in the band counted last; strips_ where none
/// has.
inline int BottomFinder::next_strip_seen(int strip) const {
  const std::uint8_t* const seen = column_seen_.data();
  std::size_t x = static_cast<std::size_t>(strip * strip_px_);
  for (std::uint64_t eight; x + sizeof eight <= column_seen_.size(); x += sizeof eight) {
    std::memcpy(&eight, seen + x, sizeof eight);
    if (eight != 0) break;
  }
  while (x < column_seen_.size() && seen[x] == 0) ++x;
  return static_cast<int>(x) / strip_px_;
}

/// All strips go up by one band. Good pixels of neighbouring strips vote together where the ground between
/// them is less than step_m, which spares most votes of the near field.
void BottomFinder::walk_band(int band) {
  const GroundPatch* const patch = &patches_.at(0, band);
  const std::uint8_t* const is_ground =
      &patches_.is_ground[static_cast<std::size_t>(patch - patches_.patches.data())];
  const int most_together = patches_.bands[static_cast<std::size_t>(band)].strips_together,
            strips = patches_.strips;
  for (int strip = next_strip_seen(0); strip < strips;) {
    const int begin = strip / most_together * most_together, end = std::min(begin + most_together, strips);
    int good_px = 0;
    for (; strip < end; strip = next_strip_seen(strip + 1))
      good_px += step(strip, band, is_ground[strip] != 0, counts_of(strip));
    if (good_px > 0) vote_good(patch[end - 1 - (end - begin) / 2], good_px);
  }
}

/// Whether what the walk has met is an obstacle. What the bumper touched stands up; bad ground, which slips,
/// does not have to.
inline bool BottomFinder::is_obstacle(const Walk& walk, const GroundPatch& contact) const {
  if (walk.bad_px + walk.lethal_px < params_.min_run_px * strip_px_) return false;
  return walk.bad_px > walk.lethal_px || static_cast<float>(walk.lead_px) >= contact.min_lead_px;
}

/// One strip goes up by one band. Returns its good pixels that lie on the ground here.
inline int BottomFinder::step(int strip, int band, bool is_ground, const Counts& counts) {
  Walk& walk = walks_[static_cast<std::size_t>(strip)];
  const int obstacle_px = counts.bad + counts.lethal;
  const bool obstacle_here = obstacle_px > 0 && obstacle_px >= counts.good;

  if (!walk.in_obstacle) {
    const int good_px = is_ground ? counts.good : 0;
    const bool first = walk.bad_px + walk.lethal_px == 0;
    if (first && !(obstacle_here && is_ground)) return good_px;  // else: sky, or ground too far to tell
    if (first) walk.contact_band = band;
    walk.bad_px += counts.bad;
    walk.lethal_px += counts.lethal;
    walk.lead_px += obstacle_px - counts.good;
    walk.in_obstacle = is_obstacle(walk, patches_.at(strip, walk.contact_band));
    if (walk.lead_px < 0) walk = {};
    return good_px;
  }
  walk.bad_px += counts.bad;
  walk.lethal_px += counts.lethal;
  walk.good_run_px = obstacle_here ? 0 : walk.good_run_px + counts.good;
  if (params_.ground_resumes_px > 0 && walk.good_run_px >= params_.ground_resumes_px * strip_px_)
    finish_obstacle(strip);
  return 0;
}

void BottomFinder::vote_good(const GroundPatch& patch, int pixels) {
  const float weight = patch.ground_weight * static_cast<float>(pixels);
  for (std::uint32_t k = patch.first_sample; k < patch.first_sample + patch.sample_count; ++k)
    votes_.push_back({patches_.samples[k].x_m, patches_.samples[k].y_m, weight, TerrainClass::good});
}

/// The weight of the obstacle that a strip has walked over goes to where it meets the ground.
void BottomFinder::finish_obstacle(int strip) {
  Walk& walk = walks_[static_cast<std::size_t>(strip)];
  if (walk.in_obstacle) {
    const GroundPatch& contact = patches_.at(strip, walk.contact_band);
    const float pixels = static_cast<float>(walk.bad_px + walk.lethal_px);
    const float weight = contact.obstacle_weight * std::min(1.0F, contact.max_obstacle_px / pixels);
    const auto cast = [&](int px, TerrainClass label) {
      if (px > 0)
        votes_.push_back({contact.contact.x_m, contact.contact.y_m, weight * static_cast<float>(px), label});
    };
    cast(walk.bad_px, TerrainClass::bad);
    cast(walk.lethal_px, TerrainClass::lethal);
    float& row = contact_row_px_[static_cast<std::size_t>(strip)];
    if (row == kNoContact)
      row = static_cast<float>(patches_.bands[static_cast<std::size_t>(walk.contact_band)].end - 1);
  }
  walk = {};
}

}  // namespace hindsight

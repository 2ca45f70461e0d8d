// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/activity_registration.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace hindsight {
namespace {

using Complex = std::complex<double>;

/// What a cell of the picture that is compared holds.
struct Motion {
  double much = 0.0;
  Complex once, twice;  ///< Fourier coefficients of the directions, times `much`
};

double energy_of(const Motion& m) { return m.much * m.much + std::norm(m.once) + std::norm(m.twice); }

struct Place {
  Eigen::Vector2d p;
  Motion motion;
  double energy = 0.0;
};

/// A cell that was in view for less says nothing by what does not move in it.
constexpr std::uint32_t kLookedAtFrames = 20;

/// One level: places with motion, a picture to look them up in, and where the map looked.
class Level {
 public:
  Level(const ActivityMap& map, int merged) : cell_(map.cell() * merged), side_(map.cells() / merged + 2) {
    std::vector<Motion> raw(static_cast<std::size_t>(side_ * side_));
    for (std::size_t i = 0; i < map.active().size(); ++i) {
      const auto& cell = map.active()[i];
      Motion& m = raw[index((cell.column) / merged, (cell.row) / merged)];
      const auto counts = map.counts(i);
      for (std::size_t bin = 0; bin < ActivityMap::kBins; ++bin) {
        if (counts[bin] == 0) continue;
        const double angle = ActivityMap::direction_of_bin(static_cast<int>(bin % ActivityMap::kDirections));
        m.much += counts[bin];
        m.once += static_cast<double>(counts[bin]) * std::polar(1.0, angle);
        m.twice += static_cast<double>(counts[bin]) * std::polar(1.0, 2.0 * angle);
      }
    }
    picture_.resize(raw.size());
    for (int row = 0; row < side_; ++row) {
      for (int column = 0; column < side_; ++column) {
        const Motion& m = raw[index(column, row)];
        if (m.much == 0.0) continue;
        const double much = std::log1p(m.much), scale = much / m.much;
        const Motion place{much, m.once * scale, m.twice * scale};
        picture_[index(column, row)] = place;
        places_.push_back({middle(column, row, map), place, energy_of(place)});
        energy_ += places_.back().energy;
      }
    }
    origin_ = middle(0, 0, map);
    mark_looked_at(map, merged);
  }

  std::span<const Place> places() const { return places_; }
  double energy() const { return energy_; }
  double cell() const { return cell_; }

  bool looked_at(const Eigen::Vector2d& p) const {
    if (looked_at_.empty()) return true;
    const int column = static_cast<int>(std::lround((p.x() - origin_.x()) / cell_)),
              row = static_cast<int>(std::lround((p.y() - origin_.y()) / cell_));
    return column >= 0 && row >= 0 && column < side_ && row < side_ && looked_at_[index(column, row)];
  }

  /// Bilinear; nothing outside.
  Motion at(const Eigen::Vector2d& p) const {
    const double x = (p.x() - origin_.x()) / cell_, y = (p.y() - origin_.y()) / cell_;
    const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
    Motion sum;
    if (column < 0 || row < 0 || column + 1 >= side_ || row + 1 >= side_) return sum;
    const double u = x - column, v = y - row;
    for (int k = 0; k < 4; ++k) {
      const double w = (k % 2 == 0 ? 1 - u : u) * (k / 2 == 0 ? 1 - v : v);
      const Motion& m = picture_[index(column + k % 2, row + k / 2)];
      sum.much += w * m.much, sum.once += w * m.once, sum.twice += w * m.twice;
    }
    return sum;
  }

 private:
  std::size_t index(int column, int row) const { return static_cast<std::size_t>(row * side_ + column); }
  Eigen::Vector2d middle(int column, int row, const ActivityMap& map) const {
    const double half = map.cells() / 2 * map.cell();
    return {(column + 0.5) * cell_ - half, (row + 0.5) * cell_ - half};
  }
  /// A map that never noted where it looked (a template) looked everywhere.
  void mark_looked_at(const ActivityMap& map, int merged) {
    if (std::ranges::all_of(map.exposures(), [](std::uint32_t frames) { return frames == 0; })) return;
    looked_at_.resize(picture_.size());
    for (int row = 0; row < map.cells(); ++row) {
      for (int column = 0; column < map.cells(); ++column) {
        if (map.exposure(column, row) >= kLookedAtFrames)
          looked_at_[index(column / merged, row / merged)] = true;
      }
    }
  }

  double cell_;
  int side_;
  std::vector<Motion> picture_;
  std::vector<Place> places_;
  std::vector<bool> looked_at_;  ///< empty: everywhere
  double energy_ = 0.0;
  Eigen::Vector2d origin_;
};

/// Of the energy of each map, what must lie where the other looked for the likeness to count in full: two
/// maps that only touch are alike by chance.
constexpr double kEnoughShared = 0.5;

/// Normalised correlation over what both maps looked at: what one flight did not have in view tells nothing
/// against a place that it fits otherwise.
double likeness(const Level& a, const Level& b, double angle_rad, const Eigen::Vector2d& t) {
  Eigen::Matrix2d R;
  R << std::cos(angle_rad), -std::sin(angle_rad), std::sin(angle_rad), std::cos(angle_rad);
  const Complex turn = std::polar(1.0, angle_rad), turn2 = turn * turn;
  double sum = 0.0, energy_a = 0.0, energy_b = 0.0;
  for (const Place& place : b.places()) {
    const Eigen::Vector2d p_A = R * place.p + t;
    if (!a.looked_at(p_A)) continue;
    energy_b += place.energy;
    const Motion there = a.at(p_A);
    if (there.much == 0.0) continue;
    sum += there.much * place.motion.much + (std::conj(there.once) * turn * place.motion.once).real() +
           (std::conj(there.twice) * turn2 * place.motion.twice).real();
  }
  for (const Place& place : a.places()) {
    if (b.looked_at(R.transpose() * (place.p - t))) energy_a += place.energy;
  }
  if (energy_a == 0.0 || energy_b == 0.0) return 0.0;
  const double shared = std::min(energy_a / a.energy(), energy_b / b.energy());
  return std::min(1.0, shared / kEnoughShared) * sum / std::sqrt(energy_a * energy_b);
}

void keep_best(std::vector<ActivityAlignment>& all, std::size_t most) {
  const auto better = [](const ActivityAlignment& x, const ActivityAlignment& y) {
    return x.likeness > y.likeness;
  };
  const auto end = all.begin() + static_cast<std::ptrdiff_t>(std::min(most, all.size()));
  std::partial_sort(all.begin(), end, all.end(), better);
  all.erase(end, all.end());
}

/// Middle and reach of where anything moves.
void extent(const Level& level, Eigen::Vector2d& middle, double& reach) {
  Eigen::Vector2d low = level.places().front().p, high = low;
  for (const Place& place : level.places()) low = low.cwiseMin(place.p), high = high.cwiseMax(place.p);
  middle = 0.5 * (low + high), reach = 0.5 * (high - low).norm();
}

/// The best few of each angle: where a place is alike from several sides, one side's many neighbours would
/// leave no room for the others.
std::vector<ActivityAlignment> search_all(const Level& a, const Level& b) {
  Eigen::Vector2d middle_a, middle_b;
  double reach_a = 0.0, reach_b = 0.0;
  extent(a, middle_a, reach_a), extent(b, middle_b, reach_b);
  const int steps = static_cast<int>(std::ceil(0.8 * std::max(reach_a, reach_b) / a.cell()));
  std::vector<ActivityAlignment> found, at_angle;
  constexpr int kAngles = 36;
  constexpr std::size_t kBestOfAngle = 3;
  for (int k = 0; k < kAngles; ++k) {
    const double angle = 2.0 * M_PI * k / kAngles, c = std::cos(angle), s = std::sin(angle);
    const Eigen::Vector2d base =
        middle_a - Eigen::Vector2d(c * middle_b.x() - s * middle_b.y(), s * middle_b.x() + c * middle_b.y());
    at_angle.clear();
    for (int y = -steps; y <= steps; ++y) {
      for (int x = -steps; x <= steps; ++x) {
        const Eigen::Vector2d t = base + a.cell() * Eigen::Vector2d(x, y);
        at_angle.push_back({angle, t, likeness(a, b, angle, t)});
      }
    }
    keep_best(at_angle, kBestOfAngle);
    found.insert(found.end(), at_angle.begin(), at_angle.end());
  }
  return found;
}

/// Around each candidate, turned about the middle of B so that angle and translation do not depend on each
/// other.
std::vector<ActivityAlignment> refine(const Level& a, const Level& b,
                                      std::span<const ActivityAlignment> candidates, double angle_step,
                                      double step) {
  Eigen::Vector2d middle;
  double reach = 0.0;
  extent(b, middle, reach);
  const auto turned = [&](double angle) -> Eigen::Vector2d {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * middle.x() - s * middle.y(), s * middle.x() + c * middle.y()};
  };
  std::vector<ActivityAlignment> found;
  for (const ActivityAlignment& candidate : candidates) {
    for (int k = -2; k <= 2; ++k) {
      const double angle = candidate.angle_rad + k * angle_step;
      const Eigen::Vector2d base = candidate.t + turned(candidate.angle_rad) - turned(angle);
      for (int y = -2; y <= 2; ++y) {
        for (int x = -2; x <= 2; ++x) {
          const Eigen::Vector2d t = base + step * Eigen::Vector2d(x, y);
          found.push_back({angle, t, likeness(a, b, angle, t)});
        }
      }
    }
  }
  return found;
}

void add_line(ActivityMap& map, const Eigen::Vector2d& from, const Eigen::Vector2d& to, double speed) {
  const Eigen::Vector2d way = to - from;
  const double step = 0.25 * map.cell();
  const int steps = static_cast<int>(way.norm() / step);
  for (int i = 0; i < steps; ++i) map.add(from + way * (i + 0.5) / steps, speed * way.normalized());
}

Eigen::Vector2d polar(double r, double angle) { return {r * std::cos(angle), r * std::sin(angle)}; }

/// Four arms, two lanes each, from `mouth` to `reach`.
ActivityMap arms(const ActivityMapParams& params, double mouth, double reach, double lane, double speed) {
  ActivityMap map(params);
  for (int k = 0; k < 4; ++k) {
    const double arm = 0.5 * M_PI * k;
    // y points down in a picture: right of the way is then +90 degrees.
    const Eigen::Vector2d right_in = polar(lane, arm - 0.5 * M_PI), right_out = polar(lane, arm + 0.5 * M_PI);
    add_line(map, polar(reach, arm) + right_in, polar(mouth, arm) + right_in, speed);
    add_line(map, polar(mouth, arm) + right_out, polar(reach, arm) + right_out, speed);
  }
  return map;
}

}  // namespace

ActivityAlignment register_activity(const ActivityMap& a, const ActivityMap& b) {
  if (a.active().empty() || b.active().empty()) return {};
  const Level a4(a, 4), b4(b, 4), a2(a, 2), b2(b, 2), a1(a, 1), b1(b, 1);
  std::vector<ActivityAlignment> found = search_all(a4, b4);
  constexpr double kDegree = M_PI / 180.0;
  found = refine(a2, b2, found, 3.0 * kDegree, 1.0 * a2.cell());
  keep_best(found, 20);
  found = refine(a1, b1, found, 1.0 * kDegree, 1.0 * a1.cell());
  keep_best(found, 6);
  found = refine(a1, b1, found, 0.4 * kDegree, 0.3 * a1.cell());
  keep_best(found, 1);
  return found.front();
}

ActivityMap crossroads_template(const ActivityMapParams& params, double reach, double lane, double speed) {
  ActivityMap map = arms(params, 0.0, reach, lane, speed);
  return map;
}

ActivityMap roundabout_template(const ActivityMapParams& params, double reach, double lane, double speed,
                                double ring) {
  ActivityMap map = arms(params, ring + lane, reach, lane, speed);
  constexpr int kSides = 48;
  for (int i = 0; i < kSides; ++i) {
    // Counter-clockwise as seen, y down.
    add_line(map, polar(ring, -2.0 * M_PI * i / kSides), polar(ring, -2.0 * M_PI * (i + 1) / kSides), speed);
  }
  return map;
}

}  // namespace hindsight

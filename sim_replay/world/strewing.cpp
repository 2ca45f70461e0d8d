// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/world/strewing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "config/exit_code.h"

namespace hindsight {
namespace {

constexpr int kDrawings = 2000;

}  // namespace

int Strewing::count(const StrewnParams& params) const {
  const double length_m = course_.course.length_m + course_.course.beyond_m - params.from_m;
  return static_cast<int>(std::lround(params.per_m2 * std::max(0.0, length_m) * course_.course.width_m));
}

WorldPoint Strewing::place(const StrewnParams& params, double radius_m, const char* section, Random& random) {
  const CourseParams& strip = course_.course;
  for (int i = 0; i < kDrawings; ++i) {
    const double x_m = random.uniform(params.from_m, strip.length_m + strip.beyond_m);
    const WorldPoint p = lane_.at(x_m, random.uniform(-0.5, 0.5) * strip.width_m);
    if (!has_room(p, radius_m, params)) continue;
    add({p, p, radius_m, 0.0, TruthLabel::ground, false});
    return p;
  }
  throw FatalError(kExitConfiguration,
                   fmt::format("{}: [{}]: no room for {} of them with {} m between them; expected fewer, or "
                               "less spacing or clearing",
                               course_.file, section, count(params), params.spacing_m));
}

bool Strewing::has_room(WorldPoint p, double radius_m, const StrewnParams& params) const {
  const double clearing_m = course_.start.clearing_m + radius_m;
  const WorldPoint goal = lane_.at(course_.course.length_m, course_.goal.aside_m);
  if (std::hypot(p.x_m, p.y_m) < clearing_m) return false;
  if (std::hypot(p.x_m - goal.x_m, p.y_m - goal.y_m) < clearing_m) return false;
  if (params.lane_clearing_m > 0.0 && lane_.distance_m(p) < params.lane_clearing_m + radius_m) return false;
  return std::none_of(standing_.begin(), standing_.end(), [&](const Obstacle& other) {
    return distance_m(other, p) < radius_m + params.spacing_m;
  });
}

}  // namespace hindsight

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/aerial_world.h"

#include <algorithm>
#include <cmath>

#include "sim_replay/world/random.h"

namespace hindsight::tools {
namespace {

constexpr double kLane_m = 1.8, kRing_m = 8.0, kMouth_m = 11.0, kStep_m = 0.5;

cv::Point2d polar(double r_m, double angle_rad) {
  return {r_m * std::cos(angle_rad), r_m * std::sin(angle_rad)};
}

/// On the arm's lane that leads in or out (right-hand traffic), r from the middle.
cv::Point2d on_lane(double arm_rad, double r_m, bool inward) {
  return polar(r_m, arm_rad) + polar(kLane_m, arm_rad + (inward ? 0.5 : -0.5) * CV_PI);
}

void measure(AerialRoute& route) {
  route.length_m = {0.0};
  for (std::size_t i = 1; i < route.points_m.size(); ++i) {
    route.length_m.push_back(route.length_m.back() + cv::norm(route.points_m[i] - route.points_m[i - 1]));
  }
}

void add_arc(std::vector<cv::Point2d>& points, double from_rad, double to_rad) {
  while (to_rad < from_rad + 0.1) to_rad += 2.0 * CV_PI;  // counter-clockwise
  const int steps = std::max(2, static_cast<int>((to_rad - from_rad) * kRing_m / kStep_m));
  for (int i = 0; i <= steps; ++i)
    points.push_back(polar(kRing_m, from_rad + (to_rad - from_rad) * i / steps));
}

void add_curve(std::vector<cv::Point2d>& points, cv::Point2d from, cv::Point2d to) {
  const int steps = static_cast<int>(2.0 * kMouth_m / kStep_m);
  for (int i = 0; i <= steps; ++i) {
    const double u = static_cast<double>(i) / steps;
    points.push_back((1 - u) * (1 - u) * from + u * u * to);  // by way of the middle
  }
}

AerialRoute drive(const AerialWorld& world, double in_rad, double out_rad) {
  AerialRoute route{.points_m = {}, .length_m = {}, .kind = MoverKind::car};
  route.points_m.push_back(on_lane(in_rad, AerialWorld::kHalf_m, true));
  route.points_m.push_back(on_lane(in_rad, kMouth_m, true));
  if (world.roundabout) {
    add_arc(route.points_m, in_rad + 0.35, out_rad - 0.35);
  } else {
    add_curve(route.points_m, on_lane(in_rad, kMouth_m, true), on_lane(out_rad, kMouth_m, false));
  }
  route.points_m.push_back(on_lane(out_rad, kMouth_m, false));
  route.points_m.push_back(on_lane(out_rad, AerialWorld::kHalf_m, false));
  measure(route);
  return route;
}

void add_walks(AerialWorld& world, Random& random) {
  for (int i = 0; i < 3; ++i) {
    const double from = random.uniform(0.0, 2.0 * CV_PI), to = from + random.uniform(0.7, 1.3) * CV_PI;
    const cv::Point2d bend = polar(random.uniform(0.0, 12.0), random.uniform(0.0, 2.0 * CV_PI));
    AerialRoute forth{
        .points_m = {}, .length_m = {}, .kind = i == 2 ? MoverKind::cyclist : MoverKind::person};
    constexpr int kSteps = 120;
    for (int k = 0; k <= kSteps; ++k) {
      const double u = static_cast<double>(k) / kSteps;
      forth.points_m.push_back((1 - u) * (1 - u) * polar(AerialWorld::kHalf_m, from) +
                               2 * u * (1 - u) * bend + u * u * polar(AerialWorld::kHalf_m, to));
    }
    AerialRoute back = forth;
    std::reverse(back.points_m.begin(), back.points_m.end());
    measure(forth), measure(back);
    world.routes.push_back(forth), world.routes.push_back(back);
  }
}

double from_routes_m(const AerialWorld& world, cv::Point2d p, bool roads_only) {
  double least = 1e9;
  for (const AerialRoute& route : world.routes) {
    if (roads_only && route.kind != MoverKind::car) continue;
    for (double s = 0.0; s < route.length_m.back(); s += 1.0)
      least = std::min(least, cv::norm(route.at(s) - p));
  }
  return least;
}

cv::Point2d anywhere(Random& random, double half_m) {
  return {random.uniform(-half_m, half_m), random.uniform(-half_m, half_m)};
}

void add_buildings(AerialWorld& world, Random& random) {
  for (int attempt = 0; attempt < 300 && world.buildings.size() < 5; ++attempt) {
    AerialBuilding b{anywhere(random, 32.0),
                     {random.uniform(5.0, 11.0), random.uniform(5.0, 9.0)},
                     random.uniform(0.0, CV_PI),
                     random.uniform(2.5, 5.0)};
    const double reach_m = 0.5 * std::hypot(b.size_m.width, b.size_m.height);
    const bool apart =
        std::all_of(world.buildings.begin(), world.buildings.end(), [&](const AerialBuilding& o) {
          return cv::norm(o.centre_m - b.centre_m) >
                 reach_m + 0.5 * std::hypot(o.size_m.width, o.size_m.height);
        });
    if (apart && from_routes_m(world, b.centre_m, false) > reach_m + 1.5) world.buildings.push_back(b);
  }
}

void add_trees(AerialWorld& world, Random& random) {
  for (int attempt = 0; attempt < 400 && world.trees.size() < 16; ++attempt) {
    const AerialTree tree{anywhere(random, 34.0), random.uniform(1.2, 2.6), random.uniform(3.5, 6.5)};
    const double clear_m = from_routes_m(world, tree.centre_m, false);
    const bool in_building =
        std::any_of(world.buildings.begin(), world.buildings.end(), [&](const AerialBuilding& b) {
          return cv::norm(b.centre_m - tree.centre_m) < 0.7 * b.size_m.width + tree.radius_m;
        });
    // Some stand so near that their crowns hang over the way.
    if (!in_building && clear_m > (world.trees.size() % 4 == 0 ? 1.0 : 3.0)) world.trees.push_back(tree);
  }
}

void add_parked(AerialWorld& world, Random& random) {
  for (int i = 0; i < 6; ++i) {
    const double arm = world.arms_rad[static_cast<std::size_t>(i) % world.arms_rad.size()];
    const double r = random.uniform(14.0, 30.0);
    const cv::Point2d p = polar(r, arm) + polar(5.2, arm + (random.chance(0.5) ? 0.5 : -0.5) * CV_PI);
    if (from_routes_m(world, p, false) > 2.2) world.parked.emplace_back(p, arm);
  }
}

}  // namespace

cv::Point2d AerialRoute::at(double s_m) const {
  const auto above = std::upper_bound(length_m.begin() + 1, length_m.end() - 1, s_m);
  const auto i = static_cast<std::size_t>(above - length_m.begin());
  const double u = (s_m - length_m[i - 1]) / std::max(1e-9, length_m[i] - length_m[i - 1]);
  return points_m[i - 1] + u * (points_m[i] - points_m[i - 1]);
}

double AerialRoute::heading_rad(double s_m) const {
  const cv::Point2d d = at(s_m + 0.8) - at(s_m - 0.8);
  return std::atan2(d.y, d.x);
}

AerialWorld make_aerial_world(std::uint64_t seed) {
  Random random(seed, 1);
  AerialWorld world;
  world.seed = seed;
  world.roundabout = random.chance(0.5);
  for (int k = 0; k < 4; ++k) world.arms_rad.push_back(0.5 * CV_PI * k + random.uniform(-0.25, 0.25));
  for (const double in : world.arms_rad) {
    for (const double out : world.arms_rad) {
      if (in != out) world.routes.push_back(drive(world, in, out));
    }
  }
  add_walks(world, random);
  add_buildings(world, random);
  add_trees(world, random);
  add_parked(world, random);
  return world;
}

AerialTraffic::AerialTraffic(const AerialWorld& world, std::uint64_t seed, double per_minute, int most,
                             std::optional<MoverKind> only)
    : world_(world) {
  Random random(seed, 2);
  double t_s = 0.0;
  for (int i = 0; i < most; ++i) {
    t_s += -std::log(1.0 - random.uniform(0.0, 1.0)) * 60.0 / per_minute;
    Mover mover;
    do {
      mover.route = static_cast<std::size_t>(random.next() % world.routes.size());
    } while (only && world.routes[mover.route].kind != *only);
    const MoverKind kind = world.routes[mover.route].kind;
    mover.enters_s = t_s;
    mover.speed_mps = kind == MoverKind::car       ? random.uniform(4.0, 7.0)
                      : kind == MoverKind::cyclist ? random.uniform(2.5, 4.5)
                                                   : random.uniform(1.0, 1.8);
    mover.aside_m = kind == MoverKind::car ? random.uniform(-0.2, 0.2) : random.uniform(0.0, 0.8);
    // Who would drive into another waits, so to speak, out of the world.
    while (collides(mover)) mover.enters_s += 1.0;
    movers_.push_back(mover);
  }
}

bool AerialTraffic::collides(const Mover& mover) const {
  constexpr double kStep_s = 0.5, kCars_m = 7.0, kOthers_m = 2.0;
  const AerialRoute& route = world_.routes[mover.route];
  for (double t_s = mover.enters_s; t_s < mover.enters_s + route.length_m.back() / mover.speed_mps;
       t_s += kStep_s) {
    const cv::Point2d p = route.at((t_s - mover.enters_s) * mover.speed_mps);
    for (const Mover& other : movers_) {
      const AerialRoute& its = world_.routes[other.route];
      const double s_m = (t_s - other.enters_s) * other.speed_mps;
      if (s_m < 0.0 || s_m > its.length_m.back()) continue;
      const bool cars = route.kind == MoverKind::car && its.kind == MoverKind::car;
      // Two on foot may walk by each other.
      if (route.kind != MoverKind::car && its.kind != MoverKind::car) continue;
      if (cv::norm(its.at(s_m) - p) < (cars ? kCars_m : kOthers_m)) return true;
    }
  }
  return false;
}

std::vector<MoverState> AerialTraffic::at(double t_s) const {
  std::vector<MoverState> states;
  for (std::size_t i = 0; i < movers_.size(); ++i) {
    const Mover& mover = movers_[i];
    const AerialRoute& route = world_.routes[mover.route];
    const double s_m = (t_s - mover.enters_s) * mover.speed_mps;
    if (s_m < 0.0 || s_m > route.length_m.back()) continue;
    const double heading = route.heading_rad(s_m);
    states.push_back({static_cast<int>(i) + 1, route.kind,
                      route.at(s_m) + polar(mover.aside_m, heading - 0.5 * CV_PI), heading});
  }
  return states;
}

double AerialTraffic::end_s() const {
  double end = 0.0;
  for (const Mover& m : movers_)
    end = std::max(end, m.enters_s + world_.routes[m.route].length_m.back() / m.speed_mps);
  return end;
}

}  // namespace hindsight::tools

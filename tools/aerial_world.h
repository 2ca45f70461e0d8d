// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// A place to look down on: roads that meet at a crossing or a roundabout, footpaths, buildings, trees, parked
// cars, and who moves there when. Plain data, made from a seed. Metres; x east, y north, z up.
#pragma once

#include <cstdint>
#include <opencv2/core/types.hpp>
#include <optional>
#include <utility>
#include <vector>

namespace hindsight::tools {

enum class MoverKind : std::uint8_t { car = 0, person = 1, cyclist = 2 };

/// A way that things take, from one edge of the world to another.
struct AerialRoute {
  std::vector<cv::Point2d> points_m;
  std::vector<double> length_m;  ///< from the start to each point
  MoverKind kind = MoverKind::car;

  cv::Point2d at(double s_m) const;
  double heading_rad(double s_m) const;
};

struct AerialBuilding {
  cv::Point2d centre_m;
  cv::Size2d size_m;
  double turn_rad = 0.0;
  double height_m = 0.0;
};

struct AerialTree {
  cv::Point2d centre_m;
  double radius_m = 0.0;
  double height_m = 0.0;
};

struct AerialWorld {
  static constexpr double kHalf_m = 55.0;
  std::uint64_t seed = 0;
  bool roundabout = false;
  std::vector<AerialRoute> routes;
  std::vector<double> arms_rad;  ///< directions of the roads from the middle
  std::vector<AerialBuilding> buildings;
  std::vector<AerialTree> trees;
  std::vector<std::pair<cv::Point2d, double>> parked;  ///< place and heading of cars that stand
};

AerialWorld make_aerial_world(std::uint64_t seed);

/// Where one thing is that moves.
struct MoverState {
  int id = 0;
  MoverKind kind = MoverKind::car;
  cv::Point2d at_m;
  double heading_rad = 0.0;
};

/// Who comes when: objects enter at random times on random routes, each with a speed and a side of the way of
/// its own.
class AerialTraffic {
 public:
  /// `per_minute` objects enter on average until `most` have; of one kind only, if that is given.
  AerialTraffic(const AerialWorld& world, std::uint64_t seed, double per_minute, int most,
                std::optional<MoverKind> only);

  std::vector<MoverState> at(double t_s) const;
  /// When the last has left the world.
  double end_s() const;

 private:
  struct Mover {
    std::size_t route = 0;
    double enters_s = 0.0;
    double speed_mps = 0.0;
    double aside_m = 0.0;
  };
  bool collides(const Mover& mover) const;
  const AerialWorld& world_;
  std::vector<Mover> movers_;
};

}  // namespace hindsight::tools

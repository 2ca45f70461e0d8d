// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// A world to drive in, as plain data: what stands where, what the ground is, how the light falls. Vehicle and
// renderer share this header and nothing else. Lengths in metres in W (x east, y north, z up); the same
// course and seed give the same world, bit for bit.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace hindsight {

struct WorldPoint {
  double x_m = 0.0;
  double y_m = 0.0;
};

/// What lies on the ground: sets both its look and its grip.
enum class Ground : std::uint8_t {
  grass = 0,
  leaf_litter = 1,
  soil = 2,
  mulch = 3,
  road = 4,
  mud = 5,
  gravel = 6
};
constexpr int kGroundCount = 7;

/// How an object is to be judged; also the label of its pixels. Sky and ground have labels of their own.
enum class TruthLabel : std::uint8_t {
  sky = 0,
  ground = 1,
  tree = 2,
  bush = 3,
  fence = 4,
  road = 5,
  rock = 6
};

/// An upright trunk that carries a crown; rigid.
struct Tree {
  WorldPoint at;
  double radius_m = 0.15;       ///< of the trunk at the height of the bumper
  double height_m = 6.0;        ///< top of the crown
  double crown_base_m = 2.5;    ///< height where leaves begin
  double crown_radius_m = 1.5;  ///< largest
  std::uint32_t look = 0;       ///< seeds what makes it differ from its neighbours
};

/// A round bush on the ground.
struct Bush {
  WorldPoint at;
  double radius_m = 0.5;
  double height_m = 0.7;
  bool drivable = false;  ///< thin enough to be pushed through: presses no bumper, but IR sensors see it
  std::uint32_t look = 0;
};

/// A half-buried boulder; rigid.
struct Rock {
  WorldPoint at;
  double radius_m = 0.3;
  double height_m = 0.3;
  std::uint32_t look = 0;
};

/// Orange plastic mesh between posts; rigid along its whole length.
struct Fence {
  std::vector<WorldPoint> posts;
  double height_m = 1.2;
};

/// A band of other ground along a line.
struct Trail {
  std::vector<WorldPoint> centre;  ///< dense: at most 1 m apart
  double width_m = 1.5;
  double edge_m = 0.3;  ///< over which it fades into what lies beside it
  Ground ground = Ground::mulch;
};

/// A round patch of other ground.
struct GroundSpot {
  WorldPoint at;
  double radius_m = 2.0;
  Ground ground = Ground::mud;
};

/// Height of the ground: a plane, waves of random direction and phase, and a hill or dip along a road.
struct Terrain {
  struct Wave {
    double kx_radpm = 0.0, ky_radpm = 0.0, phase_rad = 0.0, amplitude_m = 0.0;
  };
  double slope_x = 0.0;  ///< rise per metre east
  double slope_y = 0.0;  ///< rise per metre north
  std::vector<Wave> waves;

  double height_m(WorldPoint p) const;
  /// Rise per metre east (x_m) and north (y_m).
  WorldPoint gradient(WorldPoint p) const;
};

struct Light {
  double sun_azimuth_rad = 0.8;  ///< from east, counter-clockwise: where it stands
  double sun_elevation_rad = 0.7;
  double sun_strength = 1.0;    ///< 0: overcast; 1: clear
  double haze_range_m = 250.0;  ///< where 1/e of contrast is left
  double cloud_depth = 0.0;     ///< share of its strength that passing clouds take
};

struct World {
  std::string name;
  std::uint64_t seed = 0;
  WorldPoint start;
  double start_heading_rad = 0.0;  ///< counter-clockwise from east
  WorldPoint goal;
  double half_size_m = 100.0;  ///< the ground is drawn this far around the middle between start and goal
  Ground ground = Ground::grass;
  Terrain terrain;
  Light light;
  std::vector<Tree> trees;
  std::vector<Bush> bushes;
  std::vector<Rock> rocks;
  std::vector<Fence> fences;
  std::vector<Trail> trails;        ///< later ones lie on earlier ones
  std::vector<GroundSpot> patches;  ///< lie on all trails

  /// What lies at a point, edges of trails decided at half their fading.
  Ground ground_at(WorldPoint p) const;
};

/// Position and attitude of the body B in W: heading about z, then pitch (nose down positive), then roll
/// (right side down positive), as the calibration file has the camera's.
struct BodyPose {
  double x_m = 0.0;
  double y_m = 0.0;
  double z_m = 0.0;
  double heading_rad = 0.0;
  double pitch_rad = 0.0;
  double roll_rad = 0.0;
};

}  // namespace hindsight

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// What a course's TOML file may say, section by section. Each section is optional; what is not named has its
// default, which for all objects is "none". The lane is the middle of the trail, where there is one, else the
// straight line east from the origin.
#pragma once

#include <string>
#include <vector>

#include "config/params.h"

namespace hindsight {

inline Choices ground_names() { return {"grass", "leaf_litter", "soil", "mulch", "road", "mud", "gravel"}; }

struct CourseParams {
  std::string name = "unnamed";
  double length_m = 70.0;
  double width_m = 30.0;
  double beyond_m = 15.0;
  std::string ground = "grass";
  double least_gap_m = 1.8;

  void visit(auto&& param) {
    param("name", name, AnyText{}, "for reports");
    param("length_m", length_m, Range{5.0, 2000.0}, "from start to goal, as the crow flies [m]");
    param("width_m", width_m, Range{4.0, 200.0}, "of the strip in which objects stand [m]");
    param("beyond_m", beyond_m, Range{0.0, 100.0}, "how far objects go on behind the goal [m]");
    param("ground", ground, ground_names(), "what lies where nothing else does");
    param("least_gap_m", least_gap_m, Range{0.9, 10.0}, "some way is everywhere at least so wide [m]");
  }
};

struct StartParams {
  double x_m = 0.0;
  double aside_m = 0.0;
  double heading_rad = 0.0;
  double clearing_m = 2.5;

  void visit(auto&& param) {
    param("x_m", x_m, Range{-50.0, 2000.0}, "east of the origin [m]");
    param("aside_m", aside_m, Range{-100.0, 100.0}, "left of the lane [m]");
    param("heading_rad", heading_rad, Range{-3.2, 3.2}, "counter-clockwise from the lane's direction [rad]");
    param("clearing_m", clearing_m, Range{0.0, 50.0},
          "nothing is strewn so near to the lane's start or the goal [m]");
  }
};

struct GoalParams {
  double aside_m = 0.0;

  void visit(auto&& param) { param("aside_m", aside_m, Range{-100.0, 100.0}, "left of the lane's end [m]"); }
};

/// Objects strewn at random over the strip.
struct StrewnParams {
  double per_m2 = 0.0;
  double radius_min_m = 0.0;
  double radius_max_m = 0.0;
  double height_min_m = 0.0;
  double height_max_m = 0.0;
  double spacing_m = 0.5;
  double lane_clearing_m = 0.0;
  double from_m = 4.0;

  void visit(auto&& param) {
    param("per_m2", per_m2, Range{0.0, 1.0}, "how many a square metre of the strip [1/m2]");
    param("radius_min_m", radius_min_m, Range{0.02, 5.0}, "smallest; of trees: of the trunk [m]");
    param("radius_max_m", radius_max_m, Range{0.02, 5.0}, "largest [m]");
    param("height_min_m", height_min_m, Range{0.1, 40.0}, "lowest [m]");
    param("height_max_m", height_max_m, Range{0.1, 40.0}, "highest [m]");
    param("spacing_m", spacing_m, Range{0.0, 20.0}, "least distance to what stands already [m]");
    param("lane_clearing_m", lane_clearing_m, Range{0.0, 50.0},
          "kept free on each side of the lane's middle [m]");
    param("from_m", from_m, Range{-50.0, 2000.0}, "where they begin, east of the origin [m]");
  }
};

struct TreeParams : StrewnParams {
  int in_the_way = 0;
  std::vector<double> at_m;

  TreeParams()
      : StrewnParams{.radius_min_m = 0.08, .radius_max_m = 0.25, .height_min_m = 5.0, .height_max_m = 9.0} {}
  void visit(auto&& param) {
    StrewnParams::visit(param);
    param("in_the_way", in_the_way, Range{0, 100},
          "further ones, at even distances within 0.5 m of the lane");
    param("at_m", at_m, Range{-2000.0, 4000.0}, "further ones at fixed places: x, y, x, y, ... [m]");
  }
};

struct BushParams : StrewnParams {
  double drivable = 0.0;

  BushParams()
      : StrewnParams{.radius_min_m = 0.25, .radius_max_m = 0.6, .height_min_m = 0.5, .height_max_m = 1.0} {}
  void visit(auto&& param) {
    StrewnParams::visit(param);
    param("drivable", drivable, Range{0.0, 1.0}, "share of them that a vehicle can push through");
  }
};

struct RockParams : StrewnParams {
  RockParams()
      : StrewnParams{.radius_min_m = 0.2, .radius_max_m = 0.5, .height_min_m = 0.4, .height_max_m = 0.6} {}
};

struct FenceParams {
  double at_m = 0.0;
  double left_m = 0.0;
  double right_m = 0.0;
  bool either_side = true;
  double post_distance_m = 2.0;
  double height_m = 1.2;

  void visit(auto&& param) {
    param("at_m", at_m, Range{0.0, 2000.0}, "how far from the start it crosses the lane [m]");
    param("left_m", left_m, Range{0.0, 100.0},
          "how far it goes on to the left of the lane; 0 both ways: no fence [m]");
    param("right_m", right_m, Range{0.0, 100.0}, "how far it goes on to the right [m]");
    param("either_side", either_side, YesNo{}, "let the seed decide whether left and right change places");
    param("post_distance_m", post_distance_m, Range{0.5, 10.0}, "between posts, at most [m]");
    param("height_m", height_m, Range{0.3, 3.0}, "[m]");
  }
};

struct PocketParams {
  double at_m = 0.0;
  double depth_m = 0.0;
  double width_m = 4.0;
  std::string of = "bushes";

  void visit(auto&& param) {
    param("at_m", at_m, Range{0.0, 2000.0}, "where its closed end crosses the lane [m]");
    param("depth_m", depth_m, Range{0.0, 50.0},
          "length of its sides, which lead back to the start; 0: none [m]");
    param("width_m", width_m, Range{1.0, 50.0}, "between its sides [m]");
    param("of", of, Choices{"bushes", "trees"}, "what its walls are");
  }
};

struct TrailParams {
  double width_m = 0.0;
  double edge_m = 0.3;
  std::string ground = "mulch";
  double swing_m = 0.0;
  double period_m = 40.0;

  void visit(auto&& param) {
    param("width_m", width_m, Range{0.0, 20.0}, "0: no trail [m]");
    param("edge_m", edge_m, Range{0.0, 5.0}, "over which it fades into what lies beside it [m]");
    param("ground", ground, ground_names(), "what it is of");
    param("swing_m", swing_m, Range{0.0, 30.0}, "how far it winds to each side [m]");
    param("period_m", period_m, Range{5.0, 1000.0}, "length of a wind [m]");
  }
};

struct MudParams {
  int patches = 0;
  double radius_min_m = 1.0;
  double radius_max_m = 2.0;
  double from_m = 5.0;
  double to_m = 60.0;
  double aside_m = 2.0;

  void visit(auto&& param) {
    param("patches", patches, Range{0, 200}, "how many");
    param("radius_min_m", radius_min_m, Range{0.1, 20.0}, "smallest [m]");
    param("radius_max_m", radius_max_m, Range{0.1, 20.0}, "largest [m]");
    param("from_m", from_m, Range{0.0, 2000.0}, "where they begin [m]");
    param("to_m", to_m, Range{0.0, 2000.0}, "where they end [m]");
    param("aside_m", aside_m, Range{0.0, 50.0}, "how far from the lane their middles may lie [m]");
  }
};

struct TerrainParams {
  double slope_along = 0.0;
  double slope_across = 0.0;
  int waves = 6;
  double wave_min_m = 6.0;
  double wave_max_m = 25.0;
  double wave_steepness = 0.02;
  double dip_m = 0.0;
  double dip_period_m = 120.0;

  void visit(auto&& param) {
    param("slope_along", slope_along, Range{-0.5, 0.5}, "rise for each metre east");
    param("slope_across", slope_across, Range{-0.5, 0.5}, "rise for each metre north");
    param("waves", waves, Range{0, 64}, "how many, of random direction");
    param("wave_min_m", wave_min_m, Range{1.0, 1000.0}, "shortest [m]");
    param("wave_max_m", wave_max_m, Range{1.0, 1000.0}, "longest [m]");
    param("wave_steepness", wave_steepness, Range{0.0, 0.3}, "steepest rise of each for each metre");
    param("dip_m", dip_m, Range{0.0, 20.0}, "height of waves that the way goes up and down [m]");
    param("dip_period_m", dip_period_m, Range{10.0, 2000.0}, "their length [m]");
  }
};

struct LightParams {
  double sun_azimuth_rad = 0.8;
  double sun_elevation_rad = 0.7;
  double sun_strength = 1.0;
  double haze_range_m = 250.0;
  double cloud_depth = 0.0;

  void visit(auto&& param) {
    param("sun_azimuth_rad", sun_azimuth_rad, Range{-6.3, 6.3},
          "where it stands, counter-clockwise from east [rad]");
    param("sun_elevation_rad", sun_elevation_rad, Range{0.05, 1.57}, "above the horizon [rad]");
    param("sun_strength", sun_strength, Range{0.0, 1.0}, "0: overcast, 1: clear");
    param("haze_range_m", haze_range_m, Range{10.0, 100000.0}, "where 1/e of contrast is left [m]");
    param("cloud_depth", cloud_depth, Range{0.0, 1.0}, "share of the sun's strength that passing clouds take");
  }
};

}  // namespace hindsight

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "config/params.h"

namespace hindsight {

struct LocalisationParams {
  bool heading_known = false;
  double initial_heading_rad = 0.0;
  double initial_heading_sigma_rad = 0.1;
  double wheel_noise_m = 0.03;
  double lateral_noise_m = 0.01;
  double wheel_yaw_scale_sigma = 0.05;
  double blind_speed_sigma_mps = 0.5;
  double blind_yaw_rate_sigma_radps = 0.5;
  double gyro_noise_radps = 0.001;
  double initial_gyro_bias_radps = 0.0;
  double gyro_bias_sigma_radps = 0.02;
  double gyro_bias_walk_radps = 5e-5;
  double gps_least_sigma_m = 1.0;
  double gps_untold_sigma_m = 5.0;
  double gps_correlation_s = 30.0;
  double gate_distance = 3.72;
  double max_fix_age_s = 2.0;
  double alignment_sigma_rad = 0.25;
  double alignment_spacing_m = 0.5;
  int recovery_fixes = 10;
  double recovery_heading_sigma_rad = 0.3;

  void visit(auto&& param) {
    param("heading_known", heading_known, YesNo{},
          "initial_heading_rad is true: W is east-north from the first fix; otherwise heading comes from "
          "driving");
    param("initial_heading_rad", initial_heading_rad, Range{-3.1416, 3.1416},
          "heading at start, counter-clockwise from W's x axis (east if heading_known) [rad]");
    param("initial_heading_sigma_rad", initial_heading_sigma_rad, Range{0.0, 0.5},
          "its standard deviation if heading_known [rad]");
    param("wheel_noise_m", wheel_noise_m, Range{1e-4, 1.0},
          "standard deviation of a wheel's way after it rolled 1 m; grows with the root of the way [m]");
    param("lateral_noise_m", lateral_noise_m, Range{0.0, 1.0},
          "the same for sideways slip of the vehicle [m]");
    param("wheel_yaw_scale_sigma", wheel_yaw_scale_sigma, Range{0.0, 1.0},
          "relative error of the yaw rate from wheels, where it calibrates the gyro");
    param("blind_speed_sigma_mps", blind_speed_sigma_mps, Range{0.0, 5.0},
          "unknown speed where wheels are not valid, over correlation of 1 s [m/s]");
    param("blind_yaw_rate_sigma_radps", blind_yaw_rate_sigma_radps, Range{0.0, 5.0},
          "unknown yaw rate where neither wheels nor gyro are valid [rad/s]");
    param("gyro_noise_radps", gyro_noise_radps, Range{1e-6, 1.0},
          "standard deviation of the heading after 1 s of gyro noise; grows with the root of time [rad]");
    param("initial_gyro_bias_radps", initial_gyro_bias_radps, Range{-1.0, 1.0},
          "the gyro's bias at start; the last run's where robot.state_file holds one [rad/s]");
    param("gyro_bias_sigma_radps", gyro_bias_sigma_radps, Range{0.0, 1.0},
          "standard deviation of the gyro's bias at start [rad/s]");
    param("gyro_bias_walk_radps", gyro_bias_walk_radps, Range{0.0, 0.1},
          "how far the bias wanders in 1 s; grows with the root of time [rad/s]");
    param("gps_least_sigma_m", gps_least_sigma_m, Range{0.01, 100.0},
          "no fix is believed to be better than this standard deviation [m]");
    param("gps_untold_sigma_m", gps_untold_sigma_m, Range{0.01, 100.0},
          "standard deviation of a fix whose receiver does not tell one [m]");
    param("gps_correlation_s", gps_correlation_s, Range{0.0, 3600.0},
          "how long a fix's error lasts (satellites, atmosphere): fixes that follow one another more closely "
          "tell "
          "little that is new; 0: white noise [s]");
    param("gate_distance", gate_distance, Range{1.0, 100.0},
          "Mahalanobis distance of the innovation beyond which a fix is rejected; 3.72 passes 99.9 % "
          "(chi-square, 2)");
    param("max_fix_age_s", max_fix_age_s, Range{0.0, 10.0}, "an older fix is rejected [s]");
    param("alignment_sigma_rad", alignment_sigma_rad, Range{0.01, 0.5},
          "heading unknown: fixes are used once the driven track gives the heading this well [rad]");
    param("alignment_spacing_m", alignment_spacing_m, Range{0.0, 10.0},
          "way between two fixes that count for the heading from driving [m]");
    param("recovery_fixes", recovery_fixes, Range{2, 1000},
          "after so many rejected fixes in a row that agree with one another, the filter goes to them");
    param("recovery_heading_sigma_rad", recovery_heading_sigma_rad, Range{0.0, 1.0},
          "doubt about the heading after that, unless the track of the rejected fixes gives it better [rad]");
  }
};

}  // namespace hindsight

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "config/vehicle_params.h"
#include "drivers/samples.h"
#include "perception/geodetic_frame.h"
#include "perception/localisation_params.h"
#include "perception/pose.h"
#include "perception/pose_filter.h"
#include "perception/track_alignment.h"

namespace hindsight {

/// What the vehicle says of its own motion since the last step. A value that is not finite counts as not
/// valid.
struct OdometryInput {
  Time now{};
  double left_mps = 0.0;  ///< speed of the driven wheels' contact points
  double right_mps = 0.0;
  bool wheels_valid = false;
  bool slipping = false;  ///< the wheels may turn without the vehicle moving (perception/slip_detector.h)
  double yaw_rate_radps = 0.0;  ///< gyro, raw, counter-clockwise
  bool gyro_valid = false;
};

struct PoseEstimate {
  Time stamp{};
  Pose2 X_WB;
  double v_mps = 0.0;
  double yaw_rate_radps = 0.0;  ///< of the body, without bias
  double gyro_bias_radps = 0.0;
  /// Of x [m], y [m], heading [rad], relative to what W is anchored to (see Localisation).
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  bool has_global_origin = false;  ///< W's place on the earth is known
  double heading_WE_rad = 0.0;     ///< direction of east in W; 0 if heading_known
  Time last_accepted_fix{};        ///< its stamp; 0 before the first
  std::uint32_t fixes_accepted = 0;
  std::uint32_t fixes_rejected = 0;
  std::uint32_t recoveries = 0;  ///< how often X_WB jumped to rejected fixes
};

/// Where the vehicle is: an extended Kalman filter (PoseFilter) that wheels and gyro drive and that GPS
/// fixes, gated by their innovation, correct.
///
/// The world frame W is anchored at start: x = y = 0, heading initial_heading_rad. It never moves under the
/// vehicle: when GPS comes, W's place on the earth is chosen so that X_WB stays as it is.
/// - heading_known: W's axes are east and north. The first fix fixes where W's origin lies; from then on the
///   position's uncertainty is the fix's.
/// - otherwise a heading cannot be had from GPS until the vehicle has moved. Fixes are collected without
/// effect on
///   X_WB until the driven track, laid over them (TrackAlignment), gives the direction of east in W within
///   alignment_sigma_rad (some 45 m of way at 2 m of GPS error and 1 Hz). W's axes stay those of the start,
///   east is heading_WE_rad off its x axis, and the fit's uncertainty goes into the covariance.
/// Without GPS W stays anchored at the start, and the covariance tells how far odometry has strayed.
///
/// A fix that is rejected changes nothing. After recovery_fixes of them in a row that agree with one another
/// the filter counts as lost: X_WB jumps to the fixes; the heading comes from their track where that gives it
/// within recovery_heading_sigma_rad, and is doubted by as much otherwise. That is the only jump;
/// FixReport::recovered tells it.
///
/// GPS errors last (gps_correlation_s): each fix is gated by its own standard deviation, but weighs in the
/// filter, and in the driven track, as one of a stream of white noise with the same spectral density at low
/// frequencies, sigma sqrt(2 tau / dt). Deterministic, no allocation after construction, one thread at a
/// time.
class Localisation {
 public:
  Localisation(const LocalisationParams& params, const VehicleParams& vehicle);

  /// Moves on to input.now. Wheels give the speed; the gyro, else the wheels, the yaw rate. Without wheels
  /// the vehicle is taken to stand, with blind_speed_sigma_mps; slipping wheels may be wrong by their whole
  /// speed. The first call only sets the time; one that is not later than the last does nothing.
  void predict(const OdometryInput& input);

  struct FixReport {
    bool accepted = false;     ///< X_WB was corrected, or W found its place on the earth
    bool recovered = false;    ///< X_WB jumped here
    double mahalanobis = 0.0;  ///< distance of the innovation; 0 while W has no place on the earth
  };
  /// Call after predict(). The fix may be older than that by up to max_fix_age_s; the vehicle is taken to
  /// have come straight on since. One that is not finite, not on the earth, too old, or younger is rejected.
  FixReport correct(const GpsFix& fix);

  const PoseEstimate& estimate() const { return estimate_; }
  /// p_WP_m of a point on the earth; empty while W has no place on it, or for one that is not on the earth.
  std::optional<Point2> local_of(double latitude_deg, double longitude_deg) const;

 private:
  /// A fix as the filter sees it: where it was in E, and where in W the vehicle is taken to have been at its
  /// time.
  struct Measurement {
    Point2 p_E_m;
    Point2 predicted_p_W_m;
    double sigma_m = 0.0;       ///< of this fix
    double news_sigma_m = 0.0;  ///< of what it adds to those before: their errors are much the same
  };

  Motion motion_of(const OdometryInput& input, double dt_s);
  Measurement measurement_of(const GpsFix& fix, double age_s) const;
  bool anchor_position(const Measurement& measured);
  bool anchor_track(const Measurement& measured);
  FixReport gate(const Measurement& measured);
  bool recover(const Measurement& measured);
  void add_to_track(const Measurement& measured, double sigma_m);
  bool track_gives_heading(double within_sigma_rad) const;
  void publish();

  LocalisationParams params_;
  VehicleParams vehicle_;
  PoseFilter filter_;
  GeodeticFrame earth_;  ///< E, with its origin at the first fix
  bool started_ = false;
  bool earth_has_origin_ = false;
  Time last_fix_{};  ///< its stamp
  Pose2 X_WE_;
  TrackAlignment track_;  ///< of the fixes that wait for W's anchor, or of those rejected in a row
  Measurement last_on_track_;
  PoseEstimate estimate_;
};

}  // namespace hindsight

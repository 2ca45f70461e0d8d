// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/localisation.h"

#include <algorithm>
#include <cmath>

namespace hindsight {
namespace {

/// Errors that last (a slipping wheel, an unknown speed) are taken to be independent from one such time to
/// the next.
constexpr double kCorrelation_s = 1.0;
/// Reduced chi-square above which a track does not have the shape of the fixes, so that it gives no heading.
constexpr double kWorstTrackFit = 3.0;

double squared(double x) { return x * x; }
Point2 operator-(const Point2& a, const Point2& b) { return {a.x_m - b.x_m, a.y_m - b.y_m}; }
Point2 operator+(const Point2& a, const Point2& b) { return {a.x_m + b.x_m, a.y_m + b.y_m}; }
Point2 position(const Pose2& X) { return {X.x_m, X.y_m}; }
double distance(const Point2& a, const Point2& b) { return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m); }

/// Variance of the way that one wheel rolled in dt [m2].
double wheel_variance(const LocalisationParams& params, double speed_mps, bool slipping, double dt_s) {
  const double rolling = squared(params.wheel_noise_m) * std::abs(speed_mps) * dt_s;
  return rolling + (slipping ? squared(speed_mps) * kCorrelation_s * dt_s : 0.0);
}

bool is_on_earth(double latitude_deg, double longitude_deg) {
  return std::abs(latitude_deg) <= 90.0 && std::isfinite(longitude_deg);
}

}  // namespace

Localisation::Localisation(const LocalisationParams& params, const VehicleParams& vehicle)
    : params_(params),
      vehicle_(vehicle),
      filter_({0.0, 0.0, params.initial_heading_rad},
              params.heading_known ? squared(params.initial_heading_sigma_rad) : 0.0,
              params.initial_gyro_bias_radps, squared(params.gyro_bias_sigma_radps)) {
  publish();
}

void Localisation::predict(const OdometryInput& input) {
  const double dt_s = started_ ? to_seconds(input.now - estimate_.stamp) : 0.0;
  if (!started_) estimate_.stamp = input.now;
  started_ = true;
  if (dt_s <= 0.0) return;
  estimate_.stamp = input.now;
  const Motion motion = motion_of(input, dt_s);
  filter_.propagate(motion);
  estimate_.v_mps = motion.way_m / dt_s;
  estimate_.yaw_rate_radps = motion.turn_rad / dt_s - (motion.from_gyro ? filter_.bias_radps() : 0.0);
  publish();
}

/// Also measures the gyro's bias against the wheels, where there are both.
Motion Localisation::motion_of(const OdometryInput& input, double dt_s) {
  const bool wheels = input.wheels_valid && std::isfinite(input.left_mps) && std::isfinite(input.right_mps);
  const bool gyro = input.gyro_valid && std::isfinite(input.yaw_rate_radps);
  Motion motion{.dt_s = dt_s, .bias_radps2 = squared(params_.gyro_bias_walk_radps) * dt_s};
  double wheel_yaw_rate_radps = 0.0;
  if (wheels) {
    const double both_m2 = wheel_variance(params_, input.left_mps, input.slipping, dt_s) +
                           wheel_variance(params_, input.right_mps, input.slipping, dt_s);
    wheel_yaw_rate_radps = (input.right_mps - input.left_mps) / vehicle_.track_width_m;
    motion.way_m = 0.5 * (input.left_mps + input.right_mps) * dt_s;
    motion.turn_rad = wheel_yaw_rate_radps * dt_s;
    motion.along_m2 = both_m2 / 4.0;
    motion.lateral_m2 = squared(params_.lateral_noise_m) * std::abs(motion.way_m);
    motion.turn_rad2 = both_m2 / squared(vehicle_.track_width_m);
  } else {
    motion.along_m2 = motion.lateral_m2 = squared(params_.blind_speed_sigma_mps) * kCorrelation_s * dt_s;
    motion.turn_rad2 = squared(params_.blind_yaw_rate_sigma_radps) * kCorrelation_s * dt_s;
  }
  if (!gyro) return motion;
  const double gyro_rad2 = squared(params_.gyro_noise_radps) * dt_s;
  if (wheels && !input.slipping) {
    // At its best at stand-still, where wheels have no noise.
    const double scale_radps2 =
        squared(params_.wheel_yaw_scale_sigma * wheel_yaw_rate_radps) * kCorrelation_s / dt_s;
    filter_.measure_bias(input.yaw_rate_radps - wheel_yaw_rate_radps,
                         (motion.turn_rad2 + gyro_rad2) / squared(dt_s) + scale_radps2,
                         params_.gate_distance);
  }
  motion.turn_rad = input.yaw_rate_radps * dt_s;
  motion.turn_rad2 = gyro_rad2;
  motion.from_gyro = true;
  return motion;
}

Localisation::FixReport Localisation::correct(const GpsFix& fix) {
  FixReport report;
  const double age_s = to_seconds(estimate_.stamp - fix.stamp);
  const bool usable = is_on_earth(fix.latitude_deg, fix.longitude_deg) && std::isfinite(fix.altitude_m) &&
                      std::isfinite(fix.horizontal_sigma_m) && age_s >= 0.0 && age_s <= params_.max_fix_age_s;
  if (!started_ || !usable) {
    ++estimate_.fixes_rejected;
    return report;
  }
  if (!earth_has_origin_) earth_.set_origin(fix);
  earth_has_origin_ = true;
  const Measurement measured = measurement_of(fix, age_s);
  last_fix_ = fix.stamp;
  if (estimate_.has_global_origin) {
    report = gate(measured);
    if (!report.accepted) ++estimate_.fixes_rejected;
  } else {
    report.accepted = params_.heading_known ? anchor_position(measured) : anchor_track(measured);
  }
  if (report.accepted) {
    ++estimate_.fixes_accepted;
    estimate_.last_accepted_fix = fix.stamp;
  }
  publish();
  return report;
}

Localisation::Measurement Localisation::measurement_of(const GpsFix& fix, double age_s) const {
  const double told_m = fix.horizontal_sigma_m > 0.0 ? fix.horizontal_sigma_m : params_.gps_untold_sigma_m;
  const double sigma_m = std::max(told_m, params_.gps_least_sigma_m);
  const double apart_s = to_seconds(fix.stamp - last_fix_);
  const double alike = apart_s > 0.0 ? 2.0 * params_.gps_correlation_s / apart_s : 1.0;
  return {.p_E_m = earth_.east_north(fix.latitude_deg, fix.longitude_deg),
          .predicted_p_W_m = filter_.pose() * Point2{-age_s * estimate_.v_mps, 0.0},
          .sigma_m = sigma_m,
          .news_sigma_m = sigma_m * std::sqrt(std::max(1.0, alike))};
}

/// W's axes are known; the fix says where its origin lies, and its error is all the doubt there is about
/// positions.
bool Localisation::anchor_position(const Measurement& measured) {
  const Point2 p_WE_m = measured.predicted_p_W_m - measured.p_E_m;
  X_WE_ = {p_WE_m.x_m, p_WE_m.y_m, 0.0};
  filter_.reset_position(position(filter_.pose()), squared(measured.sigma_m));
  estimate_.has_global_origin = true;
  return true;
}

bool Localisation::anchor_track(const Measurement& measured) {
  if (track_.count() == 0) {
    // W will be anchored to this track, so doubt counts from its beginning.
    filter_.reset_position(position(filter_.pose()), 0.0);
    filter_.reset_heading(filter_.pose().heading_rad, 0.0);
  } else if (distance(measured.predicted_p_W_m, last_on_track_.predicted_p_W_m) <
             params_.alignment_spacing_m) {
    return false;
  }
  add_to_track(measured, measured.news_sigma_m);
  if (track_gives_heading(params_.alignment_sigma_rad)) {
    X_WE_ = track_.X_WE();
    filter_.add_frame_doubt(position(filter_.pose()) - track_.centre_W_m(),
                            squared(track_.heading_sigma_rad()), squared(track_.centre_sigma_m()));
    track_.clear();
    estimate_.has_global_origin = true;
    return true;
  }
  const bool misfits = track_.heading_sigma_rad() <= params_.alignment_sigma_rad;
  const bool strayed = filter_.covariance()(2, 2) > squared(params_.alignment_sigma_rad);
  if (misfits || strayed) track_.clear();
  return false;
}

Localisation::FixReport Localisation::gate(const Measurement& measured) {
  const Point2 offset_m = X_WE_ * measured.p_E_m - measured.predicted_p_W_m;
  FixReport report;
  report.mahalanobis = filter_.mahalanobis(offset_m, squared(measured.sigma_m));
  report.accepted = report.mahalanobis <= params_.gate_distance;
  if (report.accepted) {
    filter_.measure_position(offset_m, squared(measured.news_sigma_m));
    track_.clear();
  } else {
    report.recovered = report.accepted = recover(measured);
  }
  return report;
}

/// The fixes rejected in a row make up a track. One that is not as far from its predecessor as the vehicle
/// drove meanwhile, in whatever direction, disagrees and begins it anew.
bool Localisation::recover(const Measurement& measured) {
  const double driven_m = distance(measured.predicted_p_W_m, last_on_track_.predicted_p_W_m);
  const double gone_m = distance(measured.p_E_m, last_on_track_.p_E_m);
  const double sigma_m = std::hypot(measured.sigma_m, last_on_track_.sigma_m);
  if (std::abs(driven_m - gone_m) > params_.gate_distance * sigma_m) track_.clear();
  add_to_track(measured, measured.sigma_m);  // so few that they share their error
  if (track_.count() < params_.recovery_fixes) return false;

  const Pose2 X_WB = filter_.pose();
  if (track_gives_heading(params_.recovery_heading_sigma_rad)) {
    // The vehicle stands to the fixes as it stands to the track that it believes to have driven.
    const Pose2 X_VE = track_.X_WE();  // V: W as it would have to be
    const auto p_W_m = [&](const Point2& p_V_m) { return X_WE_ * X_VE.inverse_times(p_V_m); };
    const Point2 p_WB_m = p_W_m(position(X_WB));
    filter_.reset_position(p_WB_m, 0.0);
    filter_.reset_heading(X_WB.heading_rad + X_WE_.heading_rad - X_VE.heading_rad, 0.0);
    filter_.add_frame_doubt(p_WB_m - p_W_m(track_.centre_W_m()), squared(track_.heading_sigma_rad()),
                            squared(track_.centre_sigma_m()));
  } else {
    const Point2 offset_m = X_WE_ * measured.p_E_m - measured.predicted_p_W_m;
    filter_.reset_position(position(X_WB) + offset_m, squared(measured.sigma_m));
    filter_.reset_heading(X_WB.heading_rad,
                          filter_.covariance()(2, 2) + squared(params_.recovery_heading_sigma_rad));
  }
  track_.clear();
  ++estimate_.recoveries;
  return true;
}

void Localisation::add_to_track(const Measurement& measured, double sigma_m) {
  track_.add(measured.predicted_p_W_m, measured.p_E_m, sigma_m);
  last_on_track_ = measured;
}

bool Localisation::track_gives_heading(double within_sigma_rad) const {
  return track_.count() > 2 && track_.heading_sigma_rad() <= within_sigma_rad &&
         track_.reduced_chi_square() <= kWorstTrackFit;
}

std::optional<Point2> Localisation::local_of(double latitude_deg, double longitude_deg) const {
  if (!estimate_.has_global_origin || !is_on_earth(latitude_deg, longitude_deg)) return std::nullopt;
  return X_WE_ * earth_.east_north(latitude_deg, longitude_deg);
}

void Localisation::publish() {
  estimate_.X_WB = filter_.pose();
  estimate_.gyro_bias_radps = filter_.bias_radps();
  estimate_.covariance = filter_.covariance().topLeftCorner<3, 3>();
  estimate_.heading_WE_rad = X_WE_.heading_rad;
}

}  // namespace hindsight

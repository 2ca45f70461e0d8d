// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/slip_detector.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "config/exit_code.h"

namespace hindsight {
namespace {

CurrentSpectrum make_spectrum(const SlipDetectorParams& params, double sample_rate_hz) {
  if (!(params.centre_hz < 0.5 * sample_rate_hz)) {
    throw FatalError(
        kExitConfiguration,
        fmt::format("slip detector: motor currents at {} Hz do not show {} Hz; expected more than {} Hz",
                    sample_rate_hz, params.centre_hz, 2.0 * params.centre_hz));
  }
  return CurrentSpectrum({.window_s = params.window_s, .hann = params.window == "hann"}, sample_rate_hz);
}

/// Load varies, noise apart, more slowly than so many times centre_hz; what is faster says nothing about a
/// component.
constexpr double kWidestBand = 3.0;

/// Share of the power that one of m independent components of white noise exceeds with the probability given
/// (Fisher 1929: Tests of significance in harmonic analysis; the first term). The fewer samples a window has,
/// the more a component must stand out.
double share_above_noise(const SlipDetectorParams& params, double sample_rate_hz) {
  if (params.noise_probability >= 1.0) return 0.0;
  const double band_hz = std::min(0.5 * sample_rate_hz, kWidestBand * params.centre_hz);
  const double hann_halves = params.window == "hann" ? 0.5 : 1.0;
  const double m = std::max(2.0, hann_halves * band_hz * params.window_s);
  return 1.0 - std::pow(params.noise_probability / m, 1.0 / (m - 1.0));
}

double squared(float x) { return static_cast<double>(x) * static_cast<double>(x); }

}  // namespace

bool turns(const WheelMotion& motion, double least_mps) {
  return std::abs(motion.commanded_mps) >= least_mps && std::abs(motion.measured_mps) >= least_mps;
}

SlipDetector::SlipDetector(const SlipDetectorParams& params, double sample_rate_hz)
    : params_(params),
      min_share_(share_above_noise(params, sample_rate_hz)),
      channels_{Channel{.spectrum = make_spectrum(params, sample_rate_hz)},
                Channel{.spectrum = make_spectrum(params, sample_rate_hz)}} {}

void SlipDetector::add_current(Wheel wheel, Time stamp, double current_a) {
  channels_[static_cast<std::size_t>(wheel)].spectrum.add(stamp, current_a);
}

const SlipReport& SlipDetector::update(Time now, const std::array<WheelMotion, kWheelCount>& motion) {
  report_.slipping = false;
  for (std::size_t i = 0; i < kWheelCount; ++i) {
    Channel& channel = channels_[i];
    WheelSlip& slip = report_.wheels[i];
    if (channel.spectrum.update()) find_component(channel.spectrum, slip);
    const bool turning = turns(motion[i], params_.min_speed_mps);
    if (turning && is_slip(channel.spectrum, slip)) {
      channel.last_slip = now;
      slip.slipping = true;
    } else {
      slip.slipping = slip.slipping && turning && to_seconds(now - channel.last_slip) < params_.hold_s;
    }
    report_.slipping = report_.slipping || slip.slipping;
  }
  return report_;
}

void SlipDetector::find_component(const CurrentSpectrum& spectrum, WheelSlip& slip) const {
  slip.component = slip.component_hz = slip.share = 0.0;
  slip.mean_a = spectrum.mean_a();
  const std::span<const float> amplitudes = spectrum.relative_amplitudes();
  const std::size_t last = amplitudes.size() - 1;
  std::size_t best = 0;
  double power = 0.0;
  for (std::size_t k = 1; k <= last; ++k) {
    const double hz = static_cast<double>(k) * spectrum.hz_per_bin();
    if (hz <= kWidestBand * params_.centre_hz) power += squared(amplitudes[k]);
    if (std::abs(hz - params_.centre_hz) > params_.half_width_hz + 1e-9) continue;
    // Above half the sample rate the spectrum is mirrored.
    const float left = amplitudes[k - 1], right = k < last ? amplitudes[k + 1] : left;
    const bool peak = amplitudes[k] > left && amplitudes[k] > right;
    if ((peak || !params_.local_peak) && static_cast<double>(amplitudes[k]) > slip.component) {
      best = k;
      slip.component = static_cast<double>(amplitudes[k]);
      slip.component_hz = hz;
    }
  }
  if (best == 0) return;
  const double left = best > 1 ? squared(amplitudes[best - 1]) : 0.0;
  const double right = best < last ? squared(amplitudes[best + 1]) : 0.0;
  slip.share = (left + squared(amplitudes[best]) + right) / power;
}

bool SlipDetector::is_slip(const CurrentSpectrum& spectrum, const WheelSlip& slip) const {
  return spectrum.full() && std::abs(slip.mean_a) >= params_.min_dc_a && slip.component > params_.threshold &&
         slip.share >= min_share_;
}

}  // namespace hindsight

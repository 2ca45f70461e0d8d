// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "config/params.h"
#include "drivers/samples.h"
#include "perception/current_spectrum.h"

namespace hindsight {

struct SlipDetectorParams {
  double window_s = 2.0;
  double centre_hz = 3.0;
  double half_width_hz = 0.4;
  double threshold = 0.25;
  std::string window = "hann";
  bool local_peak = true;
  double noise_probability = 0.001;
  double min_dc_a = 1.0;
  double min_speed_mps = 0.1;
  double hold_s = 1.0;

  void visit(auto&& param) {
    param("window_s", window_s, Range{0.5, 20.0}, "length of the sliding window [s]");
    param("centre_hz", centre_hz, Range{0.1, 100.0}, "where slipping wheels show their peak [Hz]");
    param("half_width_hz", half_width_hz, Range{0.0, 50.0}, "how far from it a component may lie [Hz]");
    param("threshold", threshold, Range{0.0, 100.0}, "a component over the DC coefficient that means slip");
    param("window", window, Choices{"rectangular", "hann"}, "weights of the window's samples");
    param("local_peak", local_peak, YesNo{}, "the component must be larger than both its neighbours");
    param("noise_probability", noise_probability, Range{1e-9, 1.0},
          "how likely white noise may have a component that stands out so far; 1 does not ask");
    param("min_dc_a", min_dc_a, Range{0.0, 1000.0}, "least mean current: an idle motor does not slip [A]");
    param("min_speed_mps", min_speed_mps, Range{0.0, 5.0},
          "the wheel must be told, and seen, to turn so fast [m/s]");
    param("hold_s", hold_s, Range{0.0, 20.0}, "slip ends when it has been gone for so long [s]");
  }
};

enum class Wheel : std::uint8_t { left = 0, right = 1 };
constexpr std::size_t kWheelCount = 2;

/// What one wheel was told and seen to do.
struct WheelMotion {
  double commanded_mps = 0.0;
  double measured_mps = 0.0;
};

/// The wheel is told, and seen, to turn so fast: one that stands does not slip.
bool turns(const WheelMotion& motion, double least_mps);

struct WheelSlip {
  bool slipping = false;
  double component = 0.0;     ///< largest in the band, over DC; of a peak only if local_peak; 0 if none
  double component_hz = 0.0;  ///< its frequency; 0 if none
  double share = 0.0;         ///< of the oscillation's power that it has with its neighbours
  double mean_a = 0.0;
};

struct SlipReport {
  bool slipping = false;  ///< either wheel
  std::array<WheelSlip, kWheelCount> wheels;
};

/// Wheel slip from an oscillation of the motor current near 3 Hz (thesis 5): short-time Fourier transform of
/// each current, normalised by its DC coefficient; slip where a component near 3 Hz exceeds a quarter of it.
///
/// Ordinary driving shows such components too: peaks at 2 to 2.5 Hz whose flanks reach 3 Hz, and loads so
/// uneven that some component is large wherever one looks. So the default asks in addition that the component
/// is a peak of its own and that white noise would hardly have one with such a share of the power. An
/// oscillation as large as the mean is told about 1 s after it began, half a window, when it is half of what
/// the window holds; a smaller one later.
///
/// The thesis' detector is half_width_hz 0.5, window "rectangular", local_peak false, noise_probability 1,
/// and min_dc_a, min_speed_mps and hold_s 0. Deterministic, no allocation after construction, one thread at a
/// time.
class SlipDetector {
 public:
  /// FatalError(kExitConfiguration) where currents at sample_rate_hz cannot show centre_hz.
  SlipDetector(const SlipDetectorParams& params, double sample_rate_hz);

  /// One sample of a motor current, in the order of time for each wheel. Its sign does not matter.
  void add_current(Wheel wheel, Time stamp, double current_a);
  /// Call after the samples up to `now`; says whether the wheels slip now.
  const SlipReport& update(Time now, const std::array<WheelMotion, kWheelCount>& motion);

  const SlipReport& report() const { return report_; }
  /// The last whole window, for telemetry and spectrograms.
  const CurrentSpectrum& spectrum(Wheel wheel) const { return channel(wheel).spectrum; }

 private:
  struct Channel {
    CurrentSpectrum spectrum;
    Time last_slip = {};  ///< when its component was last there
  };

  const Channel& channel(Wheel wheel) const { return channels_[static_cast<std::size_t>(wheel)]; }
  void find_component(const CurrentSpectrum& spectrum, WheelSlip& slip) const;
  bool is_slip(const CurrentSpectrum& spectrum, const WheelSlip& slip) const;

  SlipDetectorParams params_;
  double min_share_;
  std::array<Channel, kWheelCount> channels_;
  SlipReport report_;
};

}  // namespace hindsight

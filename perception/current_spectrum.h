// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "drivers/samples.h"

namespace hindsight {

/// Short-time Fourier transform of one motor current: of the samples in a window that ends with the newest
/// one. Samples may come irregularly: they are interpolated linearly onto a grid of sample_rate_hz. Allocates
/// at construction only. One thread at a time.
class CurrentSpectrum {
 public:
  struct Shape {
    double window_s = 2.0;
    bool hann = false;  ///< otherwise rectangular
  };

  /// The window is rounded to an even number of samples whose half has no prime factor above 5: kissfft
  /// allocates with others.
  CurrentSpectrum(const Shape& shape, double sample_rate_hz);
  ~CurrentSpectrum();
  CurrentSpectrum(CurrentSpectrum&&) noexcept;
  CurrentSpectrum& operator=(CurrentSpectrum&&) noexcept;

  /// A sample not later than the last, or not finite, is ignored. After a gap of more than a quarter of the
  /// window the window fills anew.
  void add(Time stamp, double current_a);

  /// Transforms the window if it is full and holds something new. Returns whether it did.
  bool update();

  /// Whether amplitudes() tells of the present window.
  bool full() const { return filled_ == samples_.size(); }
  /// Magnitude of each coefficient, from 0 Hz to half the sample rate, over that of the DC coefficient: a
  /// sine of amplitude A on a mean of D shows as A / 2D, with either window. The first is 1. All 0 where the
  /// mean is 0.
  std::span<const float> relative_amplitudes() const { return amplitudes_; }
  double hz_per_bin() const { return hz_per_bin_; }
  /// Mean of the window [A].
  double mean_a() const { return mean_a_; }
  std::size_t window_samples() const { return samples_.size(); }

 private:
  struct Transform;

  void push(float current_a);

  double rate_hz_;
  double hz_per_bin_;
  std::vector<float> samples_;  ///< ring; next_ is the oldest
  std::vector<float> weights_;
  float weight_sum_ = 0.0F;
  std::size_t next_ = 0;
  std::size_t filled_ = 0;
  bool fresh_ = false;
  std::optional<Time> last_stamp_;
  double last_a_ = 0.0;
  Time grid_start_{};
  std::int64_t grid_index_ = 0;  ///< of the next grid point
  double mean_a_ = 0.0;
  std::vector<float> amplitudes_;
  std::unique_ptr<Transform> transform_;
};

}  // namespace hindsight

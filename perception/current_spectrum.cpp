// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/current_spectrum.h"

#include <kiss_fftr.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace hindsight {
namespace {

constexpr double kLongestGapInWindows = 0.25;

bool has_small_factors(int n) {
  for (const int factor : {2, 3, 5}) {
    while (n % factor == 0) n /= factor;
  }
  return n == 1;
}

/// Even, at least 4.
int window_length(double samples) {
  const int half = std::max(2, static_cast<int>(std::floor(samples / 2.0)));
  int below = half, above = half + 1;
  while (!has_small_factors(below)) --below;
  while (!has_small_factors(above)) ++above;
  return samples - 2.0 * below <= 2.0 * above - samples ? 2 * below : 2 * above;
}

std::vector<float> window_weights(std::size_t n, bool hann) {
  std::vector<float> weights(n, 1.0F);
  if (!hann) return weights;
  for (std::size_t i = 0; i < n; ++i) {
    const double phase = 2.0 * M_PI * static_cast<double>(i) / static_cast<double>(n);
    weights[i] = static_cast<float>(0.5 - 0.5 * std::cos(phase));
  }
  return weights;
}

}  // namespace

struct CurrentSpectrum::Transform {
  explicit Transform(std::size_t n)
      : state(kiss_fftr_alloc(static_cast<int>(n), 0, nullptr, nullptr), &std::free), in(n), out(n / 2 + 1) {}
  std::unique_ptr<kiss_fftr_state, void (*)(void*)> state;
  std::vector<float> in;
  std::vector<kiss_fft_cpx> out;
};

CurrentSpectrum::CurrentSpectrum(const Shape& shape, double sample_rate_hz) : rate_hz_(sample_rate_hz) {
  const auto n = static_cast<std::size_t>(window_length(shape.window_s * sample_rate_hz));
  hz_per_bin_ = sample_rate_hz / static_cast<double>(n);
  samples_.resize(n);
  weights_ = window_weights(n, shape.hann);
  for (const float w : weights_) weight_sum_ += w;
  amplitudes_.resize(n / 2 + 1);
  transform_ = std::make_unique<Transform>(n);
}

CurrentSpectrum::~CurrentSpectrum() = default;
CurrentSpectrum::CurrentSpectrum(CurrentSpectrum&&) noexcept = default;
CurrentSpectrum& CurrentSpectrum::operator=(CurrentSpectrum&&) noexcept = default;

void CurrentSpectrum::add(Time stamp, double current_a) {
  if (!std::isfinite(current_a) || (last_stamp_ && stamp <= *last_stamp_)) return;
  const double longest_gap_s = kLongestGapInWindows * static_cast<double>(samples_.size()) / rate_hz_;
  if (!last_stamp_ || to_seconds(stamp - *last_stamp_) > longest_gap_s) {
    filled_ = 0;
    grid_start_ = stamp;
    grid_index_ = 1;
    push(static_cast<float>(current_a));
  } else {
    const double span_s = to_seconds(stamp - *last_stamp_);
    for (;; ++grid_index_) {
      const Time grid = grid_start_ + from_seconds(static_cast<double>(grid_index_) / rate_hz_);
      if (grid > stamp) break;
      const double part = to_seconds(grid - *last_stamp_) / span_s;
      push(static_cast<float>(last_a_ + part * (current_a - last_a_)));
    }
  }
  last_stamp_ = stamp;
  last_a_ = current_a;
}

void CurrentSpectrum::push(float current_a) {
  samples_[next_] = current_a;
  next_ = (next_ + 1) % samples_.size();
  filled_ = std::min(filled_ + 1, samples_.size());
  fresh_ = true;
}

bool CurrentSpectrum::update() {
  if (!full() || !fresh_) return false;
  fresh_ = false;
  std::vector<float>& in = transform_->in;
  const auto oldest = samples_.begin() + static_cast<std::ptrdiff_t>(next_);
  std::rotate_copy(samples_.begin(), oldest, samples_.end(), in.begin());
  double sum = 0.0;
  for (const float a : in) sum += static_cast<double>(a);
  mean_a_ = sum / static_cast<double>(in.size());
  // Without its mean the window has no DC to leak into its neighbours; it is put back as the amplitude at 0
  // Hz.
  for (std::size_t i = 0; i < in.size(); ++i) in[i] = weights_[i] * (in[i] - static_cast<float>(mean_a_));
  kiss_fftr(transform_->state.get(), in.data(), transform_->out.data());
  const float dc = weight_sum_ * std::abs(static_cast<float>(mean_a_));
  for (std::size_t k = 0; k < amplitudes_.size(); ++k) {
    const kiss_fft_cpx c = transform_->out[k];
    amplitudes_[k] = dc > 0.0F ? std::sqrt(c.r * c.r + c.i * c.i) / dc : 0.0F;
  }
  amplitudes_.front() = dc > 0.0F ? 1.0F : 0.0F;
  amplitudes_.back() *= 0.5F;  // its mirror image falls on itself
  return true;
}

}  // namespace hindsight

// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/renderer/auto_exposure.h"

#include <algorithm>
#include <cmath>

namespace hindsight {
namespace {

constexpr double kWantedMean = 104.0;
constexpr double kLag_s = 1.2;
constexpr double kShortest_s = 1.0 / 4000.0;
constexpr double kLongest_s = 1.0 / 60.0;
constexpr double kMostGain = 16.0;
/// Bytes go with about this power of light.
constexpr double kGamma = 1.85;

double stops_off(double mean) { return kGamma * std::log2(kWantedMean / std::clamp(mean, 4.0, 250.0)); }

double within_reach(double stops) {
  return std::clamp(stops, std::log2(kShortest_s), std::log2(kLongest_s * kMostGain));
}

}  // namespace

void AutoExposure::settle(double mean) { stops_ = within_reach(stops_ + stops_off(mean)); }

void AutoExposure::meter(double mean, double dt_s) {
  stops_ = within_reach(stops_ + stops_off(mean) * (1.0 - std::exp(-dt_s / kLag_s)));
}

float AutoExposure::exposure_s() const { return static_cast<float>(std::min(std::exp2(stops_), kLongest_s)); }
float AutoExposure::gain() const { return static_cast<float>(std::max(1.0, std::exp2(stops_) / kLongest_s)); }

double mean_green(const std::vector<std::uint8_t>& bgr) {
  std::uint64_t sum = 0, count = 0;
  // An odd step, so that all columns have their turn.
  for (std::size_t i = bgr.size() * 2 / 5 / 3 * 3 + 1; i < bgr.size(); i += 3 * 37) sum += bgr[i], ++count;
  return static_cast<double>(sum) / static_cast<double>(count);
}

}  // namespace hindsight

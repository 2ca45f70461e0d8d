// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/current_spectrum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>
#include <random>

namespace hindsight {
namespace {

double sine(double t, double hz) { return std::sin(2.0 * M_PI * hz * t); }

void fill(CurrentSpectrum& spectrum, double rate_hz, double seconds, auto&& current_a) {
  const int n = static_cast<int>(std::lround(seconds * rate_hz));
  for (int i = 0; i < n; ++i) {
    const double t = i / rate_hz;
    spectrum.add(from_seconds(t), current_a(t));
  }
}

TEST(CurrentSpectrum, ShowsASineAsHalfItsAmplitudeOverTheMean) {
  for (const bool hann : {false, true}) {
    CurrentSpectrum spectrum({.window_s = 2.0, .hann = hann}, 50.0);
    fill(spectrum, 50.0, 2.0, [](double t) { return 4.0 + 2.0 * sine(t, 3.0); });
    ASSERT_TRUE(spectrum.update());
    EXPECT_DOUBLE_EQ(spectrum.hz_per_bin(), 0.5);
    ASSERT_EQ(spectrum.relative_amplitudes().size(), 51U);
    EXPECT_NEAR(spectrum.mean_a(), 4.0, 1e-6);
    EXPECT_EQ(spectrum.relative_amplitudes()[0], 1.0F);
    EXPECT_NEAR(spectrum.relative_amplitudes()[6], 0.25, 1e-5);
    EXPECT_NEAR(spectrum.relative_amplitudes()[5], hann ? 0.125 : 0.0, 1e-5);
    EXPECT_NEAR(spectrum.relative_amplitudes()[12], 0.0, 1e-5);
  }
}

TEST(CurrentSpectrum, AgreesWithThePlainSum) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> current(-1.0, 5.0);
  CurrentSpectrum spectrum({.window_s = 2.0, .hann = false}, 15.0);
  std::vector<double> samples;
  for (int i = 0; i < 47; ++i) {  // the ring wraps
    samples.push_back(current(random));
    spectrum.add(from_seconds(i / 15.0), samples.back());
  }
  ASSERT_TRUE(spectrum.update());
  const std::size_t n = spectrum.window_samples();
  ASSERT_EQ(n, 30U);
  const auto coefficient = [&](std::size_t k) {
    std::complex<double> sum = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      const double phase = -2.0 * M_PI * static_cast<double>(i * k) / static_cast<double>(n);
      sum += std::polar(samples[samples.size() - n + i], phase);
    }
    return std::abs(sum);
  };
  for (std::size_t k = 1; k <= n / 2; ++k) {
    const double one_sided = k == n / 2 ? 0.5 : 1.0;
    // Grid points lie up to 1 ns beside the samples.
    EXPECT_NEAR(spectrum.relative_amplitudes()[k], one_sided * coefficient(k) / coefficient(0), 1e-5) << k;
  }
}

TEST(CurrentSpectrum, TakesIrregularSamples) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> jitter(0.5, 1.5);
  CurrentSpectrum spectrum({.window_s = 2.0, .hann = true}, 50.0);
  for (double t = 0.0; t < 3.0; t += 0.02 * jitter(random)) {
    spectrum.add(from_seconds(t), 4.0 + 2.0 * sine(t, 3.0));
  }
  ASSERT_TRUE(spectrum.update());
  EXPECT_NEAR(spectrum.relative_amplitudes()[6], 0.25, 0.01);
}

TEST(CurrentSpectrum, ChoosesAWindowThatTransformsWithoutAllocation) {
  for (const auto& [rate_hz, samples] :
       {std::pair{50.0, 100U}, {15.0, 30U}, {6.5, 12U}, {7.0, 12U}, {100.0, 200U}}) {
    EXPECT_EQ(CurrentSpectrum({}, rate_hz).window_samples(), samples) << rate_hz;
  }
}

TEST(CurrentSpectrum, WaitsForAWholeWindowAndForSomethingNew) {
  CurrentSpectrum spectrum({.window_s = 2.0}, 50.0);
  fill(spectrum, 50.0, 1.98, [](double) { return 1.0; });
  EXPECT_FALSE(spectrum.full());
  EXPECT_FALSE(spectrum.update());
  spectrum.add(from_seconds(1.98), 1.0);
  EXPECT_TRUE(spectrum.update());
  EXPECT_FALSE(spectrum.update());
}

TEST(CurrentSpectrum, FillsAnewAfterAGap) {
  CurrentSpectrum spectrum({.window_s = 2.0}, 50.0);
  fill(spectrum, 50.0, 3.0, [](double) { return 1.0; });
  spectrum.add(from_seconds(3.4), 1.0);
  EXPECT_TRUE(spectrum.full());
  spectrum.add(from_seconds(4.0), 1.0);
  EXPECT_FALSE(spectrum.full());
}

TEST(CurrentSpectrum, IgnoresWhatIsNotANumberOrNotLater) {
  CurrentSpectrum spectrum({.window_s = 2.0}, 50.0);
  fill(spectrum, 50.0, 2.0, [](double) { return 1.0; });
  spectrum.add(from_seconds(2.0), std::numeric_limits<double>::quiet_NaN());
  spectrum.add(from_seconds(1.0), 100.0);
  ASSERT_TRUE(spectrum.update());
  EXPECT_EQ(spectrum.mean_a(), 1.0);
}

TEST(CurrentSpectrum, IsZeroWhereTheMeanIs) {
  CurrentSpectrum spectrum({.window_s = 2.0}, 50.0);
  fill(spectrum, 50.0, 2.0, [](double) { return 0.0; });
  ASSERT_TRUE(spectrum.update());
  for (const float a : spectrum.relative_amplitudes()) EXPECT_EQ(a, 0.0F);
}

}  // namespace
}  // namespace hindsight

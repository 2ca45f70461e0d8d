// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "fault_schedule.h"

#include <fmt/format.h>

#include <array>
#include <random>

namespace hindsight::endurance {
namespace {

constexpr std::array kSources{Source::camera, Source::can, Source::gpio, Source::gps};
constexpr std::array kSourceWords{"camera", "can", "gpio", "gps"};
/// The first comes once the robot drives; each of the others leaves it so long to be armed and to drive
/// again.
constexpr double kFirst_s = 3.0, kLeastPause_s = 4.0, kMostPause_s = 8.0;
constexpr double kShortest_s = 0.1, kLongest_s = 3.0;

}  // namespace

std::vector<FaultSpec> draw_faults(std::uint64_t seed, Time drive) {
  std::mt19937_64 random(seed);
  std::uniform_int_distribution<std::size_t> source(0, kSources.size() - 1), kind(0, kFaultWords.size() - 1);
  std::uniform_real_distribution<double> length_s(kShortest_s, kLongest_s),
      pause_s(kLeastPause_s, kMostPause_s);
  std::vector<FaultSpec> faults;
  for (Time begin = from_seconds(kFirst_s);;) {
    const FaultSpec fault{kSources[source(random)], static_cast<FaultKind>(kind(random)), begin,
                          from_seconds(length_s(random))};
    begin += fault.length + from_seconds(pause_s(random));
    if (begin > drive) return faults;
    faults.push_back(fault);
  }
}

std::string text_of(const FaultSpec& fault) {
  return fmt::format("{}:{}:{:.2f}s:{:.2f}s", kSourceWords[static_cast<std::size_t>(fault.source)],
                     kFaultWords[static_cast<std::size_t>(fault.kind)], to_seconds(fault.begin),
                     to_seconds(fault.length));
}

}  // namespace hindsight::endurance

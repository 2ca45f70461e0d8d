// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// soak: drives in simulated forests, one after the other, while faults of all sources and kinds come by
// chance. Prints what became of each fault and what the process uses, and fails if a command other than zero
// goes out while motion is forbidden, a fault is not met as it must be, or the process grows.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>

#include "config/exit_code.h"
#include "fault_schedule.h"
#include "faulty_drive.h"
#include "process_vitals.h"
#include "sim_replay/world/course.h"

namespace hindsight::endurance {
namespace {

using SteadyClock = std::chrono::steady_clock;

constexpr Time kDrive = std::chrono::seconds(40);  ///< of the world's time
/// The first drive fills caches; whose heap grows by more than this afterwards, leaks: a drive's flow and
/// picture histories alone are a hundred times as much.
constexpr double kMostGrowth_mb = 1.0;

struct Job {
  double minutes = 1.0;
  std::uint64_t seed = 1;
  std::string course;
};

struct Totals {
  int drives = 0, faults = 0, stops = 0, complaints = 0;
  std::uint64_t ticks = 0;
};

void tell(const FaultOutcome& outcome, std::uint64_t seed, Totals& totals) {
  const std::string wrong = complaint(outcome);
  const bool stopped = outcome.reason != StopReason::none;
  totals.faults += 1;
  totals.stops += stopped;
  totals.complaints += !wrong.empty();
  fmt::print("seed {:3} {:32} {}{}\n", seed, text_of(outcome.fault),
             stopped
                 ? fmt::format("stopped after {:.1f} s: {}", outcome.stopped_after_s, name_of(outcome.reason))
                 : "drove on",
             wrong.empty() ? "" : ", WRONG: " + wrong);
}

void drive(const Course& course, std::uint64_t seed, Totals& totals) {
  FaultyDrive drive(build_world(course, seed), seed, draw_faults(seed, kDrive));
  while (drive.elapsed() < kDrive) drive.step();
  for (const FaultOutcome& outcome : drive.outcomes()) {
    // The last ones' aftermath may lie beyond the drive.
    if (outcome.fault.begin + outcome.fault.length + std::chrono::seconds(4) < kDrive)
      tell(outcome, seed, totals);
  }
  totals.drives += 1;
  totals.ticks += static_cast<std::uint64_t>(drive.summary().ticks);
}

/// The first drive's use is what later drives are held against.
bool grew(const ProcessVitals& now, const ProcessVitals& first) {
  return now.heap_mb > first.heap_mb + kMostGrowth_mb || now.descriptors > first.descriptors ||
         now.threads > first.threads;
}

int soak(const Job& job) {
  const Course course = load_course(job.course);
  const auto end = SteadyClock::now() + std::chrono::duration<double>(60.0 * job.minutes);
  Totals totals;
  ProcessVitals first, now;
  for (std::uint64_t seed = job.seed; totals.drives < 2 || SteadyClock::now() < end; ++seed) {
    drive(course, seed, totals);
    now = process_vitals();
    if (totals.drives == 1) first = now;
    fmt::print("seed {:3} ended: heap {:.2f} MB, {:.0f} MB resident, {} descriptors, {} threads\n", seed,
               now.heap_mb, now.resident_mb, now.descriptors, now.threads);
    std::fflush(stdout);
  }
  fmt::print(
      "{} drives, {} ticks, {} faults, {} stops, {} wrong; heap {:+.2f} MB, {:+} descriptors, {:+} threads "
      "since "
      "the "
      "first drive\n",
      totals.drives, totals.ticks, totals.faults, totals.stops, totals.complaints,
      now.heap_mb - first.heap_mb, now.descriptors - first.descriptors, now.threads - first.threads);
  return totals.complaints > 0 || grew(now, first) ? 1 : 0;
}

}  // namespace
}  // namespace hindsight::endurance

int main(int argc, char** argv) {
  hindsight::endurance::Job job;
  CLI::App app("Drive through faults for some minutes, and watch what the process uses");
  app.add_option("--minutes", job.minutes, "How long; at least two drives")->check(CLI::Range(0.01, 1e6));
  app.add_option("--seed", job.seed, "Of the first drive; each next one counts up")->capture_default_str();
  app.add_option("course", job.course, "Course file")->required();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? hindsight::kExitOk : hindsight::kExitUsage;
  }
  try {
    return hindsight::endurance::soak(job);
  } catch (const std::exception& error) {
    fmt::print(stderr, "soak: {}\n", error.what());
    return 1;
  }
}

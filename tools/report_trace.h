// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// What a report remembers of each tick of a run.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "daemon/replay_run.h"
#include "daemon/timing_histogram.h"

namespace hindsight::tools {

struct TickTrace {
  double time_s = 0.0;  ///< since the run's first tick
  Behaviour behaviour = Behaviour::idle;
  StopReason stop = StopReason::none;
  std::array<SourceState, kSourceCount> sources{};
  Pose2 X_WB;
  DriveCommand commanded;
  DriveCommand measured;  ///< NaN while the encoders are not fresh
  double step_ms = 0.0;   ///< of this tick's step; NaN where not known
  double latency_ms = 0.0;
  std::array<bool, kWheelCount> slipping{};
  std::array<WheelLoss, kWheelCount> loss{};  ///< NaN while the ground is not known
  double road_confidence = 0.0;  ///< NaN where no road is told
};

struct EventTrace {
  double time_s = 0.0;
  std::uint64_t tick = 0;
  TrainingCause cause = TrainingCause::bumper_left;
  Point2 p_WP_m;
};

/// One motor's relative amplitudes over time.
struct SpectrumTrace {
  std::size_t bins = 0;
  double hz_per_bin = 0.0;
  std::vector<float> amplitudes;  ///< tick by tick, `bins` each; NaN while the window fills
};

struct RunTrace {
  std::vector<TickTrace> ticks;
  std::vector<EventTrace> events;
  std::array<SpectrumTrace, kWheelCount> spectra;
  std::uint64_t frames = 0;
  bool road_sought = false;
  std::array<std::uint64_t, kLineCount> touches{};  ///< presses of each line
  double distance_m = 0.0;                          ///< sum of the estimated speed, either way
  std::optional<double> reached_s;                  ///< when the goal was first reached
  TimingHistogram wake_latency;
  TimingHistogram step_duration;
  std::uint32_t overruns = 0;
  std::uint32_t recorder_dropped = 0;

  /// Takes in the tick that `run` has just stepped through.
  void add(ReplayRun& run);
  double duration_s() const { return ticks.empty() ? 0.0 : ticks.back().time_s; }

 private:
  void add_spectra(const SlipDetector& detector);
  void add_timing(const LoopTiming& timing);

  std::optional<Time> began_;
  std::array<bool, kLineCount> active_{};
};

}  // namespace hindsight::tools

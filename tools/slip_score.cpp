// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/slip_score.h"

#include <algorithm>
#include <limits>

#include "tools/statistics.h"

namespace hindsight::tools {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

double quiet_hours(const SlipTrace& trace) {
  if (trace.ticks.empty()) return 0.0;
  Time quiet{}, from = trace.begin;
  for (const SlipSpan& slip : trace.slips) {
    quiet += std::max(Time{}, slip.begin - from);
    from = slip.end + SlipTrace::kAftermath;
  }
  quiet += std::max(Time{}, trace.ticks.back().now - from);
  return to_seconds(quiet) / 3600.0;
}

/// Whether slip was told, tick by tick.
std::vector<bool> watch(const SlipWatchParams& params, double current_rate_hz, double track_width_m,
                        const SlipTrace& trace) {
  SlipWatch slip(params.currents, current_rate_hz, params.ground, track_width_m);
  std::vector<bool> told;
  auto current = trace.currents.begin();
  auto speed = trace.speeds.begin();
  auto step = trace.steps.begin();
  for (const SlipTrace::Tick& tick : trace.ticks) {
    for (; current != trace.currents.end() && current->stamp <= tick.now; ++current)
      slip.add_currents(current->stamp, current->left_a, current->right_a);
    for (; speed != trace.speeds.end() && speed->stamp <= tick.now; ++speed)
      slip.add_speeds(speed->stamp, speed->left_mps, speed->right_mps);
    for (; step != trace.steps.end() && step->to <= tick.now; ++step) slip.add_step(*step);
    told.push_back(slip.update(tick.now, tick.motion));
  }
  return told;
}

bool in_quiet(const SlipTrace& trace, Time now) {
  return std::none_of(trace.slips.begin(), trace.slips.end(), [&](const SlipSpan& slip) {
    return now >= slip.begin && now <= slip.end + SlipTrace::kAftermath;
  });
}

double delay_of(const SlipSpan& slip, const SlipTrace& trace, const std::vector<bool>& told) {
  for (std::size_t i = 0; i < told.size(); ++i) {
    const Time now = trace.ticks[i].now;
    if (told[i] && now >= slip.begin && now <= slip.end + SlipTrace::kAftermath)
      return to_seconds(now - slip.begin);
  }
  return kNever;
}

std::vector<double> delays(const SlipScore& score, double lasted_s) {
  std::vector<double> all;
  for (const SlipOutcome& slip : score.slips) {
    if (slip.lasted_s >= lasted_s) all.push_back(slip.delay_s);
  }
  return all;
}

}  // namespace

void SlipTrace::see_truth(Time now, bool slipping) {
  if (!slipping) return;
  if (slips.empty() || now - slips.back().end > kJoin) slips.push_back({now, now});
  slips.back().end = now;
}

std::vector<SlipSpan> SlipTrace::fresh_slips() const {
  std::vector<SlipSpan> fresh;
  Time quiet_from = begin + kAftermath;
  for (const SlipSpan& slip : slips) {
    if (slip.begin >= quiet_from) fresh.push_back(slip);
    quiet_from = slip.end + kAftermath;
  }
  return fresh;
}

double SlipScore::share_told_within(double seconds) const {
  const std::vector<double> all = delays(*this, seconds);
  const auto told = std::count_if(all.begin(), all.end(), [&](double delay) { return delay <= seconds; });
  return all.empty() ? 0.0 : static_cast<double>(told) / static_cast<double>(all.size());
}

int SlipScore::lasted(double seconds) const { return static_cast<int>(delays(*this, seconds).size()); }

double SlipScore::delay_s(double part, double lasted_s) const {
  return quantile_of(delays(*this, lasted_s), part);
}

void score_slip(const SlipWatchParams& params, double current_rate_hz, double track_width_m,
                const SlipTrace& trace, SlipScore& score) {
  const std::vector<bool> told = watch(params, current_rate_hz, track_width_m, trace);
  for (const SlipSpan& slip : trace.fresh_slips()) {
    score.slips.push_back({to_seconds(slip.end - slip.begin), delay_of(slip, trace, told)});
  }
  for (std::size_t i = 1; i < told.size(); ++i) {
    if (told[i] && !told[i - 1] && in_quiet(trace, trace.ticks[i].now)) ++score.false_alarms;
  }
  score.quiet_h += quiet_hours(trace);
}

int count_detections(const MotorRecording& recording, double rate_hz, const SlipDetectorParams& params) {
  SlipDetector detector(params, rate_hz);
  int detections = 0, samples = 0;
  bool slipped = false;
  for (const MotorSample& sample : recording.samples) {
    const Time now = from_seconds(samples++ / rate_hz);
    detector.add_current(Wheel::left, now, sample.left_a);
    detector.add_current(Wheel::right, now, sample.right_a);
    const double unknown_mps = recording.has_speeds ? 0.0 : params.min_speed_mps;
    const double left_mps = sample.left_mps + unknown_mps, right_mps = sample.right_mps + unknown_mps;
    const bool slips = detector.update(now, {{{left_mps, left_mps}, {right_mps, right_mps}}}).slipping;
    if (slips && !slipped) ++detections;
    slipped = slips;
  }
  return detections;
}

}  // namespace hindsight::tools
